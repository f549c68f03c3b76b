#include "core/store/structure_cache.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"
#include "core/store/engine_fingerprint.hpp"
#include "core/store/structure_archive.hpp"

namespace abstand::store {
namespace fs = std::filesystem;
namespace {

constexpr std::array<char, 8> kMagic{'A', 'B', 'S', 'T', 'H', 'A', 'P', '\n'};
// Version of the file's own layout. The payload's layout is covered by the builders' fingerprint.
constexpr std::uint32_t kFormat = 1;
// Age of temporary files of killed processes, after which they are certainly not being written any more.
constexpr auto kLeftOver = std::chrono::hours(24);

/// Precedes the payload; the checksum of both follows it.
struct Header {
  char magic[8]{};
  std::uint32_t format{0};
  std::uint64_t engine{0};
  ContentKey key;
  std::uint64_t payload{0};  ///< bytes

  template <class Archive>
  void archive(Archive& ar) {
    ar(magic, format, engine, key.low, key.high, payload);
  }
};

Header headerOf(const ContentKey& key, std::uint64_t payload) {
  Header header{.format = kFormat, .engine = kEngineFingerprint, .key = key, .payload = payload};
  std::copy(kMagic.begin(), kMagic.end(), header.magic);
  return header;
}

constexpr std::string_view kStructureEnding = ".haptic", kSurfaceEnding = ".surface";
// For smaller meshes, building a surface is as fast as reading it.
constexpr std::size_t kLargeMesh = 1000;

/// The writer's archive() takes non-const fields but does not change them.
template <class T>
void writeField(ArchiveWriter& writer, const T& value) {
  writer(const_cast<T&>(value));
}

template <class T>
void readArchive(std::istream& in, std::uintmax_t size, const ContentKey& key, T& value) {
  ArchiveReader reader(in, size);
  Header header;
  reader(header);
  if (!std::equal(kMagic.begin(), kMagic.end(), header.magic)) throw ArchiveError("is no file of the cache");
  if (header.format != kFormat || header.engine != kEngineFingerprint)
    throw ArchiveError("is of another version");
  if (header.key != key) throw ArchiveError("has content that does not match its name");
  if (header.payload + sizeof(ContentKey) != reader.left())
    throw ArchiveError("has another length than its header states");
  reader(value);
  const ContentKey checksum = reader.checksum();
  ContentKey stored;
  reader(stored.low, stored.high);
  if (reader.left() != 0 || stored != checksum) throw ArchiveError("is damaged");
}

void add(ContentHash& hash, const geometry::TriangleMesh& mesh) {
  hash.add(std::uint64_t{mesh.vertices.size()});
  hash.add(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vector3d));
  hash.add(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
}

struct CachedFile {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t bytes;
};

}  // namespace

ContentKey structureKey(const geometry::Surface& surface, const structure::HapticOptions& options) {
  ContentHash hash;
  hash.add(std::uint64_t{kEngineFingerprint});
  hash.add(options.voxel_size);
  hash.add(options.point_spacing);
  hash.add(options.outer_layers);
  hash.add(options.field);
  const geometry::Shape* shape = surface.shape();
  hash.add(std::uint64_t{shape != nullptr ? 1 + shape->index() : 0});
  if (shape != nullptr) {
    std::visit([&](const auto& s) { hash.add(&s, sizeof s); }, *shape);
  } else {
    add(hash, surface.mesh(0.0));
  }
  return hash.value();
}

ContentKey surfaceKey(const geometry::TriangleMesh& mesh) {
  ContentHash hash;
  hash.add(std::uint64_t{kEngineFingerprint});
  add(hash, mesh);
  return hash.value();
}

fs::path userCacheFolder() {
  const auto variable = [](const char* name) -> std::string_view {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  if (const auto own = variable("ABSTAND_CACHE"); !own.empty())
    return own == "off" ? fs::path() : fs::path(own);
  // Relative paths are ignored (XDG base directory specification).
  if (const fs::path base = variable("XDG_CACHE_HOME"); base.is_absolute()) return base / "abstand";
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "abstand";
  return {};
}

fs::path StructureCache::structureFile(const ContentKey& key) const {
  return folder_ / (key.hex() + std::string(kStructureEnding));
}

fs::path StructureCache::surfaceFile(const ContentKey& key) const {
  return folder_ / (key.hex() + std::string(kSurfaceEnding));
}

template <class T>
bool StructureCache::read(const fs::path& path, const ContentKey& key, T& value) {
  std::error_code ec;
  const std::uintmax_t size = fs::file_size(path, ec);
  if (ec) return false;
  std::ifstream in(path, std::ios::binary);
  if (!in) return false;  // removed in the meantime
  try {
    readArchive(in, size, key, value);
  } catch (const ArchiveError& e) {
    warn(path.string() + " " + e.what() + "; it is made anew");
    return false;
  }
  fs::last_write_time(path, fs::file_time_type::clock::now(), ec);
  return true;
}

template <class T>
void StructureCache::write(const fs::path& path, const ContentKey& key, const T& value) {
  try {
    if (fs::create_directories(folder_)) fs::permissions(folder_, fs::perms::owner_all);
    ArchiveWriter counter(nullptr);
    writeField(counter, value);
    OutputFile out(path);
    ArchiveWriter writer(&out.stream());
    writeField(writer, headerOf(key, counter.size()));
    writeField(writer, value);
    ContentKey checksum = writer.checksum();
    writer(checksum.low, checksum.high);
    out.commit();
    removeOldFiles();
  } catch (const UsageError& e) {
    warn(std::string("the cache does not keep ") + e.what());
  } catch (const WriteError& e) {
    warn(std::string("the cache does not keep ") + e.what());
  } catch (const fs::filesystem_error& e) {
    warn(std::string("the cache does not work: ") + e.what());
  }
}

std::shared_ptr<const structure::HapticStructure> StructureCache::findStructure(
    const ContentKey& key, std::string name, std::shared_ptr<const geometry::Surface> surface) {
  auto structure = std::make_shared<structure::HapticStructure>();
  if (!on() || !read(structureFile(key), key, *structure)) return nullptr;
  structure->name = std::move(name);
  structure->surface = std::move(surface);
  if (structure->surface) structure->support.setShape(*structure->surface);
  return structure;
}

std::shared_ptr<const geometry::Surface> StructureCache::findSurface(const ContentKey& key) {
  auto surface = std::make_shared<geometry::MeshSurface>();
  return on() && read(surfaceFile(key), key, *surface) ? surface : nullptr;
}

void StructureCache::store(const ContentKey& key, const structure::HapticStructure& structure) {
  if (on()) write(structureFile(key), key, structure);
}

void StructureCache::store(const ContentKey& key, const geometry::MeshSurface& surface) {
  if (on()) write(surfaceFile(key), key, surface);
}

void StructureCache::removeOldFiles() {
  std::vector<CachedFile> files;
  std::uintmax_t bytes = 0;
  std::error_code ec;
  const auto now = fs::file_time_type::clock::now();
  // Other processes may remove files in the meantime.
  for (fs::directory_iterator it(folder_, ec), end; !ec && it != end; it.increment(ec)) {
    std::error_code missing;
    const CachedFile file{it->path(), it->last_write_time(missing), it->file_size(missing)};
    if (missing) continue;
    const std::string name = file.path.filename().string();
    if (name.ends_with(kStructureEnding) || name.ends_with(kSurfaceEnding)) {
      files.push_back(file);
      bytes += file.bytes;
    } else if (name.find(".part") != std::string::npos && now - file.used > kLeftOver) {
      fs::remove(file.path, missing);
    }
  }
  if (bytes <= max_bytes_) return;
  std::sort(files.begin(), files.end(),
            [](const CachedFile& l, const CachedFile& r) { return l.used < r.used; });
  for (std::size_t i = 0; i < files.size() && bytes > max_bytes_; ++i) {
    fs::remove(files[i].path, ec);
    bytes -= files[i].bytes;
  }
}

void StructureCache::warn(std::string text) {
  const std::scoped_lock lock(mutex_);
  warnings_.push_back(std::move(text));
}

std::vector<std::string> StructureCache::takeWarnings() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(warnings_, {});
}

std::shared_ptr<const geometry::Surface> makeSurface(StructureCache& cache, geometry::TriangleMesh mesh) {
  if (!cache.on() || mesh.triangles.size() < kLargeMesh) return geometry::makeSurface(std::move(mesh));
  const ContentKey key = surfaceKey(mesh);
  if (auto found = cache.findSurface(key)) return found;
  auto made = std::make_shared<geometry::MeshSurface>(std::move(mesh));
  cache.store(key, *made);
  return made;
}

MadeStructure makeHapticStructure(StructureCache& cache, std::string name,
                                  std::shared_ptr<const geometry::Surface> surface,
                                  const structure::HapticOptions& options, int threads,
                                  const structure::BuildMonitor& monitor) {
  const auto start = std::chrono::steady_clock::now();
  options.validate();
  if (monitor.cancelled && monitor.cancelled()) throw structure::BuildCancelled();
  MadeStructure made;
  ContentKey key;
  if (cache.on()) {
    key = structureKey(*surface, options);
    made.structure = cache.findStructure(key, name, surface);
    made.cached = made.structure != nullptr;
  }
  if (!made.cached) {
    made.structure =
        structure::buildHapticStructure(std::move(name), std::move(surface), options, threads, monitor);
    cache.store(key, *made.structure);
  } else if (monitor.progress) {
    monitor.progress(1.0, "cache");
  }
  made.made_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return made;
}

}  // namespace abstand::store
