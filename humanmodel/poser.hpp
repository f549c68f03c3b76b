// From a skeleton to the poses of the parts.
#pragma once

#include <array>

#include "humanmodel/human_model.hpp"

namespace abstand {

/// How a part's pose came about. held: its joints were missing, the last pose stands (stale, never safe).
enum class PartState : std::uint8_t { kNone, kHeld, kInferred, kTracked };

struct HumanPose {
  std::array<Transform, kBodyPartCount> X_WP;
  std::array<PartState, kBodyPartCount> state;
  std::array<double, kBodyPartCount> age;   ///< s since the part was last seen
};

/// Puts the parts of a model onto skeletons. The joints follow the directions of the recording and keep the model's
/// bone lengths, built outwards from the pelvis, or, with `follow_lengths`, stand where the recording has them.
class Poser {
 public:
  explicit Poser(const HumanModel& model, bool follow_lengths = false);

  /// No allocation, no throw. A frame with numbers that are not finite changes nothing but state and age.
  void pose(const SkeletonFrame& frame, HumanPose& out);
  void reset();

 private:
  const HumanModel* model_;
  bool follow_lengths_;
  HumanPose last_;
  double last_t_;
};

}  // namespace abstand
