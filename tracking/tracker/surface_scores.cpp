// The loop over the points, for each kind of surface and for two instruction sets.
#include "tracking/tracker/surface_scores.hpp"

#include <cmath>

#include "core/base/simd.hpp"

namespace abstand::tracking {
namespace {

/// A surface as the loop over the points needs it.
struct PlacedSurface {
  std::array<float, 9> r;        ///< rotation from the world to the segment, row by row
  std::array<float, 3> c;        ///< centre, m, world
  std::array<float, 3> inverse;  ///< 1 / semi-axis, 1/m
  bool drum;
};

/// Where the misfits go.
struct Target {
  float* best;
  std::int32_t* segment{nullptr};
  std::int32_t index{0};
};

PlacedSurface placed(const FitSurface& s, const Transform& X_WS) {
  const Eigen::Matrix3f R = X_WS.linear().cast<float>();
  const Vector3f c = (X_WS * s.centre.cast<double>()).cast<float>();
  return {{R(0, 0), R(1, 0), R(2, 0), R(0, 1), R(1, 1), R(2, 1), R(0, 2), R(1, 2), R(2, 2)},
          {c.x(), c.y(), c.z()},
          {1.0f / s.semi.x(), 1.0f / s.semi.y(), 1.0f / s.semi.z()},
          s.drum};
}

/// The loop over the points. Template parameters instead of branches: the kind of surface, whether there is
/// an extra term, and whether `segment` is set. Compiled into each of its callers, for their instruction set.
template <bool kDrum, bool kExtra, bool kAssign>
[[gnu::always_inline]] inline void scoreAs(const PlacedSurface& s, const ScoredPoints& of, const Target& to) {
  const auto [r0, r1, r2, r3, r4, r5, r6, r7, r8] = s.r;
  const auto [cx, cy, cz] = s.c;
  const auto [ia, ib, ic] = s.inverse;
  const SeenPoints& points = of.points;
  const float normal_weight = of.normal_weight;
  const std::size_t count = points.count;
  const float* __restrict extra = of.extra;
  float* __restrict best = to.best;
  std::int32_t* __restrict segment = to.segment;
  const std::int32_t index = to.index;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = points.x[i] - cx, y = points.y[i] - cy, z = points.z[i] - cz;
    const float qa = (r0 * x + r1 * y + r2 * z) * ia, qb = (r3 * x + r4 * y + r5 * z) * ib,
                qc = (r6 * x + r7 * y + r8 * z) * ic;
    const float round = qa * qa + qb * qb, flat = qc * qc;
    const float level = kDrum ? std::sqrt(std::sqrt(round * round + flat * flat)) : std::sqrt(round + flat);
    // Gradient times level^3 (drum) or level.
    const float ga = (kDrum ? round * qa : qa) * ia, gb = (kDrum ? round * qb : qb) * ib,
                gc = (kDrum ? flat * qc : qc) * ic;
    const float scale = kDrum ? level * level * level : level;
    const float inverse = 1.0f / (std::sqrt(ga * ga + gb * gb + gc * gc) + 1e-9f);
    const float nx = points.nx[i], ny = points.ny[i], nz = points.nz[i];
    const float along = ((r0 * nx + r1 * ny + r2 * nz) * ga + (r3 * nx + r4 * ny + r5 * nz) * gb +
                         (r6 * nx + r7 * ny + r8 * nz) * gc) *
                        inverse;
    const float misfit = std::abs((level - 1.0f) * scale * inverse) + normal_weight * (1.0f - along);
    const float score = kExtra ? misfit + extra[i] : misfit;
    if (kAssign) segment[i] = score < best[i] ? index : segment[i];
    best[i] = score < best[i] ? score : best[i];
  }
}

template <bool kAssign>
[[gnu::always_inline]] inline void scoreAny(const PlacedSurface& s, const ScoredPoints& of,
                                            const Target& to) {
  if (s.drum)
    of.extra ? scoreAs<true, true, kAssign>(s, of, to) : scoreAs<true, false, kAssign>(s, of, to);
  else
    of.extra ? scoreAs<false, true, kAssign>(s, of, to) : scoreAs<false, false, kAssign>(s, of, to);
}

void lower(const PlacedSurface& s, const ScoredPoints& of, const Target& to) { scoreAny<false>(s, of, to); }
void assign(const PlacedSurface& s, const ScoredPoints& of, const Target& to) { scoreAny<true>(s, of, to); }

#if defined(__x86_64__)
[[gnu::target("avx2")]] void lowerWithAvx2(const PlacedSurface& s, const ScoredPoints& of, const Target& to) {
  scoreAny<false>(s, of, to);
}
[[gnu::target("avx2")]] void assignWithAvx2(const PlacedSurface& s, const ScoredPoints& of,
                                            const Target& to) {
  scoreAny<true>(s, of, to);
}
#else
constexpr auto lowerWithAvx2 = lower, assignWithAvx2 = assign;
#endif

}  // namespace

void scoreOf(const FitSurface& s, const Transform& X_WS, const ScoredPoints& of, float* best) {
  (usesAvx2() ? lowerWithAvx2 : lower)(placed(s, X_WS), of, {best});
}

void assignOf(const FitSurface& s, const Transform& X_WS, const ScoredPoints& of, std::int32_t index,
              float* best, std::int32_t* segment) {
  (usesAvx2() ? assignWithAvx2 : assign)(placed(s, X_WS), of, {best, segment, index});
}

}  // namespace abstand::tracking
