#include "tracking/recording/exchanged_limbs.hpp"

#include <algorithm>
#include <array>

#include "core/math/quantile.hpp"
#include "core/math/transform.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

/// Cosine of the largest angle between shoulders and hips that a person reaches, with a wide margin.
constexpr double kFarthestTwist = -0.5;
/// Variation of the other side's distance, share of that of the own one; and the smallest of the own one,
/// share of the length.
constexpr double kRigidShare = 0.25, kVaries = 0.0005;
constexpr std::size_t kFewestMoments = 10;
/// Distance by which knees or elbows are on each other's side, share of that of hips or shoulders.
constexpr double kOnOtherSide = 0.6, kNearlyAllMoments = 0.95;

/// A bone of the left side; the right joints are four later.
struct LeftBone {
  Joint inner, outer;
  const char *inner_name, *outer_name;
  bool stays_on_side{false};  ///< nobody crosses both outer joints by kOnOtherSide for long
};
constexpr std::array<LeftBone, 6> kLeftBones{
    {{Joint::kShoulderLeft, Joint::kElbowLeft, "shoulder", "elbow", true},
     {Joint::kElbowLeft, Joint::kWristLeft, "elbow", "wrist"},
     {Joint::kWristLeft, Joint::kHandLeft, "wrist", "hand"},
     {Joint::kHipLeft, Joint::kKneeLeft, "hip", "knee", true},
     {Joint::kKneeLeft, Joint::kAnkleLeft, "knee", "ankle"},
     {Joint::kAnkleLeft, Joint::kToeLeft, "ankle", "toe"}}};

Joint rightOf(Joint left) { return static_cast<Joint>(static_cast<int>(left) + 4); }

bool wasMeasured(const SkeletonFrame& f, Joint j) {
  return f.state[static_cast<std::size_t>(j)] == humanmodel::JointState::kTracked;
}

/// Distances of two joints over frames, m.
struct EndDistances {
  std::vector<double> all;
  double median() const { return nearestQuantile(all, 0.5); }
  double range() const { return nearestQuantile(all, 0.95) - nearestQuantile(all, 0.05); }
};

/// The sentence on a bone; empty: its ends are on the same side, or that does not show.
std::string exchangeOf(const LeftBone& bone, std::span<const SkeletonFrame> frames,
                       std::span<const std::size_t> sample) {
  const std::array<Joint, 2> inner{bone.inner, rightOf(bone.inner)}, outer{bone.outer, rightOf(bone.outer)};
  std::array<EndDistances, 2> own, other;
  std::size_t crossed = 0;
  for (const std::size_t i : sample) {
    const SkeletonFrame& f = frames[i];
    if (!wasMeasured(f, inner[0]) || !wasMeasured(f, inner[1]) || !wasMeasured(f, outer[0]) ||
        !wasMeasured(f, outer[1]))
      continue;
    const Vector3d across = f[inner[0]] - f[inner[1]];
    crossed += across.dot(f[outer[0]] - f[outer[1]]) < -kOnOtherSide * across.squaredNorm() ? 1 : 0;
    for (std::size_t side = 0; side < 2; ++side) {
      own[side].all.push_back((f[inner[side]] - f[outer[side]]).norm());
      other[side].all.push_back((f[inner[side]] - f[outer[1 - side]]).norm());
    }
  }
  if (own[0].all.size() < kFewestMoments) return {};
  std::size_t rigid = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const double varies = own[side].range();
    if (other[side].range() > varies || other[side].median() > own[side].median()) return {};
    rigid += varies > kVaries * own[side].median() && other[side].range() < kRigidShare * varies ? 1 : 0;
  }
  // A limb that swings across the line of its inner joints keeps both distances.
  const bool is_crossed =
      bone.stays_on_side &&
      static_cast<double>(crossed) > kNearlyAllMoments * static_cast<double>(own[0].all.size());
  if (rigid < (is_crossed ? 1u : 2u)) return {};
  const std::string in = bone.inner_name, out = bone.outer_name;
  return "left and right seem exchanged from the " + out + "s on: the distance from the left " + in +
         " to the left " + out + " varies by " + text::rounded(1000.0 * own[0].range(), 1) +
         " mm, that to the right " + out + " by " + text::rounded(1000.0 * other[0].range(), 1) + " mm";
}

}  // namespace

std::optional<OpposedShoulders> opposedShoulders(std::span<const SkeletonFrame> frames) {
  OpposedShoulders found;
  for (const std::size_t i : sampleIndices(frames.size())) {
    const SkeletonFrame& f = frames[i];
    if (!f.has(Joint::kShoulderLeft) || !f.has(Joint::kShoulderRight) || !f.has(Joint::kHipLeft) ||
        !f.has(Joint::kHipRight))
      continue;
    const Vector3d trunk =
        f[Joint::kShoulderLeft] + f[Joint::kShoulderRight] - f[Joint::kHipLeft] - f[Joint::kHipRight];
    if (!(trunk.norm() > 0.0)) continue;
    const Vector3d up = trunk.normalized();
    const auto across = [&](Joint left) -> Vector3d {
      const Vector3d line = f[left] - f[rightOf(left)];
      return line - up.dot(line) * up;
    };
    const Vector3d shoulders = across(Joint::kShoulderLeft), hips = across(Joint::kHipLeft);
    ++found.of;
    found.frames += shoulders.dot(hips) < kFarthestTwist * shoulders.norm() * hips.norm() ? 1 : 0;
  }
  return 2 * found.frames > found.of ? std::optional(found) : std::nullopt;
}

std::vector<std::string> exchangedLimbs(std::span<const SkeletonFrame> frames) {
  const std::vector<std::size_t> sample = sampleIndices(frames.size());
  std::vector<std::string> sentences;
  for (const LeftBone& bone : kLeftBones)
    if (std::string sentence = exchangeOf(bone, frames, sample); !sentence.empty())
      sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace abstand::tracking
