// A surface cut into small triangles, from which shell points and their areas are taken.
#pragma once

#include <cstdint>
#include <vector>

#include "core/haptic/pointshell_tips.hpp"

namespace abstand {

/// A piece of one triangle of a mesh. Bit i of `sharp`: the edge from corner i to corner i + 1 lies on a
/// sharp edge.
struct SubTriangle {
  Vector3d corner[3];
  std::uint32_t triangle;
  unsigned sharp;

  Vector3d centroid() const { return (corner[0] + corner[1] + corner[2]) / 3.0; }
  double area() const { return 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm(); }
  /// Halves it at its longest edge.
  void split(SubTriangle& first, SubTriangle& second) const;
  double longestEdge(int* edge = nullptr) const;
};

/// A sharp convex edge of a mesh.
struct Crease {
  Vector3d normal[2];  ///< outward unit normals of its two triangles
  Vector3d end[2];
  Vector3d along() const { return (end[1] - end[0]).normalized(); }
};

/// Nearest point of the triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).
Vector3d closestPoint(const SubTriangle& triangle, const Vector3d& p);

/// The pieces of a mesh, none longer than `max_edge` nor larger than `max_area`; near tips smaller by the
/// square of the pitch. More than kMostStored pieces are not kept but made anew on every walk, in the same
/// order, so that a large surface costs little memory. The mesh must outlive this object.
class SurfacePool {
 public:
  /// Throws UsageError when there would be more than kMaxPieces.
  SurfacePool(const TriangleMesh& mesh, double max_edge, double max_area, const TipField& tips);

  /// Calls visit(index, const SubTriangle&) for every piece of positive area.
  template <class Visit>
  void walk(Visit visit) const {
    if (!pieces_.empty()) {
      for (std::uint32_t i = 0; i < pieces_.size(); ++i) visit(i, pieces_[i]);
      return;
    }
    std::vector<SubTriangle> stack;
    std::uint32_t index = 0;
    std::size_t decision = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (normals_[t].isZero()) continue;
      stack.push_back(whole(t));
      while (!stack.empty()) {
        const SubTriangle piece = stack.back();
        stack.pop_back();
        if (!split_[decision++]) {
          visit(index++, piece);
        } else {
          stack.resize(stack.size() + 2);
          piece.split(stack[stack.size() - 1], stack[stack.size() - 2]);
        }
      }
    }
  }

  /// Outward unit normal of a triangle of the mesh; zero for a triangle without area.
  const Vector3d& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  const std::vector<Crease>& creases() const { return creases_; }
  /// Triangles without area: part of the surface, but no piece comes from them.
  std::vector<SubTriangle> degenerate() const;

  static constexpr double kMaxPieces = 5.0e7;
  static constexpr std::size_t kMostStored = 1'000'000;

 private:
  SubTriangle whole(std::uint32_t t) const;

  const TriangleMesh& mesh_;
  std::vector<Vector3d> normals_;
  std::vector<std::uint8_t> sharp_;
  std::vector<Crease> creases_;
  std::vector<bool> split_;          ///< in the order of the walk: is this triangle halved?
  std::vector<SubTriangle> pieces_;  ///< in the order of the walk; empty when there are too many
};

}  // namespace abstand
