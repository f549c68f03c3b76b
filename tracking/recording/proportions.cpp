#include "tracking/recording/proportions.hpp"

#include <cmath>

#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"
#include "humanmodel/recording_lengths.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kFewestBones = 3;

/// Some frames with the joints that were measured.
std::vector<humanmodel::SkeletonFrame> measuredJoints(std::span<const humanmodel::SkeletonFrame> frames) {
  std::vector<humanmodel::SkeletonFrame> some;
  for (const std::size_t i : sampleIndices(frames.size())) {
    humanmodel::SkeletonFrame f = frames[i];
    for (auto& state : f.state)
      if (state != humanmodel::JointState::kTracked) state = humanmodel::JointState::kMissing;
    some.push_back(f);
  }
  return some;
}

}  // namespace

bool BoneProportion::isOdd() const { return std::abs(off()) > kOddProportion; }

std::vector<BoneProportion> proportionsOf(std::span<const humanmodel::SkeletonFrame> frames) {
  const auto fit = humanmodel::fitLengths({}, measuredJoints(frames));
  if (!fit || fit->bones.size() < kFewestBones) return {};
  std::vector<double> ratios;
  for (const auto& bone : fit->bones) ratios.push_back(bone.median / bone.model);
  const double ratio = nearestQuantile(ratios, 0.5);
  std::vector<BoneProportion> bones;
  for (const auto& bone : fit->bones) bones.push_back({bone.part, bone.median, ratio * bone.model});
  return bones;
}

std::string oddProportions(std::span<const BoneProportion> bones) {
  std::string odd;
  for (const BoneProportion& bone : bones)
    if (bone.isOdd())
      odd += (odd.empty() ? "" : ", ") + std::string(humanmodel::partName(bone.part)) + " " +
             text::rounded(100.0 * std::abs(bone.off()), 0) + " % " +
             (bone.off() > 0.0 ? "longer" : "shorter");
  if (odd.empty()) return {};
  return "disproportionate bones (ANSUR II): " + odd + ": the joints may be misnamed";
}

}  // namespace abstand::tracking
