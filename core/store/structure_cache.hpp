// Haptic structures, and the surfaces of large meshes, kept on disk from one run to the next.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/geometry/mesh_surface.hpp"
#include "core/structure/haptic_structure.hpp"

namespace abstand::store {

/// Names everything that a structure is made from: the surface's triangles or shape, the options, and the
/// builders themselves (a fingerprint of their source, taken when the program was built), so that a changed
/// engine never meets structures of an older one.
ContentKey structureKey(const geometry::Surface& surface, const structure::HapticOptions& options);

/// Names the surface of a welded mesh likewise.
ContentKey surfaceKey(const geometry::TriangleMesh& mesh);

/// $ABSTAND_CACHE, else $XDG_CACHE_HOME/abstand, else ~/.cache/abstand. Empty when ABSTAND_CACHE is "off", or
/// when there is no such place. The folder need not exist.
std::filesystem::path userCacheFolder();

/// A folder of structures and surfaces, one file each, named by key. Files are written beside their name and
/// renamed, so that any number of threads and processes may share a folder. A file that is damaged, cut
/// short, foreign or of another version is noticed by sizes, versions and a checksum over all of it before
/// anything of it is used, and counts as absent; a warning says so. The checksum is against accidents: the
/// folder is the user's own, and is made so that nobody else can write into it. No function throws for what
/// is wrong with the folder. Any thread.
class StructureCache {
 public:
  /// Of all files; the ones that were not used for longest go first.
  static constexpr std::uintmax_t kMaxBytes = 2'000'000'000;

  /// An empty folder keeps nothing.
  explicit StructureCache(std::filesystem::path folder, std::uintmax_t max_bytes = kMaxBytes)
      : folder_(std::move(folder)), max_bytes_(max_bytes) {}

  bool on() const { return !folder_.empty(); }
  std::filesystem::path structureFile(const ContentKey& key) const;
  std::filesystem::path surfaceFile(const ContentKey& key) const;

  /// Null when it is not there, or not usable. `surface` is the one of the key.
  std::shared_ptr<const structure::HapticStructure> findStructure(
      const ContentKey& key, std::string name, std::shared_ptr<const geometry::Surface> surface);
  void keep(const ContentKey& key, const structure::HapticStructure& structure);
  std::shared_ptr<const geometry::Surface> findSurface(const ContentKey& key);
  void keep(const ContentKey& key, const geometry::MeshSurface& surface);

  /// What went wrong since the last call, one line each.
  std::vector<std::string> takeWarnings();

 private:
  template <class T>
  bool read(const std::filesystem::path& file, const ContentKey& key, T& value);
  template <class T>
  void write(const std::filesystem::path& file, const ContentKey& key, const T& value);
  void warn(std::string text);
  void makeRoom();

  std::filesystem::path folder_;
  std::uintmax_t max_bytes_;
  std::mutex mutex_;  ///< of the warnings
  std::vector<std::string> warnings_;
};

/// Finds the surface of a welded mesh in the cache, or makes it, and keeps it when it was slow to make.
/// Throws UsageError like makeSurface(TriangleMesh).
std::shared_ptr<const geometry::Surface> makeSurface(StructureCache& cache, geometry::TriangleMesh mesh);

/// A structure, and where it came from.
struct MadeStructure {
  std::shared_ptr<const structure::HapticStructure> structure;
  bool cached{false};
  double made_ms{0.0};  ///< to find it or to build and keep it; structure->build_ms is the building alone
};

/// Finds a structure in the cache, or builds and keeps it. Throws like buildHapticStructure.
MadeStructure makeHapticStructure(StructureCache& cache, std::string name,
                                  std::shared_ptr<const geometry::Surface> surface,
                                  const structure::HapticOptions& options, int threads = 0,
                                  const structure::BuildMonitor& monitor = {});

}  // namespace abstand::store
