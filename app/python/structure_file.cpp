// docs/python.md, "Files of structures", says what is in them.
#include "app/python/structure_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/text_file.hpp"
#include "core/geometry/mesh_surface.hpp"
#include "core/store/engine_fingerprint.hpp"
#include "core/store/structure_archive.hpp"

namespace abstand::python {
namespace {

using store::ArchiveError;

constexpr std::array<char, 8> kMagic{'A', 'B', 'S', 'T', 'S', 'T', 'R', '\n'};
constexpr std::uint32_t kFormat = 1;

/// Before the payload; after it comes the checksum of both.
struct Header {
  char magic[8]{};
  std::uint32_t format{0};
  std::uint64_t engine{0};
  std::uint64_t payload{0};  ///< bytes

  template <class Archive>
  void archive(Archive& ar) {
    ar(magic, format, engine, payload);
  }
};

/// A shape as its number among the alternatives of geometry::Shape and up to three dimensions.
struct ShapeRecord {
  std::uint8_t kind{0};  ///< 0: a mesh
  double size[3]{};

  template <class Archive>
  void archive(Archive& ar) {
    ar(kind, size);
  }
};

struct ShapeToRecord {
  ShapeRecord operator()(const geometry::Sphere& s) const { return {1, {s.radius, 0, 0}}; }
  ShapeRecord operator()(const geometry::Ellipsoid& s) const { return of(2, s.semi_axes); }
  ShapeRecord operator()(const geometry::Cuboid& s) const { return of(3, s.size); }
  ShapeRecord operator()(const geometry::Cylinder& s) const { return {4, {s.radius, s.length, 0}}; }
  ShapeRecord operator()(const geometry::Capsule& s) const { return {5, {s.radius, s.length, 0}}; }
  static ShapeRecord of(std::uint8_t kind, const Vector3d& v) { return {kind, {v.x(), v.y(), v.z()}}; }
};

geometry::Shape shapeOf(const ShapeRecord& r) {
  const Vector3d v(r.size[0], r.size[1], r.size[2]);
  switch (r.kind) {
    case 1:
      return geometry::Sphere{v.x()};
    case 2:
      return geometry::Ellipsoid{v};
    case 3:
      return geometry::Cuboid{v};
    case 4:
      return geometry::Cylinder{v.x(), v.y()};
    case 5:
      return geometry::Capsule{v.x(), v.y()};
    default:
      throw ArchiveError("has a surface of an unknown kind");
  }
}

/// Writing takes fields that it does not change.
void putStructure(store::ArchiveWriter& writer, const structure::HapticStructure& constant) {
  auto& structure = const_cast<structure::HapticStructure&>(constant);
  writer(structure.name);
  const geometry::Shape* shape = structure.surface->shape();
  ShapeRecord record = shape ? std::visit(ShapeToRecord{}, *shape) : ShapeRecord{};
  writer(record);
  if (!shape) {
    const auto* mesh = dynamic_cast<const geometry::MeshSurface*>(structure.surface.get());
    ABSTAND_CHECK(mesh != nullptr);
    writer(const_cast<geometry::MeshSurface&>(*mesh));
  }
  writer(structure);
}

std::shared_ptr<const structure::HapticStructure> takeStructure(std::istream& in, std::uintmax_t size) {
  store::ArchiveReader reader(in, size);
  Header header;
  reader(header);
  if (!std::equal(kMagic.begin(), kMagic.end(), header.magic)) throw ArchiveError("is no saved structure");
  if (header.format != kFormat || header.engine != kEngineFingerprint)
    throw ArchiveError("was saved by another version of the engine; build the structure again");
  if (header.payload + sizeof(ContentKey) != reader.left()) throw ArchiveError("is not as long as it says");
  auto structure = std::make_shared<structure::HapticStructure>();
  reader(structure->name);
  ShapeRecord record;
  reader(record);
  if (record.kind == 0) {
    auto mesh = std::make_shared<geometry::MeshSurface>();
    reader(*mesh);
    structure->surface = std::move(mesh);
  } else {
    structure->surface = geometry::makeSurface(shapeOf(record));
  }
  reader(*structure);
  const ContentKey checksum = reader.checksum();
  ContentKey stored;
  reader(stored.low, stored.high);
  if (reader.left() != 0 || stored != checksum) throw ArchiveError("is damaged");
  structure->support.setShape(*structure->surface);
  return structure;
}

}  // namespace

void saveStructure(const structure::HapticStructure& structure, const std::filesystem::path& file) {
  store::ArchiveWriter counter(nullptr);
  putStructure(counter, structure);
  Header header{.format = kFormat, .engine = kEngineFingerprint, .payload = counter.size()};
  std::copy(kMagic.begin(), kMagic.end(), header.magic);
  OutputFile out(file);
  store::ArchiveWriter writer(&out.stream());
  writer(header);
  putStructure(writer, structure);
  ContentKey checksum = writer.checksum();
  writer(checksum.low, checksum.high);
  out.commit();
}

std::shared_ptr<const structure::HapticStructure> loadStructure(const std::filesystem::path& file) {
  needRegularFile(file);
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ParseError({file.string()}, "cannot be read");
  try {
    return takeStructure(in, std::filesystem::file_size(file));
  } catch (const ArchiveError& e) {
    throw ParseError({file.string()}, std::string("the file ") + e.what());
  } catch (const UsageError& e) {
    throw ParseError({file.string()}, e.what());
  }
}

}  // namespace abstand::python
