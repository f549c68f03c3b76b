// Builds the haptic structures of a session, each once.
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
  bool doubtful{false};  ///< distances to the mesh may be wrong: it is open, inverted or of an odd size
};

/// Bodies with the same geometry and options share one structure. First request() them all, then build(),
/// which spreads the work over the cores; get() by the number that request() gave.
class StructureLibrary {
 public:
  using Key = std::size_t;
  /// Structures are looked for and kept in the folder; empty: none.
  explicit StructureLibrary(std::filesystem::path cache_folder) : cache_(std::move(cache_folder)) {}

  Key request(const geometry::Shape& shape, const structure::HapticOptions& options);
  /// Reads the mesh at once; `scale`: metres per unit along its axes. Throws ParseError for a file that is no
  /// mesh.
  Key request(const std::filesystem::path& mesh, const Vector3d& scale,
              const structure::HapticOptions& options);

  /// A file of a structure, which says itself how fine it is; anybody's (structure_file.hpp). Reads the body
  /// at once. Throws ParseError.
  Key requestStored(const std::filesystem::path& file);
  /// One that is there already.
  Key take(std::shared_ptr<const structure::HapticStructure> made);

  /// On `threads` threads (0: all cores); the result does not depend on the number. Throws UsageError for a
  /// mesh without area and for options that do not fit a body, and BuildCancelled.
  void build(int threads = 0, const structure::BuildMonitor& monitor = {});
  std::shared_ptr<const structure::HapticStructure> get(Key key) const { return entries_[key].structure; }
  /// Wall time of build().
  double buildMs() const { return build_ms_; }
  /// How many structures the cache had, and how many are there.
  std::size_t cached() const { return cached_; }
  std::size_t size() const { return entries_.size(); }
  /// Remarks about the meshes, "FILE: text", and about the cache.
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Those about the meshes alone.
  const std::vector<MeshRemark>& meshRemarks() const { return mesh_remarks_; }

 private:
  struct Body {
    geometry::TriangleMesh mesh;  ///< until the surface is made
    std::shared_ptr<const geometry::Surface> surface;
    std::string doubt;  ///< that its unit may be another one; empty: none
  };
  struct Entry {
    std::string name;
    std::shared_ptr<Body> body;
    structure::HapticOptions options;
    std::shared_ptr<const structure::HapticStructure> structure;
    double work{0.0};  ///< grows with the time that building takes; no unit
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
