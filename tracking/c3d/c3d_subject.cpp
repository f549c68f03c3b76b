#include "tracking/c3d/c3d_subject.hpp"

#include <algorithm>
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

/// The numbers of subject `i`.
class SubjectNumbers {
 public:
  SubjectNumbers(const C3dParameters& parameters, std::size_t i) : parameters_{parameters}, i_{i} {}

  /// That of the first parameter that has one for the subject; 0: none.
  double first(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto it = parameters_.find(name); it != parameters_.end() && i_ < it->second.numbers.size())
        return it->second.numbers[i_];
    return 0.0;
  }

 private:
  const C3dParameters& parameters_;
  std::size_t i_;
};

/// Texts without empty ones at the end.
std::vector<std::string> textsOf(const C3dParameters& parameters, const char* name) {
  const auto it = parameters.find(name);
  if (it == parameters.end()) return {};
  std::vector<std::string> texts = it->second.texts;
  while (!texts.empty() && texts.back().empty()) texts.pop_back();
  return texts;
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
const HeightUnit* takeHeight(const SubjectNumbers& numbers, StatedSubject& subject) {
  double stated = 0.0;
  for (const char* name : {"PROCESSING:HEIGHT", "SUBJECT:HEIGHT", "SUBJECTS:HEIGHT"}) {
    const double height = numbers.first({name});
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

void takeFacts(const SubjectNumbers& numbers, StatedSubject& subject) {
  SubjectFacts& facts = subject.facts;
  const HeightUnit* unit = takeHeight(numbers, subject);
  const double mass = numbers.first(
      {"PROCESSING:BODYMASS", "SUBJECT:WEIGHT", "SUBJECT:MASS", "SUBJECTS:WEIGHT", "SUBJECTS:MASS"});
  if (mass >= kLightest && mass <= kHeaviest) facts.mass = mass;
  for (const SizeName& kind : kSizes)
    for (const auto& [letter, side] : {std::pair("L", "_left"), std::pair("R", "_right")}) {
      const double size =
          metresOf(numbers.first({(std::string("PROCESSING:") + letter + kind.key).c_str()}), kind, unit);
      if (size > 0.0) facts.sizes[std::string(kind.name) + side] = size;
    }
}

}  // namespace

std::vector<StatedSubject> subjectsOf(const C3dParameters& parameters) {
  std::vector<std::string> names = textsOf(parameters, "SUBJECTS:NAMES");
  if (names.empty()) names = textsOf(parameters, "SUBJECT:NAME");
  const std::vector<std::string> prefixes = textsOf(parameters, "SUBJECTS:LABEL_PREFIXES");
  std::vector<StatedSubject> subjects;
  for (std::size_t i = 0; i < std::max<std::size_t>(names.size(), 1); ++i) {
    StatedSubject& subject = subjects.emplace_back();
    if (i < names.size()) subject.facts.name = names[i];
    if (i < prefixes.size()) subject.label_prefix = prefixes[i];
    takeFacts(SubjectNumbers(parameters, i), subject);
  }
  const StatedSubject& only = subjects.front();
  if (subjects.size() == 1 && only.facts.empty() && only.warnings.empty()) subjects.clear();
  return subjects;
}

}  // namespace abstand::tracking
