#include "tracking/recording/proportions.hpp"

#include <array>
#include <cmath>

#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/recording_lengths.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kFewestBones = 3;

/// A distance of joints beside a measure of the body, with the limits of its deviation.
struct UsualDistance {
  const char* name;
  humanmodel::Joint a, b;
  double measure;  ///< m
  double shortest, longest;
};

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

/// Those of a person of that stature, m.
std::array<UsualDistance, 4> usualDistances(double stature) {
  using J = humanmodel::Joint;
  constexpr double kHeight = 1.75;  // m; all measures are shares of it
  const double mass = humanmodel::meanBodyMassIndex(std::nullopt) * kHeight * kHeight;
  const humanmodel::BodyMeasures body = humanmodel::measuresOf(kHeight, mass, std::nullopt);
  const double scale = stature / kHeight, foot = scale * body.foot_length;
  return {
      {{"shoulder_breadth", J::kShoulderLeft, J::kShoulderRight, scale * body.biacromial_breadth, -0.4, 0.5},
       {"hip_breadth", J::kHipLeft, J::kHipRight, scale * body.hip_breadth, -0.7, -0.05},
       {"foot_left", J::kAnkleLeft, J::kToeLeft, foot, -0.8, 0.1},
       {"foot_right", J::kAnkleRight, J::kToeRight, foot, -0.8, 0.1}}};
}

}  // namespace

std::vector<BoneProportion> proportionsOf(std::span<const humanmodel::SkeletonFrame> frames) {
  const auto measured = measuredJoints(frames);
  const auto fit = humanmodel::fitLengths({}, measured);
  if (!fit || fit->bones.size() < kFewestBones) return {};
  std::vector<double> ratios;
  for (const auto& bone : fit->bones) ratios.push_back(bone.median / bone.model);
  const double ratio = nearestQuantile(ratios, 0.5);
  std::vector<BoneProportion> bones;
  for (const auto& bone : fit->bones)
    bones.push_back({std::string(humanmodel::partName(bone.part)), bone.median, ratio * bone.model});
  for (const UsualDistance& usual : usualDistances(ratio * fit->stature))
    if (const auto length = humanmodel::medianBone(measured, usual.a, usual.b))
      bones.push_back({usual.name, *length, usual.measure, usual.shortest, usual.longest});
  return bones;
}

std::string oddProportions(std::span<const BoneProportion> bones) {
  std::string odd;
  for (const BoneProportion& bone : bones)
    if (bone.isOdd())
      odd += (odd.empty() ? "" : ", ") + bone.part + " " + text::rounded(100.0 * std::abs(bone.off()), 0) +
             " % " + (bone.off() > 0.0 ? "longer" : "shorter");
  if (odd.empty()) return {};
  return "disproportionate bones (ANSUR II): " + odd + ": the joints may be misnamed";
}

}  // namespace abstand::tracking
