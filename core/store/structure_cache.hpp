// Disk cache of haptic structures and of surfaces of large meshes.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/geometry/mesh_surface.hpp"
#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// Hash of everything that a structure is built from: the surface's triangles or shape, the options, and the
/// builders (a fingerprint of their source, taken at compile time), so that a changed engine never uses
/// structures of an older one.
ContentKey structureKey(const geometry::Surface& surface, const structure::HapticOptions& options);

/// Hash of the surface of a welded mesh, in the same way.
ContentKey surfaceKey(const geometry::TriangleMesh& mesh);

/// $ABSTAND_CACHE, otherwise $XDG_CACHE_HOME/abstand, otherwise ~/.cache/abstand. Empty if ABSTAND_CACHE is
/// "off" or none of them is set. The folder need not exist.
std::filesystem::path userCacheFolder();

/// A folder of structures and surfaces, one file each, named by key. Files are written under a temporary name
/// and renamed, so that any number of threads and processes may share a folder. Sizes, version and a checksum
/// are verified before anything of a file is used; a file that is damaged, truncated, foreign or of another
/// version counts as absent and causes a warning. The checksum protects against accidents only: the folder
/// belongs to the user and is created without write access for others. No function throws for problems with
/// the folder. Any thread.
class StructureCache {
 public:
  /// Limit of all files together; the least recently used are removed first.
  static constexpr std::uintmax_t kMaxBytes = 2'000'000'000;

  /// An empty folder name disables the cache.
  explicit StructureCache(std::filesystem::path folder, std::uintmax_t max_bytes = kMaxBytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  bool on() const { return !folder_.empty(); }
  std::filesystem::path structureFile(const ContentKey& key) const;
  std::filesystem::path surfaceFile(const ContentKey& key) const;

  /// Null if it is absent or unusable. `surface` is the one of the key.
  std::shared_ptr<const structure::HapticStructure> findStructure(
      const ContentKey& key, std::string name, std::shared_ptr<const geometry::Surface> surface);
  void store(const ContentKey& key, const structure::HapticStructure& structure);
  std::shared_ptr<const geometry::Surface> findSurface(const ContentKey& key);
  void store(const ContentKey& key, const geometry::MeshSurface& surface);

  /// Problems since the last call, one line each.
  std::vector<std::string> takeWarnings();

 private:
  template <class T>
  bool read(const std::filesystem::path& file, const ContentKey& key, T& value);
  template <class T>
  void write(const std::filesystem::path& file, const ContentKey& key, const T& value);
  void warn(std::string text);
  void removeOldFiles();

  std::filesystem::path folder_;
  std::uintmax_t max_bytes_;
  std::mutex mutex_;  ///< protects the warnings
  std::vector<std::string> warnings_;
};

/// Finds the surface of a welded mesh in the cache, or builds it, and stores it if it was slow to build.
/// Throws UsageError like makeSurface(TriangleMesh).
std::shared_ptr<const geometry::Surface> makeSurface(StructureCache& cache, geometry::TriangleMesh mesh);

/// A structure and its origin.
struct MadeStructure {
  std::shared_ptr<const structure::HapticStructure> structure;
  bool cached{false};
  double made_ms{0.0};  ///< time to find it, or to build and store it; structure->build_ms is that of
                        ///< building alone
};

/// Finds a structure in the cache, or builds and stores it. Throws like buildHapticStructure.
MadeStructure makeHapticStructure(StructureCache& cache, std::string name,
                                  std::shared_ptr<const geometry::Surface> surface,
                                  const structure::HapticOptions& options, int threads = 0,
                                  const structure::BuildMonitor& monitor = {});

}  // namespace abstand::store
