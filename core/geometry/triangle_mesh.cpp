// Bounds, area and welding of triangle meshes.
#include "core/geometry/triangle_mesh.hpp"

#include <bit>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::geometry {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// Finds the vertices kept so far near a point: a hash grid whose cells are at least twice the
/// tolerance wide, so that 8 cells hold everything within the tolerance. Kept vertices are at least the
/// tolerance apart, so a cell holds few of them and welding takes linear time.
class MergedVertices {
 public:
  MergedVertices(std::size_t max_count, double tolerance)
      : tolerance_(tolerance), heads_(std::bit_ceil(max_count + 1), kNone), next_() {
    next_.reserve(max_count);
  }

  /// Index of the kept vertex within the tolerance of p; if there is none, p is kept as a new one.
  std::uint32_t findOrInsert(const Vector3d& p) {
    Vector3d cell = p;
    Vector3d side = Vector3d::Zero();
    if (tolerance_ > 0.0) {
      for (int i = 0; i < 3; ++i) {
        const double t = p[i] / (2.0 * tolerance_);
        cell[i] = std::floor(t);
        side[i] = t - cell[i] < 0.5 ? -1.0 : 1.0;
      }
    }
    for (int corner = 0; corner < (tolerance_ > 0.0 ? 8 : 1); ++corner) {
      const Vector3d c = cell + Vector3d(corner & 1 ? side.x() : 0.0, corner & 2 ? side.y() : 0.0,
                                         corner & 4 ? side.z() : 0.0);
      for (std::uint32_t v = heads_[slot(c)]; v != kNone; v = next_[v]) {
        if ((points_[v] - p).squaredNorm() <= tolerance_ * tolerance_) return v;
      }
    }
    const auto kept = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
    auto& head = heads_[slot(cell)];
    next_.push_back(head);
    head = kept;
    return kept;
  }

  const std::vector<Vector3d>& points() const { return points_; }

 private:
  std::size_t slot(const Vector3d& cell) const {
    std::uint64_t h = 0;
    for (int i = 0; i < 3; ++i) {
      // 0.0 is added so that -0 and 0 fall into the same slot
      h = (h ^ std::bit_cast<std::uint64_t>(cell[i] + 0.0)) * 0x9e3779b97f4a7c15ull;
      h ^= h >> 29;
    }
    return h & (heads_.size() - 1);
  }

  double tolerance_;
  std::vector<std::uint32_t> heads_;
  std::vector<std::uint32_t> next_;
  std::vector<Vector3d> points_;
};

}  // namespace

Bounds bounds(const TriangleMesh& mesh) {
  Bounds b;
  for (const auto& p : mesh.vertices) b.add(p);
  return b;
}

void stretch(TriangleMesh& mesh, const Vector3d& scale) {
  for (auto& v : mesh.vertices) v = v.cwiseProduct(scale);
  if (scale.prod() > 0.0) return;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}

double surfaceArea(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d& a = mesh.corner(t, 0);
    twice += (mesh.corner(t, 1) - a).cross(mesh.corner(t, 2) - a).norm();
  }
  return 0.5 * twice;
}

TriangleMesh weld(const TriangleMesh& mesh, double tolerance) {
  ABSTAND_CHECK(tolerance >= 0.0 && mesh.vertices.size() < kNone);
  MergedVertices kept(mesh.vertices.size(), tolerance);
  std::vector<std::uint32_t> stand_in(mesh.vertices.size(), kNone);
  TriangleMesh out;
  out.triangles.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    std::array<std::uint32_t, 3> t{};
    for (int i = 0; i < 3; ++i) {
      ABSTAND_CHECK(triangle[i] < mesh.vertices.size());
      auto& s = stand_in[triangle[i]];
      if (s == kNone) s = kept.findOrInsert(mesh.vertices[triangle[i]]);
      t[i] = s;
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.triangles.push_back(t);
  }
  // Vertices that only degenerate triangles used are dropped, like unused ones.
  std::vector<std::uint32_t> place(kept.points().size(), kNone);
  for (auto& triangle : out.triangles) {
    for (auto& v : triangle) {
      if (place[v] == kNone) {
        place[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(kept.points()[v]);
      }
      v = place[v];
    }
  }
  return out;
}

}  // namespace abstand::geometry
