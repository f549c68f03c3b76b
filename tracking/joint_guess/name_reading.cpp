#include "tracking/joint_guess/name_reading.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kLongestName = 200;
constexpr int kMaxNumber = 100000;
constexpr std::string_view kEndMark = "/end";

using enum NameWord;
constexpr std::pair<std::string_view, NameWord> kWords[]{
    {"hips", kPelvis},       {"pelvis", kPelvis},     {"lowertorso", kPelvis}, {"root", kRoot},
    {"spine", kSpine},       {"chest", kSpine},       {"torso", kSpine},       {"uppertorso", kSpine},
    {"upperchest", kSpine},  {"abdomen", kSpine},     {"back", kSpine},        {"upperback", kSpine},
    {"lowerback", kSpine},   {"thorax", kSpine},      {"ribcage", kSpine},     {"waist", kSpine},
    {"neck", kNeck},         {"head", kHead},         {"headtop", kHeadTop},   {"headend", kHeadTop},
    {"headnub", kHeadTop},   {"vertex", kHeadTop},    {"collar", kCollar},     {"clavicle", kCollar},
    {"clav", kCollar},       {"collarbone", kCollar}, {"scapula", kCollar},    {"shoulderblade", kCollar},
    {"shoulder", kShoulder}, {"shldr", kShoulder},    {"upperarm", kUpperArm}, {"uparm", kUpperArm},
    {"humerus", kUpperArm},  {"bicep", kUpperArm},    {"biceps", kUpperArm},   {"arm", kArm},
    {"forearm", kForearm},   {"lowerarm", kForearm},  {"lowarm", kForearm},    {"elbow", kForearm},
    {"radius", kForearm},    {"wrist", kWrist},       {"hand", kHand},         {"hip", kHip},
    {"thigh", kThigh},       {"upleg", kThigh},       {"upperleg", kThigh},    {"femur", kThigh},
    {"leg", kLeg},           {"lowerleg", kShin},     {"lowleg", kShin},       {"shin", kShin},
    {"calf", kShin},         {"shank", kShin},        {"tibia", kShin},        {"knee", kShin},
    {"ankle", kAnkle},       {"foot", kFoot},         {"toe", kToe},           {"toes", kToe},
    {"toebase", kToe},       {"ball", kToe}};

/// Words of things that are no joint of the canonical skeleton.
constexpr std::string_view kStrange[]{
    "twist",  "roll",   "ik",    "fk",     "pole",    "target", "helper", "ctrl",     "control", "thumb",
    "index",  "middle", "ring",  "pinky",  "pinkie",  "little", "mid",    "finger",   "fingers", "metacarpal",
    "eye",    "eyes",   "jaw",   "ear",    "hair",    "breast", "bust",   "pectoral", "tail",    "skirt",
    "weapon", "prop",   "nose",  "mouth",  "tongue",  "brow",   "cheek",  "lip",      "teeth",   "face",
    "heel",   "wing",   "cloth", "attach", "buttock", "share",  "socket", "hold",     "camera",  "muscle"};

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Words in lower case, and numbers.
std::vector<std::string> splitName(std::string_view name) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t from = i++;
    if (isDigit(name[from])) {
      while (i < name.size() && isDigit(name[i])) ++i;
    } else if (isLetter(name[from])) {
      if (isCapital(name[from]) && i < name.size() && isCapital(name[i])) {
        // The last of several capitals begins the next word if a small letter follows.
        while (i < name.size() && isCapital(name[i])) ++i;
        if (i < name.size() && isLetter(name[i])) --i;
      } else {
        while (i < name.size() && isLetter(name[i]) && !isCapital(name[i])) ++i;
      }
    } else {
      continue;
    }
    words.push_back(text::lowerCase(name.substr(from, i - from)));
  }
  return words;
}

NameWord wordOf(std::string_view word) {
  for (const auto& [text, meaning] : kWords)
    if (text == word) return meaning;
  return kUnknown;
}

NameSide sideOf(std::string_view word) {
  if (word == "l" || word == "left" || word == "lft" || word == "lt") return NameSide::kLeft;
  if (word == "r" || word == "right" || word == "rgt" || word == "rt") return NameSide::kRight;
  return NameSide::kNone;
}

/// A word with its side stuck to it, as "larm", "leftarm" and "arml".
std::pair<NameWord, NameSide> stuckSide(std::string_view word) {
  for (const std::string_view side : {"left", "right", "l", "r"}) {
    if (word.size() <= side.size()) continue;
    const std::size_t rest = word.size() - side.size();
    if (word.starts_with(side))
      if (const NameWord w = wordOf(word.substr(side.size())); w != kUnknown) return {w, sideOf(side)};
    if (word.ends_with(side))
      if (const NameWord w = wordOf(word.substr(0, rest)); w != kUnknown) return {w, sideOf(side)};
  }
  return {kUnknown, NameSide::kNone};
}

int numberOf(std::string_view digits) {
  int n = 0;
  for (const char c : digits) n = std::min(10 * n + (c - '0'), kMaxNumber);
  return n;
}

/// Reads one name; words of two segments or of two sides make it strange.
class NameReader {
 public:
  NameReading read(std::string_view name) {
    if (name.size() > kLongestName) return {};
    if (name.ends_with(kEndMark)) {
      reading_.is_end = true;
      name.remove_suffix(kEndMark.size());
    }
    const std::vector<std::string> words = splitName(name.substr(name.find_last_of(":|") + 1));
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (i + 1 < words.size() && wordOf(words[i] + words[i + 1]) != kUnknown)
        take(wordOf(words[i] + words[i + 1])), ++i;
      else
        takeOne(words[i]);
    }
    if (is_strange_) reading_.word = kUnknown;
    return reading_;
  }

 private:
  void takeOne(const std::string& word) {
    if (isDigit(word.front())) {
      reading_.number = numberOf(word);
    } else if (std::find(std::begin(kStrange), std::end(kStrange), word) != std::end(kStrange)) {
      is_strange_ = true;
    } else if (const NameSide side = sideOf(word); side != NameSide::kNone) {
      takeSide(side);
    } else if (const NameWord known = wordOf(word); known != kUnknown) {
      take(known);
    } else if (const auto [stuck, stuck_side] = stuckSide(word); stuck != kUnknown) {
      take(stuck);
      takeSide(stuck_side);
    } else {
      ++reading_.other_words;
    }
  }
  void take(NameWord word) {
    is_strange_ |= reading_.word != kUnknown && reading_.word != word;
    reading_.word = word;
  }
  void takeSide(NameSide side) {
    is_strange_ |= reading_.side != NameSide::kNone && reading_.side != side;
    reading_.side = side;
  }

  NameReading reading_;
  bool is_strange_{false};
};

}  // namespace

NameReading readJointName(std::string_view name) { return NameReader().read(name); }

}  // namespace abstand::tracking
