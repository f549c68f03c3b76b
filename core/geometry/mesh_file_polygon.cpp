// Polygons into triangles.
#include <vector>

#include "core/geometry/mesh_file_readers.hpp"

namespace abstand::mesh_file {
namespace {

/// Corners looked at in one file while clipping ears; some seconds' worth.
constexpr std::uint64_t kMostWork = 1'000'000'000;

/// Twice the area of a, b, c, positive when they turn left seen against `normal`.
double turn(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal) {
  return (b - a).cross(c - b).dot(normal);
}

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
  // Newell's normal, right for concave polygons too.
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < n; ++i) normal += (p(i) - p(0)).cross(p(i + 1) - p(0));
  bool convex = true;
  for (std::size_t i = 0; n > 3 && i < n; ++i)
    convex = convex && turn(p(i), p(i + 1), p(i + 2), normal) > 0.0;
  if (n == 3 || convex) {
    for (std::size_t i = 1; i + 1 < n; ++i)
      mesh_.triangles.push_back({corners[0], corners[i], corners[i + 1]});
  } else {
    clipEars(corners, normal, pos);
  }
}

void PolygonCutter::clipEars(std::span<const std::uint32_t> corners, const Vector3d& normal,
                             const SourcePos& pos) {
  std::vector<std::uint32_t> left(corners.begin(), corners.end());
  std::size_t i = 0;
  std::size_t refused = 0;  // corners in a row that were no ears
  while (left.size() > 3) {
    const std::size_t n = left.size();
    const auto before = left[(i + n - 1) % n], here = left[i % n], after = left[(i + 1) % n];
    const Vector3d &a = mesh_.vertices[before], &b = mesh_.vertices[here], &c = mesh_.vertices[after];
    // taking the corner out of the list moves n entries, some 16 at a time
    work_ += 1 + n / 16;
    bool ear = turn(a, b, c, normal) > 0.0;
    for (std::size_t k = 2; ear && k + 1 < n; ++k) {
      const auto other = left[(i + k) % n];
      const Vector3d& q = mesh_.vertices[other];
      ++work_;
      // A corner that is an end of the ear too belongs to a bridge to a hole, and is not in the way.
      if (other == before || other == here || other == after) continue;
      ear = !(turn(a, b, q, normal) >= 0.0 && turn(b, c, q, normal) >= 0.0 && turn(c, a, q, normal) >= 0.0);
    }
    if (work_ > kMostWork) throw ParseError(pos, "found polygons too complicated to cut into triangles");
    // A polygon that crosses itself may have no ear left; it is cut anyhow, so that it stays closed.
    if (!ear && ++refused < n) {
      i = (i + 1) % n;
      continue;
    }
    mesh_.triangles.push_back({before, here, after});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i % n));
    // The next but one: fans would give needles.
    i = (i + 1) % left.size();
    refused = 0;
  }
  mesh_.triangles.push_back({left[0], left[1], left[2]});
}

}  // namespace abstand::mesh_file
