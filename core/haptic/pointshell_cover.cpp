// How far the surface is from its shell points at most: branch and bound over triangles.
#include "core/haptic/pointshell_cover.hpp"

#include <algorithm>

namespace abstand {
namespace {

struct Candidate {
  double bound;
  SubTriangle piece;
  bool operator<(const Candidate& other) const { return bound < other.bound; }
};

double cornerBound(const SubTriangle& piece, const Vector3f& q) {
  const Vector3d centre = q.cast<double>();
  double bound2 = 0.0;
  for (const Vector3d& corner : piece.corner) bound2 = std::max(bound2, (corner - centre).squaredNorm());
  return std::sqrt(bound2);
}

}  // namespace

double coveringRadius(const SurfacePool& pool, const std::vector<Vector3f>& points,
                      const std::vector<std::uint32_t>& nearest) {
  const NearestPoint finder(points);
  std::vector<SubTriangle> loose = pool.degenerate();
  double largest = 0.0;
  pool.walk([&](std::uint32_t i, const SubTriangle& piece) {
    largest = std::max(largest, cornerBound(piece, points[nearest[i]]));
  });
  // Only pieces that may decide are looked at; the rest is covered within `floor` as it is.
  double floor = 0.0;
  std::vector<Candidate> heap;
  for (const SubTriangle& piece : loose) heap.push_back({kInfinity, piece});
  double reached = 0.0;  // some point of the surface is at least this far from its nearest shell point
  std::uint32_t q = 0;
  pool.walk([&](std::uint32_t i, const SubTriangle& piece) {
    const double bound = cornerBound(piece, points[nearest[i]]);
    if (bound <= 0.8 * largest || bound <= reached) {
      floor = std::max(floor, bound);
      return;
    }
    reached = std::max(reached, finder.distance(piece.centroid(), q));
    heap.push_back({bound, piece});
  });
  std::make_heap(heap.begin(), heap.end());
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end());
    const Candidate top = heap.back();
    heap.pop_back();
    if (top.bound <= std::max(floor, reached * (1.0 + kCoverSlack))) return std::max(floor, top.bound);
    reached = std::max(reached, finder.distance(top.piece.centroid(), q));
    const double bound = std::min(top.bound, cornerBound(top.piece, points[q]));
    if (bound <= std::max(floor, reached)) {
      floor = std::max(floor, bound);
      continue;
    }
    SubTriangle halves[2];
    top.piece.split(halves[0], halves[1]);
    for (const SubTriangle& half : halves) {
      finder.distance(half.centroid(), q);
      heap.push_back({std::min(bound, cornerBound(half, points[q])), half});
      std::push_heap(heap.begin(), heap.end());
    }
  }
  return floor;
}

}  // namespace abstand
