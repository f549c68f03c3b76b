// Exact distances from grid vertices to a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/mesh_surface.hpp"
#include "core/math/four.hpp"

namespace abstand::field {

/// Features (faces, edges and vertices) of a mesh, with a search for those nearest to the vertices of a block
/// of a grid. The nearest surface point q to p is the foot of the perpendicular from p on a feature, which
/// restricts p: for a face to its prism; for an edge to between the planes through its ends and beyond its
/// faces' planes through it; for a vertex to beyond its edges' planes (Mauch, A Fast Algorithm for Computing
/// the Closest Point and Distance Transform, 2000). A feature is skipped for a block if its half-spaces do
/// not intersect the block, or if at the block's middle it is farther than another surface point w by more
/// than the block is wide, as |p - q|^2 - |p - w|^2 is linear in p. Constant after construction.
class NearDistances {
 public:
  using List = std::vector<std::uint32_t>;
  /// Vertices p = origin + spacing (first + (i, j, k)), i < size.x and so on.
  struct Block {
    Vector3i first, size;
  };
  static constexpr int kMaxSize = 5;  ///< largest size of a queried block along an axis

  /// The surface must outlive this object.
  NearDistances(const geometry::MeshSurface& surface, const Vector3d& origin, double spacing);

  /// List of all features.
  List all() const;
  /// Sets `kept` to the features of `list` that may be nearest to a vertex of the block. `hint`: that of a
  /// place nearby.
  void near(const Block& block, const List& list, std::uint32_t& hint, List& kept) const;

  struct Nearest {
    float distance[kMaxSize][kMaxSize][kMaxSize];      ///< m, unsigned; [k][j][i]
    std::uint32_t slot[kMaxSize][kMaxSize][kMaxSize];  ///< slot of the tree, used as the hint of
                                                       ///< Surface::inside
  };
  /// Exact up to rounding in float. `list`: result of near() for the block or for one that contains it.
  void distances(const Block& block, const List& list, Nearest& nearest) const;

 private:
  enum class Kind : std::uint8_t { kFace, kEdge, kVertex };
  /// Four half-spaces as a structure of arrays, n . p + offset >= 0 relative to middle_; unused ones contain
  /// everything. The fourth of a face is its plane; the first normal of an edge is along the edge.
  struct HalfSpaces {
    Four x, y, z, offset;
  };
  /// Bounding ball of a feature: centre on the feature, relative to middle_, and radius.
  struct Ball {
    float v[4];
  };
  struct Feature {
    std::uint32_t first;  ///< index of its half-spaces, and number of groups of four
    std::uint32_t fours;
    std::uint32_t slot;
    Kind kind;
  };
  class Candidates;
  void addFace(std::uint32_t slot, const Vector3d (&corner)[3]);
  /// Sets half-space n of the feature that is added next.
  void addHalfSpace(std::size_t n, const Vector3d& normal, const Vector3d& through);
  void addFeature(Kind kind, std::uint32_t slot, const Vector3d& centre, double radius, std::uint32_t first);
  Vector3d place(const Vector3d& vertex) const { return origin_ + spacing_ * vertex; }

  const geometry::MeshSurface& surface_;
  Vector3d origin_, middle_;
  double spacing_;
  float tolerance_;  ///< m, for half-spaces
  std::vector<Feature> features_;
  std::vector<Ball> balls_;  ///< of the features; stored separately, as most features are rejected by their
                             ///< balls
  std::vector<HalfSpaces> half_spaces_;
};

}  // namespace abstand::field
