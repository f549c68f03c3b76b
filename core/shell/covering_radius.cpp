// Covering radius of a pointshell: branch and bound over triangles.
#include "core/shell/covering_radius.hpp"

#include <algorithm>

namespace abstand::shell {
namespace {

/// More than the error of rounding to float.
constexpr double kRoundUp = 1.0 + 1e-7;
/// Sub-triangles with a bound above this share of the largest are tested first.
constexpr float kLarge = 0.95f;
/// Sub-triangles before and after one whose shell points are tried; neighbours in a mesh often are neighbours
/// in space.
constexpr std::uint32_t kNeighbours = 16;

struct Candidate {
  double bound;
  std::uint32_t piece;  ///< index of a sub-triangle; from pool.size() on, index + pool.size() of a part
  bool operator<(const Candidate& other) const { return bound < other.bound; }
};

double squaredBound(const SubTriangle& piece, const Vector3f& q) {
  const Vector3d centre = q.cast<double>();
  double bound2 = 0.0;
  for (const Vector3d& corner : piece.corner) bound2 = std::max(bound2, (corner - centre).squaredNorm());
  return bound2;
}
double cornerBound(const SubTriangle& piece, const Vector3f& q) { return std::sqrt(squaredBound(piece, q)); }

}  // namespace

double coveringRadius(const SubTriangles& pool, const std::vector<Vector3f>& points,
                      const std::vector<std::uint32_t>& nearest) {
  const NearestOfPoints finder(points);
  // Squared upper bound for each sub-triangle; those with the largest give a lower bound of the covering
  // radius.
  std::vector<float> bounds2(pool.size());
  float largest = 0.0f;
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    bounds2[i] = static_cast<float>(squaredBound(piece.whole(), points[nearest[i]]) * kRoundUp);
    largest = std::max(largest, bounds2[i]);
  });
  double reached = 0.0;  // lower bound: some surface point is at least this far from its nearest shell point
  std::uint32_t q = 0;
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    if (bounds2[i] > kLarge * kLarge * largest)
      reached = std::max(reached, finder.distance(piece.centroid(), q));
  });
  // Only sub-triangles that may decide are refined; the others are covered within `floor`.
  double floor = 0.0;
  std::vector<Candidate> heap;
  std::vector<SubTriangle> parts = pool.degenerate();
  const auto partAt = [&](std::size_t i) { return static_cast<std::uint32_t>(pool.size() + i); };
  for (std::size_t i = 0; i < parts.size(); ++i) heap.push_back({kInfinity, partAt(i)});
  pool.forEach([&](std::uint32_t i, const SubTriangles::View& piece) {
    if (double(bounds2[i]) <= floor * floor) return;
    double bound = std::sqrt(double(bounds2[i]));
    if (bound > reached) {
      // A shell point of a neighbour may be nearer.
      const SubTriangle whole = piece.whole();
      const std::uint32_t first = i > kNeighbours ? i - kNeighbours : 0;
      for (std::uint32_t n = first; n < std::min(i + kNeighbours, pool.size()) && bound > reached; ++n)
        if (nearest[n] != nearest[i]) bound = std::min(bound, cornerBound(whole, points[nearest[n]]));
      if (bound > reached) heap.push_back({bound, i});
    }
    if (bound <= reached) floor = std::max(floor, bound);
  });
  std::make_heap(heap.begin(), heap.end());
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end());
    const Candidate top = heap.back();
    heap.pop_back();
    if (top.bound <= std::max(floor, reached * (1.0 + kCoverSlack))) return std::max(floor, top.bound);
    const SubTriangle piece =
        top.piece < pool.size() ? pool.piece(top.piece) : parts[top.piece - pool.size()];
    reached = std::max(reached, finder.distance(piece.centroid(), q));
    const double bound = std::min(top.bound, cornerBound(piece, points[q]));
    if (bound <= std::max(floor, reached)) {
      floor = std::max(floor, bound);
      continue;
    }
    SubTriangle halves[2];
    piece.split(halves[0], halves[1]);
    for (const SubTriangle& half : halves) {
      finder.distance(half.centroid(), q);
      heap.push_back({std::min(bound, cornerBound(half, points[q])), partAt(parts.size())});
      parts.push_back(half);
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return floor;
}

}  // namespace abstand::shell
