#include "tracking/conversion.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/body_size.hpp"
#include "tracking/derived_joints.hpp"
#include "tracking/message_text.hpp"
#include "tracking/part_joints.hpp"
#include "tracking/up_axis.hpp"

namespace abstand {
namespace {

/// The lowest foot of a recording that stands on the floor is nearer to z = 0 than this (m).
constexpr double kFloorDistance = 0.3;

void turnAndScale(std::vector<SkeletonFrame>& frames, const Matrix3d& R, double scale) {
  if (scale == 1.0 && R == Matrix3d::Identity()) return;  // keeps every bit, the sign of a zero too
  for (auto& f : frames)
    for (std::size_t j = 0; j < kJointCount; ++j)
      if (f.state[j] != JointState::kMissing) f.p[j] = scale * (R * f.p[j]);
}

/// Fills `mapped`, `not_mapped` and `missing_parts`.
void reportParts(const RawRecording& raw, const std::vector<SkeletonFrame>& frames, RecordingReport& report) {
  const auto known = [&](Joint j) {
    return std::any_of(frames.begin(), frames.end(), [j](const SkeletonFrame& f) { return f.has(j); });
  };
  const auto used_as_found = [&](Joint j) {
    return raw.is_canonical || std::any_of(frames.begin(), frames.end(), [j](const SkeletonFrame& f) {
             return f.state[static_cast<std::size_t>(j)] == JointState::kTracked;
           });
  };
  std::vector<bool> used(raw.joints.size(), false);
  std::string sentence;
  for (const auto& part : partJoints()) {
    std::vector<std::string> names;
    for (const Joint j : part.joints) {
      const int i = raw.match.joint[static_cast<std::size_t>(j)];
      if (i < 0 || !used_as_found(j)) continue;
      used[static_cast<std::size_t>(i)] = true;
      names.push_back(raw.joints[static_cast<std::size_t>(i)]);
    }
    std::string missing;
    for (const Joint j : {part.joints.front(), part.joints.back()})
      if (!known(j)) missing += (missing.empty() ? "" : " and ") + std::string(jointName(j));
    if (missing.empty()) {
      report.mapped[std::string(part.part)] = std::move(names);
    } else {
      report.missing_parts.emplace_back(part.part);
      sentence += (sentence.empty() ? "" : ", ") + std::string(part.part) + " (no " + missing + ")";
    }
  }
  if (!sentence.empty()) report.warnings.push_back("parts that this file cannot move: " + sentence);
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) report.not_mapped.push_back(raw.joints[i]);
}

/// Frames in which a joint that the recording has elsewhere is missing.
std::size_t countGaps(const std::vector<SkeletonFrame>& frames) {
  std::array<bool, kJointCount> somewhere{};
  for (const auto& f : frames)
    for (std::size_t j = 0; j < kJointCount; ++j) somewhere[j] |= f.state[j] != JointState::kMissing;
  return static_cast<std::size_t>(std::count_if(frames.begin(), frames.end(), [&](const SkeletonFrame& f) {
    for (std::size_t j = 0; j < kJointCount; ++j)
      if (somewhere[j] && f.state[j] == JointState::kMissing) return true;
    return false;
  }));
}

/// True where the person's left is on the right of where the toes point to, in most frames.
bool isMirrored(const std::vector<SkeletonFrame>& frames) {
  using J = Joint;
  int left = 0, right = 0;
  for (const auto i : sampleIndices(frames.size())) {
    const auto& f = frames[i];
    const bool all = f.has(J::kHipLeft) && f.has(J::kHipRight) && f.has(J::kAnkleLeft) &&
                     f.has(J::kToeLeft) && f.has(J::kAnkleRight) && f.has(J::kToeRight);
    if (!all) continue;
    const Vector3d forward = f[J::kToeLeft] - f[J::kAnkleLeft] + f[J::kToeRight] - f[J::kAnkleRight];
    const double side = Vector3d::UnitZ().cross(forward).dot(f[J::kHipLeft] - f[J::kHipRight]);
    ++(side >= 0.0 ? left : right);
  }
  return right > left;
}

/// How often the line from hip to hip turns by more than 90 degrees between two frames: a tracker swapped
/// sides.
std::size_t countSideSwaps(const std::vector<SkeletonFrame>& frames) {
  using J = Joint;
  std::size_t swaps = 0;
  for (std::size_t i = 2; i < frames.size(); ++i) {
    const auto &a = frames[i - 1], &b = frames[i];
    if (a.has(J::kHipLeft) && a.has(J::kHipRight) && b.has(J::kHipLeft) && b.has(J::kHipRight) &&
        (a[J::kHipLeft] - a[J::kHipRight]).dot(b[J::kHipLeft] - b[J::kHipRight]) < 0.0)
      ++swaps;
  }
  return swaps;
}

void warnOfPlace(const std::vector<SkeletonFrame>& frames, std::vector<std::string>& warnings) {
  double lowest = kInfinity;
  for (const auto& f : frames)
    for (const Joint j : {Joint::kAnkleLeft, Joint::kAnkleRight, Joint::kToeLeft, Joint::kToeRight})
      if (f.has(j)) lowest = std::min(lowest, f[j].z());
  if (std::isfinite(lowest) && std::abs(lowest) > kFloorDistance)
    warnings.push_back("the lowest foot of the recording is at z = " + rounded(lowest, 2) +
                       " m, not on the floor: place the recording by " + rounded(-lowest, 2) + " m in z");
}

}  // namespace

Recording convert(RawRecording raw, const RecordingOptions& options) {
  ABSTAND_CHECK(!raw.frames.empty());
  Recording out;
  RecordingReport& report = out.report;
  report.format = raw.format;
  report.rate = raw.rate;
  report.duration = raw.frames.back().t - raw.frames.front().t;
  report.joints = raw.joints;
  report.joint_map = raw.match.map;
  for (const auto& w : raw.warnings)
    report.warnings.push_back(w.line > 0 ? std::to_string(w.line) + ": " + w.text : w.text);

  const auto add = [&](const std::string& warning) {
    if (!warning.empty()) report.warnings.push_back(warning);
  };
  if (!raw.is_canonical)
    for (const auto& sentence : deriveJoints(raw.rest, raw.frames)) add(sentence);
  const auto stature = measureStature(raw.rest, raw.frames);
  const bool units_known = raw.is_canonical && options.units == "auto",
             up_known = raw.is_canonical && options.up == "auto";
  const UnitChoice unit =
      units_known ? UnitChoice{"m", "the format's own", 1.0, ""} : chooseUnit(options.units, stature);
  const UpChoice up =
      up_known ? UpChoice{"z", "the format's own", ""} : chooseUp(options.up, raw.rest, raw.frames);
  add(unit.warning);
  add(up.warning);
  report.units_guess = unit.name;
  report.units_reason = unit.reason;
  report.scale = unit.scale;
  report.up = up.axis;
  report.up_reason = up.reason;
  report.stature = stature ? *stature * unit.scale : 0.0;

  turnAndScale(raw.frames, rotationToZUp(up.axis), unit.scale);
  reportParts(raw, raw.frames, report);
  report.gaps = countGaps(raw.frames);
  if (isMirrored(raw.frames))
    add("left and right look swapped: the left hip is on the right of where the toes point");
  if (const auto swaps = countSideSwaps(raw.frames); swaps > 0)
    add("the hips turn by more than 90 degrees between two frames " + std::to_string(swaps) +
        " times: left and right may be swapped there");
  warnOfPlace(raw.frames, report.warnings);
  out.frames = std::move(raw.frames);
  return out;
}

}  // namespace abstand
