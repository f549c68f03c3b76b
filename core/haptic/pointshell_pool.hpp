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
};

/// Nearest point of the triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).
Vector3d closestPoint(const SubTriangle& triangle, const Vector3d& p);

/// The pieces of a mesh, none longer than `max_edge` nor larger than `max_area`; near tips and sharp convex
/// edges smaller by the square of the pitch. The mesh must outlive this object.
class SurfacePool {
 public:
  /// Throws UsageError when there would be more than kMaxPieces.
  SurfacePool(const TriangleMesh& mesh, double max_edge, double max_area, const PitchField& field);

  std::uint32_t size() const { return static_cast<std::uint32_t>(pieces_.size()); }
  class View;
  /// Calls visit(index, const View&) for every piece. All have a positive area; those of one triangle follow
  /// each other.
  template <class Visit>
  void walk(Visit visit) const;

  /// m^2
  float area(std::uint32_t index) const { return area_[index]; }
  /// How close the points should lie at a piece, as a multiple of the spacing.
  float pitch(std::uint32_t index) const { return pitch_[index]; }
  /// Outward unit normal of a triangle of the mesh; zero for a triangle without area.
  const Vector3d& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// Mean of |x - centroid|^2 over a piece (m^2).
  float spread(std::uint32_t index) const { return spread_[index]; }
  /// No point of a piece is farther from its centroid (m): two thirds of the longest edge.
  double reach() const { return 2.0 / 3.0 * max_edge_; }
  /// Triangles without area: part of the surface, but no piece comes from them.
  std::vector<SubTriangle> degenerate() const;

  static constexpr double kMaxPieces = 5.0e7;

 private:
  /// Corner i is b[i] of the way along the triangle's side from its first corner to the second, and c[i]
  /// along that to the third: multiples of powers of 1/2, so exact.
  struct Piece {
    float b[3], c[3];
    std::uint32_t triangle : 29;
    std::uint32_t sharp : 3;
  };
  struct Part;
  void cut(std::uint32_t triangle, double max_area, const PitchField& field, std::vector<Part>& stack);

  const TriangleMesh& mesh_;
  double max_edge_;
  std::vector<Vector3d> normals_;
  std::vector<Piece> pieces_;
  std::vector<float> area_, pitch_, spread_;
};

/// One piece during a walk, made only as far as asked for.
class SurfacePool::View {
 public:
  std::uint32_t triangle() const { return piece_->triangle; }
  unsigned sharp() const { return piece_->sharp; }  ///< as in SubTriangle
  Vector3d corner(int i) const { return at(double(piece_->b[i]), double(piece_->c[i])); }
  Vector3d centroid() const {
    return at((double(piece_->b[0]) + double(piece_->b[1]) + double(piece_->b[2])) / 3.0,
              (double(piece_->c[0]) + double(piece_->c[1]) + double(piece_->c[2])) / 3.0);
  }
  SubTriangle whole() const { return {{corner(0), corner(1), corner(2)}, triangle(), sharp()}; }

 private:
  friend class SurfacePool;
  Vector3d at(double b, double c) const { return a_ + b * ab_ + c * ac_; }
  const Piece* piece_;
  Vector3d a_, ab_, ac_;
};

template <class Visit>
void SurfacePool::walk(Visit visit) const {
  View view;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    view.piece_ = &pieces_[i];
    const std::uint32_t t = pieces_[i].triangle;
    if (i == 0 || t != pieces_[i - 1].triangle) {
      view.a_ = mesh_.corner(t, 0);
      view.ab_ = mesh_.corner(t, 1) - view.a_;
      view.ac_ = mesh_.corner(t, 2) - view.a_;
    }
    visit(i, static_cast<const View&>(view));
  }
}

}  // namespace abstand
