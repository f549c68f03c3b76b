// Distances from the vertices of a grid to a mesh, exact.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/mesh_surface.hpp"
#include "core/math/four.hpp"

namespace abstand::field {

/// Features of a mesh (faces, edges and vertices), to find which of them are nearest to the vertices of a
/// block of a grid. The nearest point q of the surface to p is the foot of p on a feature, and p lies where
/// this can be: over a face in its prism, at an edge between the planes through its ends and on the far side
/// of its faces' planes through it, at a vertex on the far side of its edges' (Mauch, A Fast Algorithm for
/// Computing the Closest Point and Distance Transform, 2000). So a feature whose half-spaces miss a block is
/// no vertex's nearest, and neither is one that is farther from its middle than another point w of the
/// surface by more than the block is wide: |p - q|^2 - |p - w|^2 is linear in p. Constant after construction.
class NearDistances {
 public:
  using List = std::vector<std::uint32_t>;
  /// Vertices p = origin + spacing (first + (i, j, k)), i < size.x and so on.
  struct Block {
    Vector3i first, size;
  };
  static constexpr int kMaxSize = 5;  ///< of a block whose distances are asked, along an axis

  /// The surface must outlive this object.
  NearDistances(const geometry::MeshSurface& surface, const Vector3d& origin, double spacing);

  /// All features.
  List all() const;
  /// Sets `kept` to those of a list that may be nearest to a vertex of a block. `hint` is that of a place
  /// nearby.
  void near(const Block& block, const List& list, std::uint32_t& hint, List& kept) const;

  struct Nearest {
    float distance[kMaxSize][kMaxSize][kMaxSize];      ///< m, unsigned; [k][j][i]
    std::uint32_t slot[kMaxSize][kMaxSize][kMaxSize];  ///< of the tree, as the hint of Surface::inside
  };
  /// Exact but for rounding in float. `list`: what near() gives for the block or one around it.
  void distances(const Block& block, const List& list, Nearest& nearest) const;

 private:
  enum class Kind : std::uint8_t { kFace, kEdge, kVertex };
  /// Four half-spaces side by side, n . p + offset >= 0 about middle_; unused ones hold everything. A face's
  /// fourth is its plane, the first of an edge leads along it.
  struct HalfSpaces {
    Four x, y, z, offset;
  };
  /// About a feature: its centre, on the feature and about middle_, and its radius.
  struct Ball {
    float v[4];
  };
  struct Feature {
    std::uint32_t first;  ///< of its half-spaces, and how many fours
    std::uint32_t fours;
    std::uint32_t slot;
    Kind kind;
  };
  class Candidates;
  void addFace(std::uint32_t slot, const Vector3d (&corner)[3]);
  /// Half-spaces of the feature that is added next: its n-th one.
  void addHalfSpace(std::size_t n, const Vector3d& normal, const Vector3d& through);
  void addFeature(Kind kind, std::uint32_t slot, const Vector3d& centre, double radius, std::uint32_t first);
  Vector3d place(const Vector3d& vertex) const { return origin_ + spacing_ * vertex; }

  const geometry::MeshSurface& surface_;
  Vector3d origin_, middle_;
  double spacing_;
  float tolerance_;  ///< m, for half-spaces
  std::vector<Feature> features_;
  std::vector<Ball> balls_;  ///< of the features, apart from them: most are looked at for their balls alone
  std::vector<HalfSpaces> half_spaces_;
};

}  // namespace abstand::field
