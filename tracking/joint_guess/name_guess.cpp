#include "tracking/joint_guess/name_guess.hpp"

#include <array>
#include <tuple>

#include "tracking/joint_guess/name_reading.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using enum NameWord;

constexpr Joint kLimbJoints[]{Joint::kHipLeft,      Joint::kHipRight,      Joint::kKneeLeft,
                              Joint::kKneeRight,    Joint::kAnkleLeft,     Joint::kAnkleRight,
                              Joint::kShoulderLeft, Joint::kShoulderRight, Joint::kElbowLeft,
                              Joint::kElbowRight,   Joint::kWristLeft,     Joint::kWristRight};

/// The best name for each word and side.
class NamedJoints {
 public:
  explicit NamedJoints(std::span<const std::string> names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const NameReading reading = readJointName(names[i]);
      if (reading.word == kUnknown) continue;
      if (reading.word == kSpine && !reading.is_end) spine_.push_back(static_cast<int>(i));
      Found& found = at(reading.word, reading.side, reading.is_end);
      const Key key{reading.other_words, reading.number, static_cast<int>(i)};
      if (found.index < 0 || key < found.key) found = {static_cast<int>(i), key};
    }
  }

  int find(NameWord word, NameSide side, bool is_end = false) const {
    return found_[place(word, side, is_end)].index;
  }
  const std::vector<int>& spine() const { return spine_; }

 private:
  using Key = std::tuple<int, int, int>;
  struct Found {
    int index{-1};
    Key key;
  };
  static std::size_t place(NameWord word, NameSide side, bool is_end) {
    return (static_cast<std::size_t>(word) * 3 + static_cast<std::size_t>(side)) * 2 + (is_end ? 1 : 0);
  }
  Found& at(NameWord word, NameSide side, bool is_end) { return found_[place(word, side, is_end)]; }

  std::array<Found, static_cast<std::size_t>(NameWord::kCount) * 6> found_{};
  std::vector<int> spine_;
};

int firstOf(std::initializer_list<int> candidates) {
  for (const int i : candidates)
    if (i >= 0) return i;
  return -1;
}

void setJoint(JointMatch& match, Joint j, int index) {
  if (index < 0) return;
  for (const int used : match.joint)
    if (used == index) return;
  match.joint[static_cast<std::size_t>(j)] = index;
  ++match.mapped;
}

Joint onSide(Joint left, NameSide side) {
  return static_cast<Joint>(static_cast<int>(left) + (side == NameSide::kLeft ? 0 : 4));
}

void setArm(const NamedJoints& named, NameSide side, JointMatch& match) {
  const auto at = [&](NameWord w, bool is_end = false) { return named.find(w, side, is_end); };
  setJoint(match, onSide(Joint::kShoulderLeft, side), firstOf({at(kUpperArm), at(kArm), at(kShoulder)}));
  setJoint(match, onSide(Joint::kElbowLeft, side), at(kForearm));
  setJoint(match, onSide(Joint::kWristLeft, side), firstOf({at(kWrist), at(kHand)}));
  setJoint(match, onSide(Joint::kHandLeft, side),
           firstOf({at(kWrist) >= 0 ? at(kHand) : -1, at(kHand, true), at(kWrist, true)}));
}

void setLeg(const NamedJoints& named, NameSide side, JointMatch& match) {
  const auto at = [&](NameWord w, bool is_end = false) { return named.find(w, side, is_end); };
  const bool leg_is_shin = at(kShin) < 0 && (at(kThigh) >= 0 || at(kHip) >= 0);
  setJoint(match, onSide(Joint::kHipLeft, side),
           firstOf({at(kThigh), at(kHip), leg_is_shin ? -1 : at(kLeg)}));
  setJoint(match, onSide(Joint::kKneeLeft, side), firstOf({at(kShin), leg_is_shin ? at(kLeg) : -1}));
  setJoint(match, onSide(Joint::kAnkleLeft, side), firstOf({at(kAnkle), at(kFoot)}));
  setJoint(match, onSide(Joint::kToeLeft, side),
           firstOf({at(kToe), at(kAnkle) >= 0 ? at(kFoot) : -1, at(kFoot, true), at(kToe, true),
                    at(kAnkle, true)}));
}

}  // namespace

int limbJoints(const JointMatch& match) {
  int count = 0;
  for (const Joint j : kLimbJoints) count += match.joint[static_cast<std::size_t>(j)] >= 0 ? 1 : 0;
  return count;
}

JointMatch guessByNames(std::span<const std::string> names, bool is_tree) {
  const NamedJoints named(names);
  const auto middle = [&](NameWord w, bool is_end = false) { return named.find(w, NameSide::kNone, is_end); };
  JointMatch match;
  match.joint.fill(-1);
  match.head = is_tree ? HeadPoint::kBase : HeadPoint::kMiddle;
  setJoint(match, Joint::kPelvis, firstOf({middle(kPelvis), middle(kHip), middle(kRoot)}));
  if (!named.spine().empty()) setJoint(match, Joint::kSpine, named.spine().front());
  if (named.spine().size() > 1) setJoint(match, Joint::kThorax, named.spine().back());
  setJoint(match, Joint::kNeck, middle(kNeck));
  setJoint(match, Joint::kHead, middle(kHead));
  setJoint(match, Joint::kHeadTop, firstOf({middle(kHeadTop), middle(kHead, true), middle(kHeadTop, true)}));
  for (const NameSide side : {NameSide::kLeft, NameSide::kRight}) {
    setArm(named, side, match);
    setLeg(named, side, match);
  }
  return match;
}

}  // namespace abstand::tracking
