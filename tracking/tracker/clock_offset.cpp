#include "tracking/tracker/clock_offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/math/quantile.hpp"
#include "core/math/transform.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::kJointCount;
using humanmodel::SkeletonFrame;

constexpr double kBeside = 0.1;    // s
constexpr double kShortest = 1.0;  // s of overlap
// Share of the shorter recording that must overlap: ends in which nobody moves are alike.
constexpr double kOverlap = 0.6;
constexpr double kMaxStep = 0.15;  // s; no interpolation over longer gaps
constexpr double kOutlier = 0.10;  // m, scale of Geman and McClure
constexpr double kMaxSteps = 1000.0;
constexpr double kNoise = 0.005;  // m; distances below are alike

double usualStep(std::span<const SkeletonFrame> frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  return steps.empty() ? kMaxStep : std::max(nearestQuantile(steps, 0.5), 1e-6);
}

/// Displacement of each joint between the two at one time.
struct Difference {
  std::array<Vector3d, kJointCount> d;
  std::array<bool, kJointCount> has{};
};

bool isTracked(const SkeletonFrame& frame, std::size_t j) {
  return frame.state[j] == humanmodel::JointState::kTracked;
}

/// What `b` (increasing times) has at time `t` minus frame `a`. `from`: index to search on from, updated.
Difference differenceAt(const SkeletonFrame& a, std::span<const SkeletonFrame> b, double t,
                        std::size_t& from) {
  Difference out;
  while (from + 1 < b.size() && b[from + 1].t <= t) ++from;
  if (from + 1 >= b.size() || b[from].t > t || b[from + 1].t - b[from].t > kMaxStep) return out;
  const double s = (t - b[from].t) / (b[from + 1].t - b[from].t);
  for (std::size_t j = 0; j < kJointCount; ++j) {
    out.has[j] = isTracked(a, j) && isTracked(b[from], j) && isTracked(b[from + 1], j);
    if (out.has[j]) out.d[j] = (1.0 - s) * b[from].p[j] + s * b[from + 1].p[j] - a.p[j];
  }
  return out;
}

struct Comparison {
  double cost{kInfinity};  ///< m^2, robust mean square
  double overlap{0.0};     ///< s
};

Comparison compare(std::span<const SkeletonFrame> a, std::span<const SkeletonFrame> b, double offset,
                   double shortest) {
  std::vector<Difference> differences;
  Comparison out;
  std::array<Vector3d, kJointCount> sum;
  std::array<double, kJointCount> count{};
  sum.fill(Vector3d::Zero());
  std::size_t from = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Difference& d = differences.emplace_back(differenceAt(a[i], b, a[i].t - offset, from));
    bool has = false;
    for (std::size_t j = 0; j < kJointCount; ++j) {
      if (!d.has[j]) continue;
      has = true;
      sum[j] += d.d[j];
      count[j] += 1.0;
    }
    if (has && i > 0) out.overlap += std::min(a[i].t - a[i - 1].t, kMaxStep);
  }
  if (out.overlap < shortest) return out;
  double cost = 0.0, all = 0.0;
  for (const Difference& d : differences) {
    for (std::size_t j = 0; j < kJointCount; ++j) {
      if (!d.has[j]) continue;
      const double r2 = (d.d[j] - sum[j] / count[j]).squaredNorm();
      cost += kOutlier * kOutlier * r2 / (kOutlier * kOutlier + r2);
      all += 1.0;
    }
  }
  out.cost = cost / all;
  return out;
}

}  // namespace

ClockOffset estimateClockOffset(std::span<const SkeletonFrame> first, std::span<const SkeletonFrame> second) {
  ClockOffset best;
  if (first.empty() || second.empty()) return best;
  const double duration = std::min(first.back().t - first.front().t, second.back().t - second.front().t);
  const double shortest = std::max(kShortest, kOverlap * duration);
  // Steps of one image: images are then interpolated at the same share everywhere. A share of a half takes
  // off more of the noise than one of zero, and would always look better.
  const double step = usualStep(second);
  const auto steps = static_cast<int>(std::min(kMaxSteps, ClockOffset::kFarthest / step));
  Comparison at;
  for (int k = -steps; k <= steps; ++k) {
    const Comparison c = compare(first, second, k * step, shortest);
    if (c.cost >= at.cost) continue;
    at = c;
    best.offset = k * step;
  }
  if (at.cost == kInfinity) return best;
  const double before = compare(first, second, best.offset - step, shortest).cost,
               after = compare(first, second, best.offset + step, shortest).cost;
  const double bend = before - 2.0 * at.cost + after;
  const double beside = std::min(compare(first, second, best.offset - kBeside, shortest).cost,
                                 compare(first, second, best.offset + kBeside, shortest).cost);
  if (std::isfinite(bend) && bend > 0.0) best.offset += 0.5 * step * (before - after) / bend;
  best.apart = std::sqrt(at.cost);
  best.at_zero = std::sqrt(compare(first, second, 0.0, shortest).cost);
  best.overlap = at.overlap;
  best.decided = beside + kNoise * kNoise >= ClockOffset::kDecides * (at.cost + kNoise * kNoise);
  return best;
}

bool ClockOffset::refutesZero() const {
  return at_zero * at_zero + kNoise * kNoise >= kDecides * (apart * apart + kNoise * kNoise);
}

}  // namespace abstand::tracking
