// Builds the haptic structures of a session, each once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/mesh_report.hpp"
#include "core/haptic/haptic_structure.hpp"

namespace abstand {

/// Bodies with the same geometry and options share one structure. First request() them all, then build(),
/// which spreads the work over the cores; get() by the number that request() gave.
class StructureLibrary {
 public:
  using Key = std::size_t;
  Key request(const Shape& shape, const HapticOptions& options);
  /// Reads the mesh at once. Throws ParseError for a file that is no mesh.
  Key request(const std::filesystem::path& mesh, double scale, const HapticOptions& options);

  void build(int threads = 0);
  std::shared_ptr<const HapticStructure> get(Key key) const { return entries_[key].structure; }
  double buildMs() const { return build_ms_; }
  /// Remarks about the meshes, "FILE: text".
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Entry {
    std::string name;
    std::shared_ptr<const Surface> surface;
    HapticOptions options;
    std::shared_ptr<const HapticStructure> structure;
  };
  Key add(const std::string& identity, std::string name, std::shared_ptr<const Surface> surface,
          const HapticOptions& options);

  std::vector<Entry> entries_;
  std::map<std::string, Key> by_identity_;
  std::map<std::string, std::shared_ptr<const Surface>> surfaces_;
  std::vector<std::string> remarks_;
  double build_ms_{0.0};
};

}  // namespace abstand
