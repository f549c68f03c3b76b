// Side, segment and number of a joint, read from its name.
#pragma once

#include <cstdint>
#include <string_view>

namespace abstand::tracking {

enum class NameSide : std::uint8_t { kNone, kLeft, kRight };

/// Word for a segment or a joint. kShoulder, kArm, kLeg, kHip, kHand and kFoot denote different joints in
/// different conventions.
enum class NameWord : std::uint8_t {
  kUnknown,
  kPelvis,
  kRoot,
  kSpine,
  kNeck,
  kHead,
  kHeadTop,
  kCollar,
  kShoulder,
  kUpperArm,
  kArm,
  kForearm,
  kWrist,
  kHand,
  kHip,
  kThigh,
  kLeg,
  kShin,
  kAnkle,
  kFoot,
  kToe,
  kCount
};

struct NameReading {
  NameWord word{NameWord::kUnknown};
  NameSide side{NameSide::kNone};
  int number{0};       ///< last number in the name; 0: none
  int other_words{0};  ///< words without a meaning here
  bool is_end{false};  ///< end site: "NAME/end"
};

/// Reads names such as "mixamorig:LeftUpLeg", "Bip01_L_Thigh", "lShldr", "upper_arm.L.001", "rig|hand_r#2".
/// A namespace before the last ':' or '|' is ignored. Words are separated by anything but letters and digits,
/// by capitals and by digits; a side may be stuck to a word ("larm"). kUnknown for fingers, eyes, twist
/// bones, controls, and names with words of two segments. At most 200 characters are read.
NameReading readJointName(std::string_view name);

}  // namespace abstand::tracking
