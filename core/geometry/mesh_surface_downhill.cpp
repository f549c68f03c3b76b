// Local descent over adjacent triangles to the nearest point.
#include "core/geometry/mesh_surface_sides.hpp"

namespace abstand::geometry {
namespace {

constexpr int kSteps = 256;  // far beyond what bodies move between two queries
constexpr int kAround = 64;  // limit of triangles visited at a vertex

int indexOf(Feature feature, Feature first) { return static_cast<int>(feature) - static_cast<int>(first); }

}  // namespace

// The nearest point q of a triangle to p is also that of its neighbourhood if no direction into an adjacent
// triangle at q decreases the distance. On an edge the direction to the opposite corner is tested; at a
// corner those along its edges, as all others lie between two of these.
TriangleTree::Nearest MeshSides::downhill(const TriangleMesh& mesh, const TriangleTree& tree,
                                          const Vector3d& p, std::uint32_t slot) const {
  TriangleTree::Nearest best = tree.closestOn(slot, p);
  for (int step = 0; step < kSteps; ++step) {
    if (best.feature == Feature::kFace) return best;
    const Vector3d away = p - best.point;
    std::uint32_t next = best.slot;
    if (best.feature <= Feature::kEdge2) {
      const int i = indexOf(best.feature, Feature::kEdge0);
      const Slot& s = slots_[best.slot];
      const std::uint32_t other = s.across[i];
      for (const std::uint32_t v : slots_[other].corner) {
        if (v != s.corner[i] && v != s.corner[(i + 1) % 3] && away.dot(mesh.vertices[v] - best.point) > 0.0)
          next = other;
      }
    } else {
      const std::uint32_t vertex = slots_[best.slot].corner[indexOf(best.feature, Feature::kCorner0)];
      double steepest = 0.0;
      std::uint32_t at = best.slot;
      for (int n = 0; n < kAround; ++n) {
        const Slot& s = slots_[at];
        const int i = s.corner[0] == vertex ? 0 : s.corner[1] == vertex ? 1 : 2;
        const double towards = away.dot(mesh.vertices[s.corner[(i + 1) % 3]] - best.point);
        if (towards > steepest) steepest = towards, next = at;
        at = s.across[i];
        if (at == best.slot) break;
      }
    }
    if (next == best.slot) return best;
    const TriangleTree::Nearest found = tree.closestOn(next, p);
    if (!(found.distance < best.distance)) return best;
    best = found;
  }
  return best;
}

}  // namespace abstand::geometry
