#include "tracking/recording/body_size.hpp"

#include <array>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr double kAnkleHeight = 0.039;  // share of the stature
/// Factor between a stature along the bones, or by markers, and the stated one; at most one unit is within
/// it.
constexpr double kStatedFactor = 1.4;
constexpr double kStraightest = 0.9;  // quantile; the maximum could be the glitch of one frame

struct Unit {
  const char* name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits{
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inches", 0.0254}, {"cmu", 0.0254 / 0.45}}};

class Lengths {
 public:
  Lengths(const humanmodel::SkeletonFrame& rest, const std::vector<humanmodel::SkeletonFrame>& frames)
      : rest_(rest) {
    for (const auto i : sampleIndices(frames.size())) samples_.push_back(&frames[i]);
  }

  /// NaN if the joints never occur together.
  double median(humanmodel::Joint a, humanmodel::Joint b) const { return over(a, b, 0.5); }
  double straightest(humanmodel::Joint a, humanmodel::Joint b) const {
    const double moving = over(a, b, kStraightest);
    return rest_.has(a) && rest_.has(b) ? std::max(moving, (rest_[a] - rest_[b]).norm()) : moving;
  }

  /// Distance of the hips below the pelvis, along the trunk.
  double hipDrop() const {
    std::vector<double> drops;
    for (const auto* f : samples_) {
      if (!f->has(humanmodel::Joint::kPelvis) || !f->has(humanmodel::Joint::kNeck) ||
          !f->has(humanmodel::Joint::kHipLeft) || !f->has(humanmodel::Joint::kHipRight))
        continue;
      const Vector3d down = (*f)[humanmodel::Joint::kPelvis] - (*f)[humanmodel::Joint::kNeck];
      if (down.norm() == 0.0) continue;
      const Vector3d p_hips = 0.5 * ((*f)[humanmodel::Joint::kHipLeft] + (*f)[humanmodel::Joint::kHipRight]);
      drops.push_back((p_hips - (*f)[humanmodel::Joint::kPelvis]).dot(down.normalized()));
    }
    return nearestQuantile(std::move(drops), 0.5);
  }

 private:
  double over(humanmodel::Joint a, humanmodel::Joint b, double q) const {
    std::vector<double> lengths;
    for (const auto* f : samples_)
      if (f->has(a) && f->has(b)) lengths.push_back(((*f)[a] - (*f)[b]).norm());
    return nearestQuantile(std::move(lengths), q);
  }

  const humanmodel::SkeletonFrame& rest_;
  std::vector<const humanmodel::SkeletonFrame*> samples_;
};

struct UsualBone {
  humanmodel::Joint a, b;
  double share;  // of the stature
};
/// The unit in which a stature is one of a person; nullptr: none.
const Unit* fittingUnit(double stature, double min, double max) {
  for (const auto& unit : kUnits)
    if (stature * unit.metres >= min && stature * unit.metres <= max) return &unit;
  return nullptr;
}

UnitChoice unitByBones(const BoneStature& by) {
  const std::string measured = "by " + std::to_string(by.bones) + " of the usual bones the person is about " +
                               text::rounded(by.stature, 3) + " units tall: ";
  if (const Unit* unit = fittingUnit(by.stature, kShortestByBones, kTallestByBones))
    return {unit->name, measured + text::rounded(by.stature * unit->metres, 2) + " m in " + unit->name,
            unit->metres, ""};
  return {"free", measured + "in no usual unit a person's stature", kAssumedStature / by.stature,
          measured + "no common unit gives " + text::rounded(kShortestByBones, 1) + " to " +
              text::rounded(kTallestByBones, 1) + " m, so it is scaled to about " +
              text::rounded(kAssumedStature, 2) + " m; give the units if they are known"};
}

/// `stature` in units of the file, `stated` in m.
UnitChoice unitByStated(double stature, double stated) {
  const std::string measured = "along the bones the person is " + text::rounded(stature, 3) + " units tall: ",
                    said = text::rounded(stated, 3) + " m that the file states";
  if (const Unit* unit = fittingUnit(stature, stated / kStatedFactor, stated * kStatedFactor))
    return {
        unit->name,
        measured + text::rounded(stature * unit->metres, 3) + " m in " + unit->name + ", near the " + said,
        unit->metres, ""};
  return {"free", measured + "in no usual unit near the " + said, stated / stature,
          measured + "no common unit comes near the " + said +
              ", to which it is scaled; give the units if they are known"};
}

UnitChoice wantedUnit(const std::string& wanted) {
  std::string name = text::lowerCase(wanted);
  if (name == "in" || name == "inch") name = "inches";
  for (const auto& unit : kUnits)
    if (name == unit.name) return {unit.name, "given by the user", unit.metres, ""};
  const auto metres = parseDouble(wanted);
  if (!metres || *metres < 1e-9 || *metres > 1e9)
    throw UsageError("units: found '" + wanted +
                     "', expected auto, m, cm, mm, inches, cmu or metres per unit as a number");
  return {wanted, "given by the user", *metres, ""};
}

}  // namespace

std::optional<double> measureStature(const humanmodel::SkeletonFrame& rest,
                                     const std::vector<humanmodel::SkeletonFrame>& frames) {
  const Lengths lengths(rest, frames);
  const double leg = 0.5 * (lengths.median(humanmodel::Joint::kHipLeft, humanmodel::Joint::kKneeLeft) +
                            lengths.median(humanmodel::Joint::kKneeLeft, humanmodel::Joint::kAnkleLeft) +
                            lengths.median(humanmodel::Joint::kHipRight, humanmodel::Joint::kKneeRight) +
                            lengths.median(humanmodel::Joint::kKneeRight, humanmodel::Joint::kAnkleRight));
  const double above_ankle = lengths.straightest(humanmodel::Joint::kHeadTop, humanmodel::Joint::kNeck) +
                             lengths.straightest(humanmodel::Joint::kNeck, humanmodel::Joint::kPelvis) +
                             lengths.hipDrop() + leg;
  const double stature = above_ankle / (1.0 - kAnkleHeight);
  if (!std::isfinite(stature) || stature <= 0.0) return std::nullopt;
  return stature;
}

std::optional<BoneStature> statureByBones(const std::vector<humanmodel::SkeletonFrame>& frames) {
  using J = humanmodel::Joint;
  static constexpr UsualBone kUsualBones[]{
      {J::kHipLeft, J::kKneeLeft, 0.245},       {J::kHipRight, J::kKneeRight, 0.245},
      {J::kKneeLeft, J::kAnkleLeft, 0.246},     {J::kKneeRight, J::kAnkleRight, 0.246},
      {J::kShoulderLeft, J::kElbowLeft, 0.186}, {J::kShoulderRight, J::kElbowRight, 0.186},
      {J::kElbowLeft, J::kWristLeft, 0.146},    {J::kElbowRight, J::kWristRight, 0.146},
      {J::kShoulderLeft, J::kHipLeft, 0.288},   {J::kShoulderRight, J::kHipRight, 0.288}};
  const humanmodel::SkeletonFrame no_rest;
  const Lengths lengths(no_rest, frames);
  std::vector<double> statures;
  for (const UsualBone& bone : kUsualBones)
    if (const double length = lengths.median(bone.a, bone.b); std::isfinite(length) && length > 0.0)
      statures.push_back(length / bone.share);
  if (statures.empty()) return std::nullopt;
  const int bones = static_cast<int>(statures.size());
  return BoneStature{nearestQuantile(std::move(statures), 0.5), bones};
}

UnitChoice chooseUnit(const std::string& wanted, std::optional<double> stature,
                      std::optional<BoneStature> by_bones, double stated_stature) {
  const std::string range =
      text::rounded(kShortestAdult, 1) + " to " + text::rounded(kTallestAdult, 1) + " m";
  const auto plausible = [](double metres) { return metres >= kShortestAdult && metres <= kTallestAdult; };
  if (text::lowerCase(wanted) != "auto") {
    UnitChoice choice = wantedUnit(wanted);
    if (stature && !plausible(*stature * choice.scale))
      choice.warning = "with the given units the person is " + text::rounded(*stature * choice.scale, 3) +
                       " m tall, not " + range;
    return choice;
  }
  if (stated_stature > 0.0 && (stature || by_bones))
    return unitByStated(stature ? *stature : by_bones->stature, stated_stature);
  if (!stature && by_bones) return unitByBones(*by_bones);
  if (!stature)
    return {"cm", "the file has no bone that determines the stature; centimetres are most common", 0.01,
            "the units are unknown: centimetres are assumed; set the units if that is wrong"};
  const std::string measured =
      "along the bones the person is " + text::rounded(*stature, 3) + " units tall: ";
  if (const Unit* unit = fittingUnit(*stature, kShortestAdult, kTallestAdult))
    return {
        unit->name,
        measured + text::rounded(*stature * unit->metres, 3) + " m in " + unit->name + ", an adult's stature",
        unit->metres, ""};
  const double scale = kAssumedStature / *stature;
  return {"free", measured + "in no usual unit an adult's stature (" + range + ")", scale,
          measured + "no common unit gives " + range + ", so it is scaled to " +
              text::rounded(kAssumedStature, 2) + " m; give the units if they are known"};
}

std::string doubtOfUnit(const UnitChoice& stated, double stature, const StatureRange& plausible) {
  const double metres = stature * stated.scale;
  if (!std::isfinite(metres) || (metres >= plausible.min && metres <= plausible.max)) return {};
  const std::string doubt = "with the stated unit " + stated.name + " (" + stated.reason +
                            ") the person is " + text::rounded(metres, 3) + " m tall, not " +
                            text::rounded(kShortestByBones, 1) + " to " + text::rounded(kTallestByBones, 1) +
                            " m";
  if (const Unit* unit = fittingUnit(stature, kShortestByBones, kTallestByBones))
    return doubt + "; in " + unit->name + " it would be " + text::rounded(stature * unit->metres, 3) +
           " m: set the units to " + unit->name + " if the file is wrong";
  return doubt + ", and no usual unit gives that: set the units";
}

}  // namespace abstand::tracking
