// A surface cut into small triangles, from which shell points and their areas are taken.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/shell/pointshell_tips.hpp"

namespace abstand::shell {

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
class SubTriangles {
 public:
  /// Throws UsageError when there would be more than kMaxPieces.
  SubTriangles(const geometry::TriangleMesh& mesh, double max_edge, double max_area, const PitchField& field);

  std::uint32_t size() const { return static_cast<std::uint32_t>(pieces_.size()); }
  class View;
  /// Calls visit(index, const View&) for the pieces from `first` to before `end`. All have a positive area.
  /// Those of one triangle follow each other, and where there are many, triangles do as they lie in space, so
  /// that a stretch of pieces is a compact part of the surface.
  template <class Visit>
  void walk(std::uint32_t first, std::uint32_t end, Visit visit) const;
  /// All pieces.
  template <class Visit>
  void walk(Visit visit) const {
    walk(0, size(), visit);
  }

  SubTriangle piece(std::uint32_t index) const;
  /// How close the points should lie at a piece, as a multiple of the spacing.
  float pitch(std::uint32_t index) const { return pitch_.empty() ? 1.0f : pitch_[index]; }
  /// Whether the pitch is 1 everywhere.
  bool plain() const { return pitch_.empty(); }
  /// Outward unit normal of a triangle of the mesh; zero for a triangle without area.
  const Vector3d& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// No point of a piece is farther from its centroid (m): two thirds of the longest edge.
  double reach() const { return 2.0 / 3.0 * max_edge_; }
  /// Triangles without area: part of the surface, but no piece comes from them.
  std::vector<SubTriangle> degenerate() const;

  static constexpr double kMaxPieces = 5.0e7;

 private:
  /// Corner i is b[i] / kWhole of the way along a frame's side from its first corner to the second, and
  /// c[i] / kWhole along that to the third: exact.
  struct Piece {
    std::uint16_t b[3], c[3];
    std::uint16_t level : 13;  ///< how often its triangle was halved: far below 1000
    std::uint16_t sharp : 3;
  };
  static constexpr std::uint32_t kWhole = 1u << 15;
  /// What pieces are measured in: a triangle, or a part of one whose pieces are too small for its numbers.
  struct Frame {
    Vector3d a, ab, ac;
  };
  /// Pieces of one frame that follow each other: from `first` to the next run's.
  struct Run {
    std::uint32_t first, triangle;
    std::uint32_t frame;  ///< of frames_, or kTriangle: the triangle itself
  };
  static constexpr std::uint32_t kTriangle = 0xffffffffu;
  struct Part;
  Frame frameOf(std::uint32_t triangle, std::uint32_t frame) const;
  void cut(std::uint32_t triangle, double max_area, const PitchField& field, std::vector<Part>& stack);

  const geometry::TriangleMesh& mesh_;
  double max_edge_;
  std::vector<Vector3d> normals_;
  std::vector<Piece> pieces_;
  std::vector<Run> runs_;
  std::vector<Frame> frames_;
  std::vector<float> pitch_;  ///< none where all are 1
};

/// One piece during a walk, made only as far as asked for.
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
  /// Mean of |x - centroid|^2 over the piece (m^2): a twelfth of the sum over the corners, and that is a
  /// third of the sum over the edges.
  double spread() const {
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
void SubTriangles::walk(std::uint32_t first, std::uint32_t end, Visit visit) const {
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
