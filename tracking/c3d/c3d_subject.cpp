#include "tracking/c3d/c3d_subject.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "core/base/number.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr double kShortest = 1.2, kTallest = 2.3;    // m
constexpr double kLightest = 10.0, kHeaviest = 300;  // kg

struct HeightUnit {
  const char* name;
  double metres;
};
constexpr HeightUnit kHeightUnits[]{{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inches", 0.0254}};

/// A size with the range (m) in which it is one of a person. Its limits differ by less than a factor of ten,
/// so that m, cm and mm exclude each other.
struct SizeName {
  const char *key, *name;
  double min, max;
};
constexpr SizeName kSizes[]{{"LEGLENGTH", "leg_length", 0.5, 1.3},
                            {"KNEEWIDTH", "knee_width", 0.05, 0.2},
                            {"ANKLEWIDTH", "ankle_width", 0.03, 0.15},
                            {"ELBOWWIDTH", "elbow_width", 0.03, 0.15},
                            {"WRISTWIDTH", "wrist_width", 0.02, 0.12},
                            {"HANDTHICKNESS", "hand_thickness", 0.01, 0.08},
                            {"SHOULDEROFFSET", "shoulder_offset", 0.012, 0.1}};

/// The first of the parameters that has a number; 0: none.
double firstNumber(const C3dParameters& parameters, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto it = parameters.find(name); it != parameters.end() && !it->second.numbers.empty())
      return it->second.numbers.front();
  return 0.0;
}

/// The unit that makes it a stature; nullptr: none does.
const HeightUnit* unitOfHeight(double height) {
  for (const HeightUnit& unit : kHeightUnits)
    if (height * unit.metres >= kShortest && height * unit.metres <= kTallest) return &unit;
  return nullptr;
}

/// m; 0 if no unit gives a size of this kind. `of_height` is tried first.
double metresOf(double size, const SizeName& kind, const HeightUnit* of_height) {
  for (const double unit : {of_height ? of_height->metres : 0.001, 0.001, 0.01, 1.0})
    if (size * unit >= kind.min && size * unit <= kind.max) return size * unit;
  return 0.0;
}

/// With three digits after the point; numbers of a file are floats.
std::string shown(double value) {
  return formatDouble(std::abs(value) < 1e6 ? std::round(1000.0 * value) / 1000.0 : value);
}

/// Sets the stature from the first parameter that has one; returns its unit, nullptr: none.
const HeightUnit* takeHeight(const C3dParameters& parameters, StatedSubject& subject) {
  double stated = 0.0;
  for (const char* name : {"PROCESSING:HEIGHT", "SUBJECT:HEIGHT"}) {
    const double height = firstNumber(parameters, {name});
    if (stated == 0.0) stated = height;
    const HeightUnit* unit = unitOfHeight(height);
    if (!unit) continue;
    subject.facts.height = height * unit->metres;
    if (unit->metres == 0.0254)
      subject.notes.push_back("the stated HEIGHT of " + shown(height) +
                              " is taken as inches: " + text::rounded(subject.facts.height, 3) + " m");
    return unit;
  }
  if (stated != 0.0)
    subject.warnings.push_back("the stated HEIGHT of " + shown(stated) + " is no stature of " +
                               text::rounded(kShortest, 1) + " to " + text::rounded(kTallest, 1) +
                               " m in m, cm, mm or inches: it is ignored");
  return nullptr;
}

}  // namespace

StatedSubject subjectOf(const C3dParameters& parameters) {
  StatedSubject subject;
  SubjectFacts& facts = subject.facts;
  for (const char* name : {"SUBJECTS:NAMES", "SUBJECT:NAME"})
    if (const auto it = parameters.find(name);
        facts.name.empty() && it != parameters.end() && !it->second.texts.empty())
      facts.name = it->second.texts.front();
  const HeightUnit* unit = takeHeight(parameters, subject);
  const double mass = firstNumber(parameters, {"PROCESSING:BODYMASS", "SUBJECT:WEIGHT", "SUBJECT:MASS"});
  if (mass >= kLightest && mass <= kHeaviest) facts.mass = mass;
  for (const SizeName& kind : kSizes)
    for (const auto& [letter, side] : {std::pair("L", "_left"), std::pair("R", "_right")}) {
      const double size = metresOf(
          firstNumber(parameters, {(std::string("PROCESSING:") + letter + kind.key).c_str()}), kind, unit);
      if (size > 0.0) facts.sizes[std::string(kind.name) + side] = size;
    }
  return subject;
}

}  // namespace abstand::tracking
