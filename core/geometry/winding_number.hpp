// Generalised winding number of a mesh: inside or outside, even where the mesh is open or intersects itself.
#pragma once

#include <vector>

#include "core/geometry/triangle_tree.hpp"

namespace abstand::geometry {

/// Generalised winding number (Jacobson, Kavan, Sorkine-Hornung 2013): 1 inside a closed mesh, 0 outside, in
/// between near the holes of an open one. Far clusters of triangles are approximated by one dipole each
/// (Barill, Dickson, Schmidt, Levin, Jacobson, Fast Winding Numbers 2018, first term). Constant after
/// construction.
class WindingNumber {
 public:
  /// A cluster is approximated beyond this multiple of its radius. At 2.5 the error over closed meshes stays
  /// below 0.05 (tests), a tenth of the threshold between inside and outside.
  static constexpr double kFarRatio = 2.5;

  WindingNumber() = default;
  explicit WindingNumber(const TriangleTree& tree, const TriangleMesh& mesh);

  /// Allocates nothing, does not throw. One triangle (slot of the tree) may be left out, so that the number
  /// on a surface is the mean of its two sides.
  double at(const Vector3d& p, std::uint32_t without = TriangleTree::kNone) const;
  /// Sum over every triangle, without approximation: the reference.
  double exactAt(const Vector3d& p, std::uint32_t without = TriangleTree::kNone) const;
  template <class Archive>
  void archive(Archive& ar) {
    ar(nodes_, corners_);
  }

 private:
  struct Dipole {
    Vector3d centre{Vector3d::Zero()};  ///< area-weighted
    Vector3d moment{Vector3d::Zero()};  ///< sum of area times normal, over 4 pi
    double far2{kInfinity};             ///< squared distance beyond which the dipole is used
  };
  struct Corners {
    using ArchivedAsBytes = void;
    Vector3d a, b, c;
  };
  struct Sums;
  Sums addNode(const TriangleTree& tree, std::uint32_t node);

  struct Node {
    using ArchivedAsBytes = void;
    Dipole dipole[TriangleTree::kWidth];
    std::uint32_t index[TriangleTree::kWidth];
    std::uint32_t count[TriangleTree::kWidth];
  };
  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  ///< by slot
};

}  // namespace abstand::geometry
