// Welding and removal of degenerate triangles.
#include "core/mesh_file/mesh_file_clean.hpp"

#include <unordered_map>

namespace abstand::mesh_file {
namespace {

/// Each pass removes the flat triangles next to sound ones; a strip of n flat triangles takes up to n passes.
constexpr int kMaxPasses = 64;

/// Corner opposite to the longest side if the triangle's height over it is below `tolerance`; otherwise -1.
/// The side opposite to corner i runs from corner i + 1 to corner i + 2.
int flatCorner(const geometry::TriangleMesh& mesh, std::size_t t, double tolerance) {
  int over_longest = 0;
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double length = (mesh.corner(t, (i + 2) % 3) - mesh.corner(t, (i + 1) % 3)).norm();
    if (length > longest) {
      longest = length;
      over_longest = i;
    }
  }
  const Vector3d& a = mesh.corner(t, 0);
  const double twice_area = (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
  return twice_area <= tolerance * longest ? over_longest : -1;
}

std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

class Flattener {
 public:
  Flattener(geometry::TriangleMesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  /// Returns the number of flat triangles removed.
  std::size_t run() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (flatCorner(mesh_, t, tolerance_) >= 0) flat_.push_back(t);
    if (flat_.empty()) return 0;
    const std::size_t found = flat_.size();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) enter(t);
    for (int pass = 0; pass < kMaxPasses && pass_needed_; ++pass) runPass();
    dropFlat();
    return found;
  }

 private:
  void enter(std::uint32_t t) {
    for (int i = 0; i < 3; ++i) sides_[key(mesh_.triangles[t][i], mesh_.triangles[t][(i + 1) % 3])] = t;
  }

  void runPass() {
    pass_needed_ = false;
    const auto flat = std::move(flat_);
    flat_.clear();
    for (const auto t : flat) {
      if (!merge(t)) flat_.push_back(t);
    }
  }

  /// Splits the neighbour across the longest side of t at the opposite corner of t; both triangles are sound
  /// then. False if there is no such neighbour, or it is flat itself.
  bool merge(std::uint32_t t) {
    const int i = flatCorner(mesh_, t, tolerance_);
    if (i < 0) return true;  // repaired by an earlier split
    const auto middle = mesh_.triangles[t][i];
    const auto from = mesh_.triangles[t][(i + 1) % 3], to = mesh_.triangles[t][(i + 2) % 3];
    const auto found = sides_.find(key(to, from));
    if (found == sides_.end()) return false;
    const auto n = found->second;
    if (flatCorner(mesh_, n, tolerance_) >= 0) return false;
    std::uint32_t tip = middle;
    for (const auto v : mesh_.triangles[n])
      if (v != from && v != to) tip = v;
    if (tip == middle) return false;
    mesh_.triangles[n] = {to, middle, tip};
    mesh_.triangles[t] = {middle, from, tip};
    enter(n);
    enter(t);
    // A split near the tip leaves a flat triangle again, which the next pass removes.
    if (flatCorner(mesh_, n, tolerance_) >= 0) flat_.push_back(n);
    if (flatCorner(mesh_, t, tolerance_) >= 0) flat_.push_back(t);
    pass_needed_ = true;
    return true;
  }

  void dropFlat() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (flatCorner(mesh_, t, tolerance_) < 0) mesh_.triangles[kept++] = mesh_.triangles[t];
    mesh_.triangles.resize(kept);
  }

  geometry::TriangleMesh& mesh_;
  double tolerance_;
  std::vector<std::uint32_t> flat_;
  std::unordered_map<std::uint64_t, std::uint32_t> sides_;  ///< directed side -> its triangle
  bool pass_needed_{true};
};

}  // namespace

CleanMesh clean(const geometry::TriangleMesh& mesh, double tolerance) {
  CleanMesh out;
  out.mesh = geometry::weld(mesh, tolerance);
  out.degenerate = mesh.triangles.size() - out.mesh.triangles.size();
  const std::size_t flat = Flattener(out.mesh, tolerance).run();
  out.degenerate += flat;
  if (flat > 0) out.mesh = geometry::weld(out.mesh, 0.0);
  return out;
}

}  // namespace abstand::mesh_file
