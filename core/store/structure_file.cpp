#include "core/store/structure_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <string_view>

#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/output_file.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/store/engine_fingerprint.hpp"
#include "core/store/structure_archive.hpp"

namespace abstand::store {
namespace {

using Tag = std::array<char, 4>;

constexpr std::array<char, 8> kFileMagic{'A', 'B', 'S', 'T', 'S', 'T', 'R', '\n'};
constexpr std::uint32_t kFileVersion = 1;
constexpr Tag kBodyTag{'B', 'O', 'D', 'Y'}, kOptionsTag{'O', 'P', 'T', 'S'}, kPointsTag{'P', 'N', 'T', 'S'},
    kVoxelsTag{'V', 'O', 'X', 'L'}, kEngineTag{'E', 'N', 'G', 'N'}, kEndTag{'E', 'N', 'D', ' '};
constexpr std::size_t kMaxNameBytes = 1000;

struct FileHead {
  char magic[8]{};
  std::uint32_t version{kFileVersion};
  template <class Archive>
  void archive(Archive& ar) {
    ar(magic, version);
  }
};

struct SectionHead {
  Tag tag{};
  std::uint64_t bytes{0};
  template <class Archive>
  void archive(Archive& ar) {
    for (char& c : tag) ar(c);
    ar(bytes);
  }
};

/// BODY: `kind` 0 is a mesh; 1 + index in geometry::Shape otherwise.
struct BodySection {
  std::string name;
  std::uint8_t kind{0};
  Vector3d sizes{Vector3d::Zero()};
  std::vector<Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  template <class Archive>
  void archive(Archive& ar) {
    ar(name, kind);
    if (kind == 0)
      ar(vertices, triangles);
    else
      ar(sizes);
  }
};

struct OptionsSection {
  double voxel{0.0}, point{0.0};
  std::int32_t layers{0}, field{0};
  template <class Archive>
  void archive(Archive& ar) {
    ar(voxel, point, layers, field);
  }
};

/// Layers of a voxelmap, run-length encoded, x fastest, then y, then z.
struct VoxelSection {
  Vector3d first_centre{Vector3d::Zero()};
  double voxel{0.0};
  Vector3i size{Vector3i::Zero()};
  std::vector<std::int16_t> layers;
  std::vector<std::uint32_t> lengths;
  template <class Archive>
  void archive(Archive& ar) {
    ar(first_centre, voxel, size, layers, lengths);
  }
};

/// Memory image of the engine.
struct EngineSection {
  std::uint64_t fingerprint{kEngineFingerprint};
  bool mesh{false};
  std::shared_ptr<geometry::MeshSurface> surface;
  std::shared_ptr<structure::HapticStructure> structure;
  template <class Archive>
  void archive(Archive& ar) {
    ar(fingerprint, mesh);
    if (mesh) ar(*surface);
    ar(*structure);
  }
};

BodySection bodyOf(const structure::HapticStructure& s) {
  BodySection body;
  body.name = s.name.substr(0, kMaxNameBytes);
  const geometry::Shape* shape = s.surface->shape();
  if (!shape) {
    geometry::TriangleMesh mesh = s.surface->mesh(0.0);
    body.vertices = std::move(mesh.vertices);
    body.triangles = std::move(mesh.triangles);
    return body;
  }
  body.kind = static_cast<std::uint8_t>(1 + shape->index());
  body.sizes = geometry::dimensionsOf(*shape);
  return body;
}

std::shared_ptr<const geometry::Surface> surfaceOf(BodySection body) {
  if (body.kind != 0) {
    const auto shape = geometry::shapeOf(body.kind - 1u, body.sizes);
    if (!shape) throw ArchiveError("holds a body of an unknown kind");
    return geometry::makeSurface(*shape);
  }
  for (const Vector3d& p : body.vertices)
    if (!(p.cwiseAbs().maxCoeff() <= mesh_file::kFarthestVertex))
      throw ArchiveError("holds a vertex that is not finite or beyond 1e6 m");
  return geometry::makeSurface(geometry::TriangleMesh{std::move(body.vertices), std::move(body.triangles)});
}

structure::HapticOptions optionsOf(const OptionsSection& o) {
  if (o.field < 0 || o.field > 2) throw ArchiveError("holds an unknown kind of field");
  structure::HapticOptions options{.voxel_size = o.voxel,
                                   .point_spacing = o.point,
                                   .outer_layers = o.layers,
                                   .field = static_cast<structure::FieldKind>(o.field)};
  options.validate();
  return options;
}

VoxelSection voxelsOf(const field::Voxelmap& map) {
  VoxelSection v{map.grid.first_centre, map.grid.voxel_size, map.grid.size, {}, {}};
  Vector3i at;
  for (at.z() = 0; at.z() < v.size.z(); ++at.z())
    for (at.y() = 0; at.y() < v.size.y(); ++at.y())
      for (at.x() = 0; at.x() < v.size.x(); ++at.x()) {
        const auto layer = static_cast<std::int16_t>(std::clamp(map.at(at), -32768, 32767));
        if (v.layers.empty() || v.layers.back() != layer || v.lengths.back() == 0xffffffffu) {
          v.layers.push_back(layer);
          v.lengths.push_back(0);
        }
        ++v.lengths.back();
      }
  return v;
}

template <class Section>
void writeSection(ArchiveWriter& writer, const Tag& tag, Section& section) {
  ArchiveWriter counter(nullptr);
  counter(section);
  SectionHead head{tag, counter.size()};
  writer(head, section);
}

/// Reads a section and checks its length.
template <class Section>
void readSection(ArchiveReader& reader, const SectionHead& head, Section& section) {
  const std::uint64_t before = reader.left();
  reader(section);
  if (before - reader.left() != head.bytes)
    throw ArchiveError("holds a section whose length differs from the stated one");
}

void passOver(ArchiveReader& reader, std::uint64_t bytes) {
  char buffer[16384];
  while (bytes > 0) {
    const std::size_t part = std::min<std::uint64_t>(bytes, sizeof buffer);
    reader.bytes(buffer, part);
    bytes -= part;
  }
}

/// Data read, not yet validated.
struct Content {
  std::optional<BodySection> body;
  std::optional<OptionsSection> options;
  EngineSection engine;
};

/// `with_engine`: also the memory image, if the engine version is the same.
Content readContent(std::istream& in, std::uint64_t size, bool with_engine) {
  ArchiveReader reader(in, size);
  Content content;
  FileHead file;
  reader(file);
  if (!std::equal(kFileMagic.begin(), kFileMagic.end(), file.magic))
    throw ArchiveError("is no structure file");
  if (file.version != kFileVersion)
    throw ArchiveError("is of format version " + std::to_string(file.version) + ", expected 1");
  for (SectionHead head;;) {
    reader(head);
    if (head.bytes > reader.left()) throw ArchiveError("is shorter than stated in it");
    if (head.tag == kEndTag) break;
    if (head.tag == kBodyTag) {
      readSection(reader, head, content.body.emplace());
    } else if (head.tag == kOptionsTag) {
      readSection(reader, head, content.options.emplace());
    } else if (head.tag == kEngineTag && with_engine) {
      std::uint64_t rest = head.bytes;
      reader(content.engine.fingerprint);
      if (rest < sizeof content.engine.fingerprint) throw ArchiveError("holds a section that is too short");
      rest -= sizeof content.engine.fingerprint;
      if (content.engine.fingerprint != kEngineFingerprint) {
        passOver(reader, rest);
        continue;
      }
      const std::uint64_t before = reader.left();
      content.engine.surface = std::make_shared<geometry::MeshSurface>();
      content.engine.structure = std::make_shared<structure::HapticStructure>();
      reader(content.engine.mesh);
      if (content.engine.mesh) reader(*content.engine.surface);
      reader(*content.engine.structure);
      if (before - reader.left() != rest)
        throw ArchiveError("holds a section whose length differs from the stated one");
    } else {
      passOver(reader, head.bytes);
    }
  }
  const ContentKey checksum = reader.checksum();
  ContentKey stored;
  reader(stored.low, stored.high);
  if (reader.left() != 0 || stored != checksum) throw ArchiveError("is damaged");
  if (!content.body || !content.options) throw ArchiveError("holds no body, or no options");
  return content;
}

/// Converts errors into a one-line message about the file.
template <class Read>
auto readStream(std::istream& in, std::uint64_t size, const std::string& name, bool with_engine,
                const Read& read) {
  try {
    return read(readContent(in, size, with_engine));
  } catch (const ArchiveError& e) {
    throw ParseError({name}, std::string(e.what()) + ", expected a complete structure file",
                     "abstand build --out FOLDER writes them");
  } catch (const UsageError& e) {
    throw ParseError({name}, e.what());
  }
}

template <class Read>
auto readFrom(const std::filesystem::path& path, bool with_engine, const Read& read) {
  std::error_code ec;
  const std::uintmax_t size = std::filesystem::file_size(path, ec);
  std::ifstream in(path, std::ios::binary);
  if (ec || !in) throw ParseError({path.string()}, "cannot be read, expected a structure file");
  noteInput(path);
  return readStream(in, size, path.string(), with_engine, read);
}

StoredBody checkedBody(Content content) {
  StoredBody body;
  body.options = optionsOf(*content.options);
  body.name = content.body->name.substr(0, kMaxNameBytes);
  body.surface = surfaceOf(std::move(*content.body));
  return body;
}

}  // namespace

void saveStructure(const structure::HapticStructure& structure, const std::filesystem::path& path) {
  OutputFile out(path);
  ArchiveWriter writer(&out.stream());
  FileHead file;
  std::copy(kFileMagic.begin(), kFileMagic.end(), file.magic);
  writer(file);
  BodySection body = bodyOf(structure);
  writeSection(writer, kBodyTag, body);
  OptionsSection options{structure.options.voxel_size, structure.options.point_spacing,
                         structure.options.outer_layers, static_cast<std::int32_t>(structure.options.field)};
  writeSection(writer, kOptionsTag, options);
  shell::Pointshell points = structure.shell;
  writeSection(writer, kPointsTag, points);
  if (structure.voxelmap) {
    VoxelSection voxels = voxelsOf(*structure.voxelmap);
    writeSection(writer, kVoxelsTag, voxels);
  }
  // The writer's archive() takes non-const fields but does not change them.
  EngineSection engine;
  engine.structure = std::shared_ptr<structure::HapticStructure>(
      std::shared_ptr<void>(), const_cast<structure::HapticStructure*>(&structure));
  if (const auto* mesh = dynamic_cast<const geometry::MeshSurface*>(structure.surface.get())) {
    engine.mesh = true;
    engine.surface = std::shared_ptr<geometry::MeshSurface>(std::shared_ptr<void>(),
                                                            const_cast<geometry::MeshSurface*>(mesh));
  }
  writeSection(writer, kEngineTag, engine);
  SectionHead end{kEndTag, 0};
  writer(end);
  ContentKey checksum = writer.checksum();
  writer(checksum.low, checksum.high);
  out.commit();
}

StoredBody readStoredBody(const std::filesystem::path& path) { return readFrom(path, false, checkedBody); }

StoredBody parseStoredBody(std::string_view content, const std::string& name) {
  std::istringstream in{std::string(content)};
  return readStream(in, content.size(), name, false, checkedBody);
}

std::shared_ptr<const structure::HapticStructure> readStoredStructure(const std::filesystem::path& path) {
  return readFrom(path, true, [](Content content) -> std::shared_ptr<const structure::HapticStructure> {
    auto& structure = content.engine.structure;
    if (!structure) return nullptr;
    structure->name = content.body->name;
    if (content.engine.mesh)
      structure->surface = content.engine.surface;
    else
      structure->surface = surfaceOf(std::move(*content.body));
    structure->support.setShape(*structure->surface);
    return structure;
  });
}

std::shared_ptr<const structure::HapticStructure> loadStructure(const std::filesystem::path& path,
                                                                bool trusted, StructureCache& cache,
                                                                int threads) {
  if (trusted)
    if (auto structure = readStoredStructure(path)) return structure;
  const StoredBody body = readStoredBody(path);
  return makeHapticStructure(cache, body.name, body.surface, body.options, threads).structure;
}

}  // namespace abstand::store
