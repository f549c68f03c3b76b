#include "tracking/c3d/c3d_subject.hpp"

#include <optional>
#include <utility>

namespace abstand::tracking {
namespace {

constexpr double kShortest = 0.5, kTallest = 2.5;    // m
constexpr double kLightest = 10.0, kHeaviest = 300;  // kg
constexpr double kSmallest = 0.005, kLargest = 1.5;  // m, of a width or a length
constexpr std::pair<const char*, const char*> kSizes[]{
    {"LEGLENGTH", "leg_length"},          {"KNEEWIDTH", "knee_width"},   {"ANKLEWIDTH", "ankle_width"},
    {"ELBOWWIDTH", "elbow_width"},        {"WRISTWIDTH", "wrist_width"}, {"HANDTHICKNESS", "hand_thickness"},
    {"SHOULDEROFFSET", "shoulder_offset"}};

/// The first of the parameters that has a number; 0: none.
double firstNumber(const C3dParameters& parameters, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto it = parameters.find(name); it != parameters.end() && !it->second.numbers.empty())
      return it->second.numbers.front();
  return 0.0;
}

/// Metres per unit of a stature; nullopt: no unit gives one.
std::optional<double> unitOfHeight(double height) {
  for (const double unit : {1.0, 0.01, 0.001})
    if (height * unit >= kShortest && height * unit <= kTallest) return unit;
  return std::nullopt;
}

}  // namespace

SubjectFacts subjectOf(const C3dParameters& parameters) {
  SubjectFacts facts;
  for (const char* name : {"SUBJECTS:NAMES", "SUBJECT:NAME"})
    if (const auto it = parameters.find(name);
        facts.name.empty() && it != parameters.end() && !it->second.texts.empty())
      facts.name = it->second.texts.front();
  const double processed = firstNumber(parameters, {"PROCESSING:HEIGHT"});
  const double height = processed > 0.0 ? processed : firstNumber(parameters, {"SUBJECT:HEIGHT"});
  if (const auto unit = unitOfHeight(height)) facts.height = height * *unit;
  const double mass = firstNumber(parameters, {"PROCESSING:BODYMASS", "SUBJECT:WEIGHT", "SUBJECT:MASS"});
  if (mass >= kLightest && mass <= kHeaviest) facts.mass = mass;
  const double unit = unitOfHeight(processed).value_or(0.001);
  for (const auto& [key, name] : kSizes)
    for (const auto& [letter, side] : {std::pair("L", "_left"), std::pair("R", "_right")}) {
      const double size =
          unit * firstNumber(parameters, {(std::string("PROCESSING:") + letter + key).c_str()});
      if (size >= kSmallest && size <= kLargest) facts.sizes[std::string(name) + side] = size;
    }
  return facts;
}

}  // namespace abstand::tracking
