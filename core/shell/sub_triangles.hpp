// Sub-triangles of a surface, from which shell points and their areas are computed.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/shell/pointshell_tips.hpp"

namespace abstand::shell {

/// Part of one mesh triangle. Bit i of `sharp`: the edge from corner i to corner i + 1 lies on a sharp edge.
struct SubTriangle {
  Vector3d corner[3];
  std::uint32_t triangle;
  unsigned sharp;

  Vector3d centroid() const { return (corner[0] + corner[1] + corner[2]) / 3.0; }
  double area() const { return 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm(); }
  /// Bisects the longest edge.
  void split(SubTriangle& first, SubTriangle& second) const;
};

/// Nearest point of the triangle (Ericson 2005, Real-Time Collision Detection, 5.1.5).
Vector3d closestPoint(const SubTriangle& triangle, const Vector3d& p);

/// Sub-triangles of a mesh, with edges up to `max_edge` (m) and areas up to `max_area` (m^2), times the
/// square of the pitch near tips and sharp convex edges. The mesh must outlive this object.
class SubTriangles {
 public:
  /// Throws UsageError if there would be more than kMaxPieces.
  SubTriangles(const geometry::TriangleMesh& mesh, double max_edge, double max_area, const PitchField& field);

  std::uint32_t size() const { return static_cast<std::uint32_t>(pieces_.size()); }
  class View;
  /// Calls visit(index, const View&) for the sub-triangles `first` to `end` - 1. All have a positive area.
  /// Those of one triangle are consecutive; if there are many, triangles are in spatial order, so that a
  /// range of sub-triangles is a compact part of the surface.
  template <class Visit>
  void forEach(std::uint32_t first, std::uint32_t end, Visit visit) const;
  /// Visits all sub-triangles.
  template <class Visit>
  void forEach(Visit visit) const {
    forEach(0, size(), visit);
  }

  SubTriangle piece(std::uint32_t index) const;
  /// Pitch of the shell points at a sub-triangle, as a multiple of the spacing.
  float pitch(std::uint32_t index) const { return pitch_.empty() ? 1.0f : pitch_[index]; }
  /// True if the pitch is 1 everywhere.
  bool isUniform() const { return pitch_.empty(); }
  /// Outward unit normal of a triangle of the mesh; zero for a triangle without area.
  const Vector3d& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// Upper bound (m) on the distance of a point of a sub-triangle from its centroid: two thirds of the
  /// longest edge.
  double centroidRadius() const { return 2.0 / 3.0 * max_edge_; }
  /// Mesh triangles without area: part of the surface, but without sub-triangles.
  std::vector<SubTriangle> degenerate() const;

  static constexpr double kMaxPieces = 5.0e7;

 private:
  /// Corner i is at the fraction b[i] / kWhole along the frame's side from its first corner to the second,
  /// and c[i] / kWhole along that to the third; both exact.
  struct Piece {
    std::uint16_t b[3], c[3];
    std::uint16_t level : 13;  ///< number of bisections: far below 1000
    std::uint16_t sharp : 3;
  };
  static constexpr std::uint32_t kWhole = 1u << 15;
  /// Reference triangle of sub-triangles: a mesh triangle, or a part of one if its sub-triangles are too
  /// small for 16-bit coordinates.
  struct Frame {
    Vector3d a, ab, ac;
  };
  /// Consecutive sub-triangles of one frame: from `first` to the next run's.
  struct Run {
    std::uint32_t first, triangle;
    std::uint32_t frame;  ///< index in frames_, or kTriangle: the mesh triangle itself
  };
  static constexpr std::uint32_t kTriangle = 0xffffffffu;
  struct Part;
  Frame frameOf(std::uint32_t triangle, std::uint32_t frame) const;
  void subdivide(std::uint32_t triangle, double max_area, const PitchField& field, std::vector<Part>& stack);

  const geometry::TriangleMesh& mesh_;
  double max_edge_;
  std::vector<Vector3d> normals_;
  std::vector<Piece> pieces_;
  std::vector<Run> runs_;
  std::vector<Frame> frames_;
  std::vector<float> pitch_;  ///< empty if all are 1
};

/// One sub-triangle during a walk; values are computed on demand.
class SubTriangles::View {
 public:
  std::uint32_t triangle() const { return triangle_; }
  unsigned sharp() const { return piece_->sharp; }  ///< as in SubTriangle
  Vector3d corner(int i) const { return at(double(piece_->b[i]), double(piece_->c[i])); }
  Vector3d centroid() const {
    return at(double(piece_->b[0] + piece_->b[1] + piece_->b[2]) / 3.0,
              double(piece_->c[0] + piece_->c[1] + piece_->c[2]) / 3.0);
  }
  /// m^2
  double area() const {
    return std::bit_cast<double>((std::uint64_t{1023} - piece_->level) << 52) * whole_area_;
  }
  /// Mean of |x - centroid|^2 over the sub-triangle (m^2): 1/12 of the sum over the corners, which is 1/3 of
  /// the sum over the edges.
  double variance() const {
    std::int64_t b2 = 0, bc = 0, c2 = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = i == 2 ? 0 : i + 1;
      const std::int64_t b = piece_->b[j] - piece_->b[i], c = piece_->c[j] - piece_->c[i];
      b2 += b * b, bc += b * c, c2 += c * c;
    }
    const auto& [a, ab, ac] = frame_;
    return (double(b2) * ab.squaredNorm() + 2.0 * double(bc) * ab.dot(ac) + double(c2) * ac.squaredNorm()) *
           (kPart * kPart / 36.0);
  }
  SubTriangle whole() const { return {{corner(0), corner(1), corner(2)}, triangle(), sharp()}; }

 private:
  friend class SubTriangles;
  static constexpr double kPart = 1.0 / kWhole;
  Vector3d at(double b, double c) const { return frame_.a + kPart * b * frame_.ab + kPart * c * frame_.ac; }
  const Piece* piece_;
  std::uint32_t triangle_;
  Frame frame_;
  double whole_area_;
};

template <class Visit>
void SubTriangles::forEach(std::uint32_t first, std::uint32_t end, Visit visit) const {
  View view;
  auto run = std::upper_bound(runs_.begin(), runs_.end(), first,
                              [](std::uint32_t i, const Run& r) { return i < r.first; });
  for (std::uint32_t i = first; i < end; ++run) {
    view.triangle_ = run[-1].triangle;
    view.frame_ = frameOf(view.triangle_, run[-1].frame);
    const Frame whole = frameOf(view.triangle_, kTriangle);
    view.whole_area_ = 0.5 * whole.ab.cross(whole.ac).norm();
    const std::uint32_t last = run == runs_.end() ? end : std::min(end, run->first);
    for (; i < last; ++i) {
      view.piece_ = &pieces_[i];
      visit(i, static_cast<const View&>(view));
    }
  }
}

}  // namespace abstand::shell
