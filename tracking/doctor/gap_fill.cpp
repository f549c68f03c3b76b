#include "tracking/doctor/gap_fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/quantile.hpp"
#include "humanmodel/part_uncertainty.hpp"

namespace abstand::tracking {
namespace {

using J = humanmodel::Joint;
/// Bones of the limbs, proximal joint first, from the trunk outwards.
constexpr std::array<std::pair<J, J>, 12> kLimbs{{{J::kShoulderLeft, J::kElbowLeft},
                                                  {J::kElbowLeft, J::kWristLeft},
                                                  {J::kWristLeft, J::kHandLeft},
                                                  {J::kShoulderRight, J::kElbowRight},
                                                  {J::kElbowRight, J::kWristRight},
                                                  {J::kWristRight, J::kHandRight},
                                                  {J::kHipLeft, J::kKneeLeft},
                                                  {J::kKneeLeft, J::kAnkleLeft},
                                                  {J::kAnkleLeft, J::kToeLeft},
                                                  {J::kHipRight, J::kKneeRight},
                                                  {J::kKneeRight, J::kAnkleRight},
                                                  {J::kAnkleRight, J::kToeRight}}};

bool has(const humanmodel::SkeletonFrame& f, std::size_t j) {
  return f.state[j] != humanmodel::JointState::kMissing;
}

/// Velocity at a known frame, from it and its known neighbour away from the gap; zero if there is none.
Vector3d velocityAt(const std::vector<humanmodel::SkeletonFrame>& frames, std::size_t j, std::size_t at,
                    bool before_gap) {
  const bool has_neighbour = before_gap ? at > 0 : at + 1 < frames.size();
  if (!has_neighbour) return Vector3d::Zero();
  const humanmodel::SkeletonFrame &a = frames[at], &b = frames[before_gap ? at - 1 : at + 1];
  if (!has(b, j) || a.t == b.t) return Vector3d::Zero();
  return (a.p[j] - b.p[j]) / (a.t - b.t);
}

/// Fills frames first..last of one joint, which is known at first - 1 and last + 1.
void fillOne(std::vector<humanmodel::SkeletonFrame>& frames, std::size_t j, std::size_t first,
             std::size_t last) {
  const humanmodel::SkeletonFrame &a = frames[first - 1], &b = frames[last + 1];
  const double dt = b.t - a.t;
  const Vector3d va = velocityAt(frames, j, first - 1, true), vb = velocityAt(frames, j, last + 1, false);
  for (std::size_t i = first; i <= last; ++i) {
    const double s = (frames[i].t - a.t) / dt, s2 = s * s, s3 = s2 * s;
    frames[i].set(static_cast<J>(j),
                  (2 * s3 - 3 * s2 + 1) * a.p[j] + (s3 - 2 * s2 + s) * dt * va + (3 * s2 - 2 * s3) * b.p[j] +
                      (s3 - s2) * dt * vb,
                  humanmodel::JointState::kInferred);
    // Uncertainty of the ends, plus the possible motion since.
    const double unseen = std::min(frames[i].t - a.t, b.t - frames[i].t);
    if (frames[i].covariance.isStated()) frames[i].covariance[j].setZero();
    if (frames[i].lateral.isStated()) frames[i].lateral[j].setZero();
    frames[i].spread[j] =
        std::max(a.spread[j], b.spread[j]) + unseen * humanmodel::kPersonSpeed / humanmodel::kSpreadQuantile;
  }
}

}  // namespace

GapFill fillGaps(std::vector<humanmodel::SkeletonFrame>& frames, double longest) {
  GapFill result;
  std::vector<std::array<bool, humanmodel::kJointCount>> filled(frames.size());
  for (auto& f : filled) f.fill(false);

  // Lengths of the bones in frames with both ends.
  std::array<double, kLimbs.size()> length;
  for (std::size_t b = 0; b < kLimbs.size(); ++b) {
    std::vector<double> lengths;
    for (const auto& f : frames)
      if (f.has(kLimbs[b].first) && f.has(kLimbs[b].second))
        lengths.push_back((f[kLimbs[b].second] - f[kLimbs[b].first]).norm());
    length[b] = nearestQuantile(std::move(lengths), 0.5);
  }

  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (has(frames[i], j)) continue;
      std::size_t end = i;
      while (end < frames.size() && !has(frames[end], j)) ++end;
      if (i > 0 && end < frames.size() && frames[end].t - frames[i - 1].t <= longest) {
        fillOne(frames, j, i, end - 1);
        for (std::size_t k = i; k < end; ++k) filled[k][j] = true;
        result.filled += end - i;
      } else if (i > 0 || end < frames.size()) {
        result.left += end - i;
      }
      i = end;
    }

  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t b = 0; b < kLimbs.size(); ++b) {
      const auto [inner, outer] = kLimbs[b];
      if (!filled[i][static_cast<std::size_t>(outer)] || !frames[i].has(inner)) continue;
      const Vector3d bone = frames[i][outer] - frames[i][inner];
      if (bone.norm() > 0.0 && std::isfinite(length[b]))
        frames[i].set(outer, frames[i][inner] + bone * (length[b] / bone.norm()),
                      humanmodel::JointState::kInferred);
    }
  return result;
}

}  // namespace abstand::tracking
