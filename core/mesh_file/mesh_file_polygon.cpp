// Polygon triangulation by ear clipping, with a grid of reflex corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <vector>

#include "core/mesh_file/mesh_file_readers.hpp"

namespace abstand::mesh_file {
namespace {

/// Limit of clipping steps for one file; one or two seconds.
constexpr std::uint64_t kMaxWork = 200'000'000;
/// Cells along a side of the grid of reflex corners.
constexpr int kMaxCells = 512;

/// Twice the signed area of a, b, c, positive if counter-clockwise seen against `normal`.
double turn(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal) {
  return (b - a).cross(c - b).dot(normal);
}

using Point = Eigen::Vector2d;

double turn(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - b;
  return u.x() * v.y() - u.y() * v.x();
}

/// State of a polygon during ear clipping, projected onto its plane.
class EarClipper {
 public:
  EarClipper(const std::vector<Vector3d>& vertices, std::span<const std::uint32_t> corners,
             const Vector3d& normal)
      : corners_(corners), left_(corners.size()) {
    const std::size_t n = corners.size();
    const Vector3d axis = normal.normalized();
    const Vector3d e1 = axis.unitOrthogonal(), e2 = axis.cross(e1);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3d d = vertices[corners[i]] - vertices[corners[0]];
      p_.emplace_back(e1.dot(d), e2.dot(d));
      before_.push_back(static_cast<std::uint32_t>((i + n - 1) % n));
      after_.push_back(static_cast<std::uint32_t>((i + 1) % n));
    }
    stamp_.assign(n, 0);
    fillGrid();
  }

  /// Clips one ear, or any corner if there is none; false when one triangle is left. `work` is increased by
  /// the steps.
  bool cut(std::array<std::uint32_t, 3>& triangle, std::uint64_t& work) {
    if (left_ <= 3) return false;
    std::uint32_t at = start_;
    bool found = false, after_first = false;
    while (!found) {
      if (queue_.empty()) {
        // Corners that were not ears may have become ears. A self-intersecting polygon may have none; it is
        // clipped anyway, so that the mesh stays closed.
        if (!cut_since_filled_) break;
        fillQueue();
        work += left_;
        continue;
      }
      const Entry entry = queue_.front();
      queue_.pop_front();
      ++work;
      if (entry.stamp != stamp_[entry.corner]) continue;
      at = entry.corner;
      after_first = entry.after_first;
      found = isEar(at, work);
    }
    const std::uint32_t b = before_[at], a = after_[at];
    triangle = {corners_[b], corners_[at], corners_[a]};
    after_[b] = a;
    before_[a] = b;
    stamp_[at] = kGone;
    --left_;
    start_ = a;
    cut_since_filled_ = true;
    // Both neighbours have changed and go last in the queue, in alternating order: always clipping on one
    // side would give a fan of slivers around the corner on the other.
    for (const std::uint32_t k : {after_first ? a : b, after_first ? b : a})
      queue_.push_back({k, ++stamp_[k], !after_first});
    return true;
  }

  std::array<std::uint32_t, 3> last() const {
    return {corners_[before_[start_]], corners_[start_], corners_[after_[start_]]};
  }

 private:
  static constexpr std::uint32_t kGone = 0xffffffff;
  struct Entry {
    std::uint32_t corner, stamp;
    bool after_first;  ///< if true, the next corner is queued before the previous one
  };

  double turnAt(std::uint32_t i) const { return turn(p_[before_[i]], p_[i], p_[after_[i]]); }

  void fillQueue() {
    cut_since_filled_ = false;
    std::uint32_t i = start_;
    for (std::size_t k = 0; k < left_; ++k, i = after_[i]) queue_.push_back({i, stamp_[i], false});
  }

  int cellOf(double v, double origin) const {
    return std::clamp(static_cast<int>((v - origin) * cells_per_metre_), 0, cells_ - 1);
  }

