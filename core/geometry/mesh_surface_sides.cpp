// Inside test of closed meshes by angle-weighted normals, and the test whether a mesh bounds a solid.
#include "core/geometry/mesh_surface_sides.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/mesh_surface_cut.hpp"

namespace abstand::geometry {

MeshSides::MeshSides(const TriangleMesh& mesh, const TriangleTree& tree, const WindingNumber& winding) {
  slots_.resize(tree.size());
  for (std::uint32_t s = 0; s < slots_.size(); ++s) {
    const auto& t = mesh.triangles[tree.triangle(s)];
    for (int i = 0; i < 3; ++i) slots_[s].corner[i] = t[(i + tree.rotation(s)) % 3];
    slots_[s].normal = tree.normal(s);
  }
  link(mesh, tree);
  if (!watertight_) return;
  weighNormals(mesh);
  embedded_ = !cutsItself(mesh, tree) && piecesAreNestedWell(mesh, winding);
}

// Finds the slot across each edge, and whether every edge has exactly two triangles in opposite directions.
void MeshSides::link(const TriangleMesh& mesh, const TriangleTree& tree) {
  struct Edge {
    std::uint64_t ends;  ///< the two vertices of an edge: smaller index in the high half, larger index in the
                         ///< low half
    std::uint32_t slot;
    std::uint8_t i;
    bool rising;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * slots_.size());
  double volume6 = 0.0;
  for (std::uint32_t s = 0; s < slots_.size(); ++s) {
    const auto& v = slots_[s].corner;
    for (std::uint8_t i = 0; i < 3; ++i) {
      const std::uint32_t a = v[i], b = v[(i + 1) % 3];
      edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), s, i, a < b});
    }
    const Vector3d a = mesh.vertices[v[0]] - tree.origin();
    volume6 += a.dot((mesh.vertices[v[1]] - tree.origin()).cross(mesh.vertices[v[2]] - tree.origin()));
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
    return e.ends != f.ends ? e.ends < f.ends : e.slot != f.slot ? e.slot < f.slot : e.i < f.i;
  });
  watertight_ = volume6 > 0.0;
  for (std::size_t k = 0; watertight_ && k < edges.size(); k += 2) {
    const auto same = [&](std::size_t m) { return m < edges.size() && edges[m].ends == edges[k].ends; };
    watertight_ = same(k + 1) && !same(k + 2) && edges[k].rising != edges[k + 1].rising;
    if (!watertight_) break;
    slots_[edges[k].slot].across[edges[k].i] = edges[k + 1].slot;
    slots_[edges[k + 1].slot].across[edges[k + 1].i] = edges[k].slot;
  }
}

void MeshSides::weighNormals(const TriangleMesh& mesh) {
  vertex_normals_.assign(mesh.vertices.size(), Vector3d::Zero());
  for (const Slot& slot : slots_) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d& v = mesh.vertices[slot.corner[i]];
      const Vector3d u = mesh.vertices[slot.corner[(i + 1) % 3]] - v;
      const Vector3d w = mesh.vertices[slot.corner[(i + 2) % 3]] - v;
      vertex_normals_[slot.corner[i]] += std::atan2(u.cross(w).norm(), u.dot(w)) * slot.normal;
    }
  }
}

bool MeshSides::cutsItself(const TriangleMesh& mesh, const TriangleTree& tree) const {
  // Boxes farther apart than this share of their sizes contain no triangles that touch.
  constexpr double kApart = 1e-8;
  const auto cornersOf = [&](const Slot& slot) -> CutTriangle {
    const auto& v = slot.corner;
    return {{v[0], v[1], v[2]}, {mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}, slot.normal};
  };
  std::vector<Bounds> boxes(slots_.size());
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    for (const std::uint32_t v : slots_[s].corner) boxes[s].add(mesh.vertices[v]);
    const Vector3d slack = Vector3d::Constant(kApart * boxes[s].extent().maxCoeff());
    boxes[s].lower -= slack;
    boxes[s].upper += slack;
  }
  bool cut = false;
  for (std::uint32_t s = 0; s < slots_.size() && !cut; ++s) {
    const Slot& slot = slots_[s];
    const Bounds& box = boxes[s];
    const CutTriangle mine = cornersOf(slot);
    tree.forOverlapping(box, [&](std::uint32_t other) {
      if (other <= s || cut) return;
      // Neighbours share an edge and never cut each other.
      if (other == slot.across[0] || other == slot.across[1] || other == slot.across[2]) return;
      if ((boxes[other].lower.array() > box.upper.array()).any() ||
          (boxes[other].upper.array() < box.lower.array()).any())
        return;
      cut = cutEachOther(mine, cornersOf(slots_[other]));
    });
  }
  return cut;
}

bool MeshSides::piecesAreNestedWell(const TriangleMesh& mesh, const WindingNumber& winding) const {
  // On the surface the winding number is the mean of both sides: one half, up to the dipole error.
  constexpr double kAboutHalf = 0.25;
  std::vector<bool> seen(slots_.size(), false);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t s = 0; s < slots_.size(); ++s) {
    if (seen[s]) continue;
    const auto& v = slots_[s].corner;
    const Vector3d centre = (mesh.vertices[v[0]] + mesh.vertices[v[1]] + mesh.vertices[v[2]]) / 3.0;
    if (std::abs(winding.at(centre, s) - 0.5) > kAboutHalf) return false;
    seen[s] = true;
    stack.push_back(s);
    while (!stack.empty()) {
      const std::uint32_t at = stack.back();
      stack.pop_back();
      for (const std::uint32_t next : slots_[at].across) {
        if (!seen[next]) seen[next] = true, stack.push_back(next);
      }
    }
  }
  return true;
}

bool MeshSides::behind(const TriangleTree::Nearest& nearest, const Vector3d& p) const {
  const Slot& slot = slots_[nearest.slot];
  const Vector3d away = p - nearest.point;
  switch (nearest.feature) {
    case Feature::kFace:
      return away.dot(slot.normal) < 0.0;
    case Feature::kEdge0:
    case Feature::kEdge1:
    case Feature::kEdge2: {
      const int i = static_cast<int>(nearest.feature) - static_cast<int>(Feature::kEdge0);
      return away.dot(slot.normal + slots_[slot.across[i]].normal) < 0.0;
    }
    default: {
      const int i = static_cast<int>(nearest.feature) - static_cast<int>(Feature::kCorner0);
      return away.dot(vertex_normals_[slot.corner[i]]) < 0.0;
    }
  }
}

}  // namespace abstand::geometry
