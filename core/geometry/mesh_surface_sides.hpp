// Whether a mesh bounds a solid, and on which side of it a point lies.
#pragma once

#include "core/geometry/winding_number.hpp"

namespace abstand::geometry {

/// Neighbours and angle-weighted normals of a mesh's edges and vertices. Constant after construction.
class MeshSides {
 public:
  MeshSides() = default;
  /// `tree` holds all triangles of `mesh`; indices are in range.
  MeshSides(const TriangleMesh& mesh, const TriangleTree& tree, const WindingNumber& winding);

  /// Each edge has two triangles that run along it in opposite directions, and the volume is positive.
  bool watertight() const { return watertight_; }
  /// Watertight, no two triangles cut or touch each other but at shared corners, and just inside each piece
  /// the winding number is 1 and just outside 0 (so no piece lies needlessly inside another).
  bool embedded() const { return embedded_; }
  /// For embedded meshes: p lies behind the surface at its nearest point (Baerentzen, Aanaes, Signed Distance
  /// Computation Using the Angle Weighted Pseudonormal, 2005).
  bool behind(const TriangleTree::Nearest& nearest, const Vector3d& p) const;
  /// For watertight meshes: from one triangle to the next as long as that is nearer to p.
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
    std::uint32_t across[3];  ///< slot on the other side of edge i
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
