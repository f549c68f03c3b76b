// Inside test of closed meshes by angle-weighted normals, and the test whether a mesh bounds a solid.
#pragma once

#include "core/geometry/winding_number.hpp"

namespace abstand::geometry {

/// Adjacency and angle-weighted normals of edges and vertices of a mesh. Constant after construction.
class MeshSides {
 public:
  MeshSides() = default;
  /// `tree` holds all triangles of `mesh`; indices are in range.
  MeshSides(const TriangleMesh& mesh, const TriangleTree& tree, const WindingNumber& winding);

  /// Each edge has two triangles of opposite orientation, and the volume is positive.
  bool watertight() const { return watertight_; }
  /// Watertight, no two triangles intersect or touch except at shared corners and edges, and the winding
  /// number is 1 just inside each component and 0 just outside (so no component is wrongly nested).
  bool embedded() const { return embedded_; }
  /// For embedded meshes: p lies behind the surface at its nearest point, by the angle-weighted pseudonormal
  /// (Baerentzen, Aanaes, Signed Distance Computation Using the Angle Weighted Pseudonormal, 2005).
  bool behind(const TriangleTree::Nearest& nearest, const Vector3d& p) const;
  /// For watertight meshes: walks from triangle to adjacent triangle as long as the distance to p decreases.
  TriangleTree::Nearest downhill(const TriangleMesh& mesh, const TriangleTree& tree, const Vector3d& p,
                                 std::uint32_t slot) const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(watertight_, embedded_, slots_, vertex_normals_);
  }

 private:
  struct Slot {
    using ArchivedAsBytes = void;
    std::uint32_t corner[3];  ///< vertices A, B, C
    std::uint32_t across[3];  ///< slot of the neighbour across edge i
    Vector3d normal;
  };
  void link(const TriangleMesh& mesh, const TriangleTree& tree);
  void weighNormals(const TriangleMesh& mesh);
  bool cutsItself(const TriangleMesh& mesh, const TriangleTree& tree) const;
  bool piecesAreNestedWell(const TriangleMesh& mesh, const WindingNumber& winding) const;

  bool watertight_{false};
  bool embedded_{false};
  std::vector<Slot> slots_;
  std::vector<Vector3d> vertex_normals_;
};

}  // namespace abstand::geometry
