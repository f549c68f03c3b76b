// Builds the haptic structures of a session, each one once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh_file/mesh_report.hpp"
#include "core/store/structure_cache.hpp"

namespace abstand::session {

struct MeshRemark {
  std::string text;      ///< "FILE: ..."
  bool doubtful{false};  ///< distances to the mesh may be wrong: it is open, inverted or of an unusual size
};

/// Bodies with the same geometry and options share one structure. First request() all, then build(), which
/// distributes the work over the cores; then get() by the key of request().
class StructureLibrary {
 public:
  using Key = std::size_t;
  /// Uses the folder as a structure cache; empty: none.
  explicit StructureLibrary(std::filesystem::path cache_folder) : cache_(std::move(cache_folder)) {}

  Key request(const geometry::Shape& shape, const structure::HapticOptions& options);
  /// Reads the mesh immediately; `scale`: metres per unit along its axes. Throws ParseError for an invalid
  /// mesh file.
  Key request(const std::filesystem::path& mesh, const Vector3d& scale,
              const structure::HapticOptions& options);

  /// Requests the structure of an untrusted file that states its own resolution (structure_file.hpp). Reads
  /// the body immediately. Throws ParseError.
  Key requestStored(const std::filesystem::path& file);
  /// Adds an existing structure.
  Key take(std::shared_ptr<const structure::HapticStructure> made);

  /// Builds on `threads` threads (0: all cores); the result does not depend on their number. Throws
  /// UsageError for a mesh without area and for options that do not fit a body, and BuildCancelled.
  void build(int threads = 0, const structure::BuildMonitor& monitor = {});
  std::shared_ptr<const structure::HapticStructure> get(Key key) const { return entries_[key].structure; }
  /// Wall time of build() (ms).
  double buildMs() const { return build_ms_; }
  /// Number of structures from the cache, and total.
  std::size_t cached() const { return cached_; }
  std::size_t size() const { return entries_.size(); }
  /// Remarks about the meshes, "FILE: text", and about the cache.
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Remarks about the meshes only.
  const std::vector<MeshRemark>& meshRemarks() const { return mesh_remarks_; }

 private:
  struct Body {
    geometry::TriangleMesh mesh;  ///< until the surface is built
    std::shared_ptr<const geometry::Surface> surface;
    std::string doubt;  ///< remark that its unit may not be metres; empty: none
  };
  struct Entry {
    std::string name;
    std::shared_ptr<Body> body;
    structure::HapticOptions options;
    std::shared_ptr<const structure::HapticStructure> structure;
    double work{0.0};  ///< relative estimate of the build time
  };
  Key add(const std::string& identity, std::string name, std::shared_ptr<Body> body,
          const structure::HapticOptions& options);
  void makeSurfaces(int threads);

  store::StructureCache cache_;
  std::vector<Entry> entries_;
  std::map<std::string, Key> by_identity_;
  std::map<std::string, std::shared_ptr<Body>> bodies_;
  std::vector<std::string> remarks_;
  std::vector<MeshRemark> mesh_remarks_;
  double build_ms_{0.0};
  std::size_t cached_{0};
};

}  // namespace abstand::session
