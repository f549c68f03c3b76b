// Lofted closed meshes through cross-sections.
#include "tracking/depth/simulator/skin_loft.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uint32_t kAround = 28;

double rounded(double x, double n) { return std::copysign(std::pow(std::abs(x), 2.0 / n), x); }

}  // namespace

geometry::TriangleMesh loft(std::span<const LoftSection> sections) {
  ABSTAND_CHECK(sections.size() >= 2);
  geometry::TriangleMesh mesh;
  for (const LoftSection& s : sections) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double angle = 2.0 * kPi * i / kAround;
      mesh.vertices.emplace_back(s.centre + s.a * rounded(std::cos(angle), s.n) * s.u +
                                 s.b * rounded(std::sin(angle), s.n) * s.v);
    }
  }
  const auto count = static_cast<std::uint32_t>(sections.size());
  const auto at = [](std::uint32_t ring, std::uint32_t i) { return ring * kAround + i % kAround; };
  const std::uint32_t first = count * kAround, last = first + 1;
  mesh.vertices.push_back(sections.front().centre);
  mesh.vertices.push_back(sections.back().centre);
  for (std::uint32_t i = 0; i < kAround; ++i) {
    mesh.triangles.push_back({first, at(0, i + 1), at(0, i)});
    for (std::uint32_t ring = 0; ring + 1 < count; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
    mesh.triangles.push_back({last, at(count - 1, i), at(count - 1, i + 1)});
  }
  return mesh;
}

double smoothCurve(std::span<const CurvePoint> points, double x) {
  ABSTAND_CHECK(!points.empty());
  if (x <= points.front().x) return points.front().y;
  if (x >= points.back().x) return points.back().y;
  std::size_t k = 0;
  while (x > points[k + 1].x) ++k;
  const auto step = [&](std::size_t i) { return points[i + 1].x - points[i].x; };
  const auto slope = [&](std::size_t i) { return (points[i + 1].y - points[i].y) / step(i); };
  // Slope at a point: 0 at the ends and at turning points, otherwise the weighted harmonic mean.
  const auto tangent = [&](std::size_t i) {
    if (i == 0 || i + 1 == points.size() || slope(i - 1) * slope(i) <= 0.0) return 0.0;
    const double before = 2.0 * step(i) + step(i - 1), after = step(i) + 2.0 * step(i - 1);
    return (before + after) / (before / slope(i - 1) + after / slope(i));
  };
  const double h = step(k), t = (x - points[k].x) / h, s = 1.0 - t;
  return points[k].y * (1.0 + 2.0 * t) * s * s + tangent(k) * h * t * s * s +
         points[k + 1].y * (1.0 + 2.0 * s) * t * t - tangent(k + 1) * h * s * t * t;
}

}  // namespace abstand::tracking