  void fillGrid() {
    Point low = p_[0], high = p_[0];
    for (const Point& p : p_) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    low_ = low;
    cells_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(p_.size()))), 1, kMaxCells);
    const double side = (high - low).maxCoeff();
    cells_per_metre_ = side > 0.0 ? cells_ / side : 0.0;
    grid_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      if (!(turnAt(i) > 0.0)) cell(cellOf(p_[i].x(), low_.x()), cellOf(p_[i].y(), low_.y())).push_back(i);
    fillQueue();
  }

  std::vector<std::uint32_t>& cell(int x, int y) {
    return grid_[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_) +
                 static_cast<std::size_t>(x)];
  }

  bool isEar(std::uint32_t i, std::uint64_t& work) {
    const std::uint32_t ia = before_[i], ic = after_[i];
    const Point &a = p_[ia], &b = p_[i], &c = p_[ic];
    if (!(turn(a, b, c) > 0.0)) return false;
    const Point low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const int x0 = cellOf(low.x(), low_.x()), x1 = cellOf(high.x(), low_.x());
    const int y0 = cellOf(low.y(), low_.y()), y1 = cellOf(high.y(), low_.y());
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        auto& reflex = cell(x, y);
        work += 1 + reflex.size();
        for (std::size_t k = 0; k < reflex.size();) {
          const std::uint32_t r = reflex[k];
          if (stamp_[r] == kGone || turnAt(r) > 0.0) {
            // The corner is no longer reflex, so it cannot block an ear.
            reflex[k] = reflex.back();
            reflex.pop_back();
            continue;
          }
          ++k;
          // A corner at the same vertex as a corner of the ear belongs to a bridge to a hole and does not
          // block it.
          const std::uint32_t id = corners_[r];
          if (id == corners_[ia] || id == corners_[i] || id == corners_[ic]) continue;
          const Point& q = p_[r];
          if (turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0) return false;
        }
      }
    }
    return true;
  }

  std::span<const std::uint32_t> corners_;
  std::size_t left_;
  std::vector<Point> p_;
  std::vector<std::uint32_t> before_, after_, stamp_;
  std::deque<Entry> queue_;
  std::vector<std::vector<std::uint32_t>> grid_;  ///< reflex corners by grid cell
  Point low_{Point::Zero()};
  double cells_per_metre_{0.0};
  int cells_{1};
  std::uint32_t start_{0};
  bool cut_since_filled_{true};
};

}  // namespace

void PolygonCutter::add(std::span<const std::uint32_t> corners, const SourcePos& pos) {
  const std::size_t n = corners.size();
  for (const auto c : corners) {
    if (c >= mesh_.vertices.size())
      throw ParseError(pos, "found a face with vertex " + std::to_string(c) +
                                " counted from 0, expected one of " + std::to_string(mesh_.vertices.size()));
  }
  if (n < 3) return;
  const auto p = [&](std::size_t i) -> const Vector3d& { return mesh_.vertices[corners[i % n]]; };
  // Newell's normal, correct for concave polygons too.
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < n; ++i) normal += (p(i) - p(0)).cross(p(i + 1) - p(0));
  bool convex = true;
  for (std::size_t i = 0; n > 3 && i < n; ++i)
    convex = convex && turn(p(i), p(i + 1), p(i + 2), normal) > 0.0;
  // A polygon without area has no ears; its triangles have no area either, however it is cut.
  if (n == 3 || convex || !(normal.squaredNorm() > 0.0)) {
    for (std::size_t i = 1; i + 1 < n; ++i)
      mesh_.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  } else {
    clipEars(corners, normal, pos);
  }
}

void PolygonCutter::clipEars(std::span<const std::uint32_t> corners, const Vector3d& normal,
                             const SourcePos& pos) {
  EarClipper clipper(mesh_.vertices, corners, normal);
  std::array<std::uint32_t, 3> triangle{};
  while (clipper.cut(triangle, work_)) {
    if (work_ > kMaxWork)
      throw ParseError(
          pos,
          "found a polygon of " + std::to_string(corners.size()) +
              " corners that is too complicated to cut into triangles, expected fewer or one that does "
              "not cross itself",
          "triangulate the mesh in the program that it comes from");
    mesh_.triangles.push_back(triangle);
  }
  mesh_.triangles.push_back(clipper.last());
}

}  // namespace abstand::mesh_file
