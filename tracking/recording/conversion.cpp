#include "tracking/recording/conversion.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/message_line.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/derived_joints.hpp"
#include "tracking/recording/exchanged_limbs.hpp"
#include "tracking/recording/first_pose.hpp"
#include "tracking/recording/part_joints.hpp"
#include "tracking/recording/stated_twist.hpp"

namespace abstand::tracking {
namespace {

/// m; largest height of the lowest foot in a recording on the floor.
constexpr double kFloorDistance = 0.3;
/// Share by which a stature along the bones may differ from the stated one.
constexpr double kStaturesDiffer = 0.07;

void turnAndScale(std::vector<humanmodel::SkeletonFrame>& frames, const Matrix3d& R, double scale) {
  if (scale == 1.0 && R == Matrix3d::Identity()) return;  // preserves every bit, including the sign of zero
  for (auto& f : frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (f.state[j] != humanmodel::JointState::kMissing) {
        f.p[j] = scale * (R * f.p[j]);
        f.spread[j] *= scale;
        if (f.covariance.isStated()) f.covariance[j] = scale * scale * R * f.covariance[j] * R.transpose();
        if (f.lateral.isStated()) f.lateral[j] = (R.cast<float>() * f.lateral[j]).eval();
      }
}

/// Raises the spreads (m) to the errors of the sensor; the file states none.
void stateSensorError(const SensorError& sensor, std::vector<humanmodel::SkeletonFrame>& frames,
                      RecordingReport& report) {
  for (humanmodel::SkeletonFrame& f : frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (f.state[j] == humanmodel::JointState::kMissing) continue;
      const bool is_tracked = f.state[j] == humanmodel::JointState::kTracked;
      f.spread[j] = std::max(f.spread[j], is_tracked ? sensor.tracked : sensor.inferred);
    }
  report.notes.push_back(
      "the file states no errors: joints have the published ones of the sensor, standard "
      "deviation of an axis " +
      text::rounded(sensor.tracked, 3) + " m if tracked, " + text::rounded(sensor.inferred, 3) +
      " m if inferred or derived (" + sensor.source + ")");
}

/// The points of the file that define a joint.
std::vector<std::size_t> pointsOf(const JointMatch& match, humanmodel::Joint j, std::size_t points) {
  const int joint = match.joint[static_cast<std::size_t>(j)];
  if (joint < 0) return {};
  const auto i = static_cast<std::size_t>(joint);
  if (i < points) return {i};
  const auto& mean = match.means[i - points];
  return {mean.begin(), mean.end()};
}

bool isLimb(const PartJoints& part) {
  const bool is_long = part.part.starts_with("biceps") || part.part.starts_with("forearm");
  return is_long || part.part.starts_with("thigh") || part.part.starts_with("calf");
}

/// True if both ends of a part are known together and always coincide: such a bone has no direction.
bool hasNoLength(const PartJoints& part, const std::vector<humanmodel::SkeletonFrame>& frames) {
  constexpr double kNoLength = 1e-6;  // m
  bool is_known = false;
  for (const auto& f : frames) {
    if (!f.has(part.joints.front()) || !f.has(part.joints.back())) continue;
    is_known = true;
    if ((f[part.joints.front()] - f[part.joints.back()]).norm() > kNoLength) return false;
  }
  return is_known;
}

/// Sets `no_body` if no bone of a limb that is known has a length.
void findNoBody(const std::vector<humanmodel::SkeletonFrame>& frames, RecordingReport& report) {
  std::size_t known = 0, without_length = 0;
  for (const auto& part : partJoints()) {
    if (!isLimb(part)) continue;
    without_length += hasNoLength(part, frames) ? 1 : 0;
    known += std::any_of(frames.begin(), frames.end(), [&](const humanmodel::SkeletonFrame& f) {
      return f.has(part.joints.front()) && f.has(part.joints.back());
    });
  }
  if (known > 0 && known == without_length)
    report.person.no_body = "the ends of all " + std::to_string(known) +
                            " bones of arms and legs coincide in every frame (in a BVH file: OFFSETs of 0)";
}

/// Sets `mapped`, `not_mapped`, `missing_parts` and `no_body`.
void reportParts(const RawRecording& raw, const std::vector<humanmodel::SkeletonFrame>& frames,
                 RecordingReport& report) {
  const auto known = [&](humanmodel::Joint j) {
    return std::any_of(frames.begin(), frames.end(),
                       [j](const humanmodel::SkeletonFrame& f) { return f.has(j); });
  };
  const auto used_as_found = [&](humanmodel::Joint j) {
    return raw.is_canonical ||
           std::any_of(frames.begin(), frames.end(), [j](const humanmodel::SkeletonFrame& f) {
             return f.state[static_cast<std::size_t>(j)] == humanmodel::JointState::kTracked;
           });
  };
  findNoBody(frames, report);
  std::vector<bool> used(raw.joints.size(), false);
  std::string sentence;
  for (const auto& part : partJoints()) {
    std::vector<std::string> names;
    for (const humanmodel::Joint j : part.joints) {
      for (const std::size_t i : pointsOf(raw.match, j, raw.joints.size())) {
        if (!used_as_found(j)) continue;
        used[i] = true;
        if (std::find(names.begin(), names.end(), raw.joints[i]) == names.end())
          names.push_back(raw.joints[i]);
      }
    }
    std::string missing;
    for (const humanmodel::Joint j : {part.joints.front(), part.joints.back()})
      if (!known(j)) missing += (missing.empty() ? "" : " and ") + std::string(humanmodel::jointName(j));
    if (missing.empty() && (!report.person.no_body.empty() || (isLimb(part) && hasNoLength(part, frames))))
      missing = "length";
    if (missing.empty()) {
      report.mapped[std::string(part.part)] = std::move(names);
    } else {
      report.missing_parts.emplace_back(part.part);
      sentence += (sentence.empty() ? "" : ", ") + std::string(part.part) + " (no " + missing + ")";
    }
  }
  if (!sentence.empty()) {
    report.in_fields.push_back(report.warnings.size());
    report.warnings.push_back("parts without motion in this file: " + sentence);
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) report.not_mapped.push_back(raw.joints[i]);
}

/// Number of frames without a joint that other frames have.
std::size_t countGaps(const std::vector<humanmodel::SkeletonFrame>& frames) {
  std::array<bool, humanmodel::kJointCount> somewhere{};
  for (const auto& f : frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      somewhere[j] |= f.state[j] != humanmodel::JointState::kMissing;
  return static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(), [&](const humanmodel::SkeletonFrame& f) {
        for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
          if (somewhere[j] && f.state[j] == humanmodel::JointState::kMissing) return true;
        return false;
      }));
}

/// Numbers of frames with the person's left on the left, and on the right, relative to the direction of the
/// toes.
struct Sides {
  int agree{0}, contradict{0};
};
Sides countSides(const std::vector<humanmodel::SkeletonFrame>& frames) {
  using J = humanmodel::Joint;
  Sides sides;
  for (const auto i : sampleIndices(frames.size())) {
    const auto& f = frames[i];
    const bool all = f.has(J::kHipLeft) && f.has(J::kHipRight) && f.has(J::kAnkleLeft) &&
                     f.has(J::kToeLeft) && f.has(J::kAnkleRight) && f.has(J::kToeRight);
    if (!all) continue;
    const Vector3d forward = f[J::kToeLeft] - f[J::kAnkleLeft] + f[J::kToeRight] - f[J::kAnkleRight];
    const double side = Vector3d::UnitZ().cross(forward).dot(f[J::kHipLeft] - f[J::kHipRight]);
    ++(side >= 0.0 ? sides.agree : sides.contradict);
  }
  return sides;
}

/// False for toes derived from the hips, which do not determine sides.
bool toesWereFound(const std::vector<humanmodel::SkeletonFrame>& frames) {
  return std::any_of(frames.begin(), frames.end(), [](const humanmodel::SkeletonFrame& f) {
    return f.state[static_cast<std::size_t>(humanmodel::Joint::kToeLeft)] == humanmodel::JointState::kTracked;
  });
}

void reportSides(const RawRecording& raw, RecordingReport& report) {
  const Sides sides = countSides(raw.frames);
  const int all = sides.agree + sides.contradict;
  if (all == 0 || (!raw.is_canonical && !toesWereFound(raw.frames))) {
    report.sides.found = "unknown";
    report.sides.reason = "no toes that were measured together with hips and ankles";
    return;
  }
  const bool mirrored = sides.contradict > sides.agree;
  report.sides.found = mirrored ? "mirrored" : "agree";
  report.sides.reason = "the left hip is left of the toe direction in " + std::to_string(sides.agree) +
                        " of " + std::to_string(all) + " frames";
}

/// Warns of left and right exchanged in the whole body, or in a part of it.
void warnOfSides(const RawRecording& raw, RecordingReport& report) {
  const std::string advice =
      raw.is_canonical ? "; exchange their names in the file"
                       : "; exchange their names in the file, or in a joint map (--write-map, --joint-map)";
  const bool mirrored = report.sides.found == "mirrored";
  if (const auto opposed = opposedShoulders(raw.frames)) {
    const std::string which = report.sides.found == "unknown" ? "arms or in the legs"
                              : mirrored                      ? "legs"
                                                              : "arms";
    report.sides.reason += "; the shoulders are the other way round than the hips";
    report.warnings.push_back("left and right seem exchanged in the " + which +
                              ": the left shoulder is on the side of the right hip in " +
                              std::to_string(opposed->frames) + " of " + std::to_string(opposed->of) +
                              " frames" + advice);
  } else if (mirrored) {
    report.warnings.push_back(
        "left and right seem swapped: the left hip is right of the toe direction; set mirror to "
        "'axes' if the axes of the file are left-handed, 'sides' if the names are exchanged");
  }
  for (const std::string& sentence : exchangedLimbs(raw.frames)) report.warnings.push_back(sentence + advice);
}

/// Exchanges the names of left and right.
void swapSides(RawRecording& raw) {
  constexpr auto kFirstLeft = static_cast<std::size_t>(humanmodel::Joint::kShoulderLeft);
  for (const std::size_t first : {kFirstLeft, static_cast<std::size_t>(humanmodel::Joint::kHipLeft)})
    for (std::size_t j = first; j < first + 4; ++j) {
      const auto swap = [j](humanmodel::SkeletonFrame& f) {
        std::swap(f.p[j], f.p[j + 4]);
        std::swap(f.state[j], f.state[j + 4]);
        std::swap(f.spread[j], f.spread[j + 4]);
        if (f.covariance.isStated()) std::swap(f.covariance[j], f.covariance[j + 4]);
        if (f.lateral.isStated()) std::swap(f.lateral[j], f.lateral[j + 4]);
      };
      swap(raw.rest);
      swap(raw.turns.rest);
      for (auto& f : raw.frames) swap(f);
      std::swap(raw.match.joint[j], raw.match.joint[j + 4]);
    }
  raw.turns.swapSides();
}

/// After the frames were turned by `R_WF` from the axes of the file.
void setTwist(RawRecording& raw, const Matrix3d& R_WF, RecordingReport& report) {
  std::vector<humanmodel::SkeletonFrame> only{raw.turns.rest};
  deriveJoints(raw.turns.rest, only, raw.match.head);
  StatedTwist twist = stateTwist(raw.turns, R_WF, raw.frames);
  report.person.twisted = std::move(twist.parts);
  report.notes.insert(report.notes.end(), twist.notes.begin(), twist.notes.end());
}

/// Number of rotations of the hip line by more than 90 degrees between two frames: the tracker swapped sides.
std::size_t countSideSwaps(const std::vector<humanmodel::SkeletonFrame>& frames) {
  using J = humanmodel::Joint;
  std::size_t swaps = 0;
  for (std::size_t i = 2; i < frames.size(); ++i) {
    const auto &a = frames[i - 1], &b = frames[i];
    if (a.has(J::kHipLeft) && a.has(J::kHipRight) && b.has(J::kHipLeft) && b.has(J::kHipRight) &&
        (a[J::kHipLeft] - a[J::kHipRight]).dot(b[J::kHipLeft] - b[J::kHipRight]) < 0.0)
      ++swaps;
  }
  return swaps;
}

void warnOfPlace(const std::vector<humanmodel::SkeletonFrame>& frames, RecordingReport& report) {
  double lowest = kInfinity;
  for (const auto& f : frames)
    for (const humanmodel::Joint j : {humanmodel::Joint::kAnkleLeft, humanmodel::Joint::kAnkleRight,
                                      humanmodel::Joint::kToeLeft, humanmodel::Joint::kToeRight})
      if (f.has(j)) lowest = std::min(lowest, f[j].z());
  if (!std::isfinite(lowest)) return;
  report.lowest_foot = lowest;
  if (std::abs(lowest) <= kFloorDistance) return;
  report.in_fields.push_back(report.warnings.size());
  report.warnings.push_back("the lowest foot of the recording is at z = " + text::rounded(lowest, 2) +
                            " m, not on the floor: shift the recording (`place`) by " +
                            text::rounded(-lowest, 2) + " m in z");
}

/// Why the unit that the file states may be wrong; empty: no reason. `stature` in units of the file.
std::string doubtOf(const RawRecording& raw, std::optional<double> stature) {
  if (!raw.unit->warning.empty()) return raw.unit->warning;  // of its markers
  if (stature) return doubtOfUnit(*raw.unit, *stature);
  const auto bones = statureByBones(raw.frames);
  return bones ? doubtOfUnit(*raw.unit, bones->stature) : std::string();
}

/// The stature that the file states, otherwise `measured` along the bones (m; 0: unknown).
void setStature(double measured, RecordingReport& report) {
  const double stated = report.person.subject.height;
  report.stature = stated > 0.0 ? stated : measured;
  if (stated > 0.0)
    report.person.stature_reason = "the file states it";
  else if (measured > 0.0)
    report.person.stature_reason = "along the bones";
  const bool doubted = !report.units.doubt.empty();  // which says it already
  if (!doubted && stated > 0.0 && measured > 0.0 && std::abs(measured - stated) > kStaturesDiffer * stated)
    report.warnings.push_back("along the bones the person is " + text::rounded(measured, 2) +
                              " m tall, but the file states " + text::rounded(stated, 2) + " m");
}

}  // namespace

Recording convert(RawRecording raw, const RecordingOptions& options) {
  ABSTAND_CHECK(!raw.frames.empty());
  if (options.mirror != "none" && options.mirror != "axes" && options.mirror != "sides")
    throw UsageError("mirror: found '" + options.mirror + "', expected none, axes or sides");
  Recording out;
  RecordingReport& report = out.report;
  report.format = raw.format;
  report.rate = raw.rate;
  report.rate_reason = raw.rate_reason;
  out.clock_start = raw.clock_start;
  if (options.rate > 0.0) {
    report.rate = options.rate;
    report.rate_reason = "given by the user";
    out.clock_start = kNaN;
    for (std::size_t i = 0; i < raw.frames.size(); ++i)
      raw.frames[i].t = static_cast<double>(i) / options.rate;
  }
  report.duration = raw.frames.back().t - raw.frames.front().t;
  report.joints = raw.joints;
  report.joint_map = raw.match.map;
  report.notes = raw.notes;
  for (const auto& w : raw.warnings) {
    if (w.frames_missing > 0) report.in_fields.push_back(report.warnings.size());
    report.frames_missing += w.frames_missing;
    report.warnings.push_back(messageLine(w.line > 0 ? std::to_string(w.line) + ": " + w.text : w.text));
  }

  const auto add = [&](const std::string& warning) {
    if (!warning.empty()) report.warnings.push_back(warning);
  };
  if (options.mirror == "sides") swapSides(raw);
  if (!raw.is_canonical)
    for (const auto& sentence : deriveJoints(raw.rest, raw.frames, raw.match.head)) add(sentence);
  const auto stature = measureStature(raw.rest, raw.frames);
  const bool is_stated = raw.unit && options.units == "auto";
  const UnitChoice unit =
      is_stated ? *raw.unit
                : chooseUnit(options.units, stature, statureByBones(raw.frames), raw.subject.height);
  const UpChoice up = raw.up && options.up == "auto" ? *raw.up : chooseUp(options.up, raw.rest, raw.frames);
  if (is_stated && !raw.unit_is_guess) report.units.doubt = doubtOf(raw, stature);
  add(report.units.doubt.empty() ? unit.warning : report.units.doubt);
  add(up.warning);
  if (raw.up && options.up == "auto") add(doubtOfUp(up.axis, unit.scale, raw.frames));
  report.units.name = unit.name;
  report.units.reason = unit.reason;
  report.scale = unit.scale;
  report.up.axis = up.axis;
  report.up.reason = up.reason;
  report.units.guessed = !raw.unit && text::lowerCase(options.units) == "auto";
  report.up.guessed = !raw.up && text::lowerCase(options.up) == "auto";
  report.person.subject = raw.subject;
  setStature(stature ? *stature * unit.scale : 0.0, report);

  Matrix3d R_WF = rotationToZUp(up.axis);
  if (options.mirror == "axes") R_WF.row(1) *= -1.0;
  turnAndScale(raw.frames, R_WF, unit.scale);
  if (!raw.turns.frames.empty()) setTwist(raw, R_WF, report);
  if (raw.sensor) stateSensorError(*raw.sensor, raw.frames, report);
  reportParts(raw, raw.frames, report);
  report.gaps = countGaps(raw.frames);
  reportSides(raw, report);
  warnOfSides(raw, report);
  report.swaps = countSideSwaps(raw.frames);
  if (report.swaps > 0)
    add("the hips turn by more than 90 degrees between two frames " + std::to_string(report.swaps) +
        " times: left and right may be swapped there");
  warnOfPlace(raw.frames, report);
  report.person.proportions = proportionsOf(raw.frames);
  add(oddProportions(report.person.proportions));
  if (const auto pose = leadingTPose(raw.frames)) add(warningOf(*pose));
  out.frames = std::move(raw.frames);
  return out;
}

}  // namespace abstand::tracking
