// Camera pose from a person whom the camera sees, and who is known in the world.
#pragma once

#include <span>

#include "humanmodel/joints.hpp"

namespace abstand::tracking {

struct PersonPoseFit {
  Transform X_WC;
  double clock{0.0};        ///< s, to be added to the times of the camera
  bool clock_known{false};  ///< whether the movements decide it
  bool exchanged{false};  ///< left and right had to be exchanged: the person was tracked facing the other way
  double rms{0.0};        ///< m, distance of the joints that were used
  /// m, standard deviation along the worst axis of the camera's position, and of points as far from the
  /// middle of the person, 1 m at least, as that of PoseFit. As the errors of a joint are nearly the same in
  /// all images, only kJointCount of all matches count as independent.
  double spread{0.0};
  std::size_t joints{0};  ///< matched joints in all images ...
  std::size_t used{0};    ///< ... of which these are not outliers
  double moved{0.0};      ///< m, largest horizontal distance between two places of the pelvis
};

/// Rigid transform that puts the joints tracked by a camera (`own`, in any frame F in which the camera has
/// the pose X_FC) onto those of the same person in the world. Clocks may differ by ClockOffset::kFarthest.
/// The best of all offsets by least squares; then joints farther off than three times the median are left
/// out. Needs one second of common movement. Throws UsageError where there is none, or where too few joints
/// agree.
PersonPoseFit fitPoseToPerson(std::span<const humanmodel::SkeletonFrame> world,
                              std::span<const humanmodel::SkeletonFrame> own, const Transform& X_FC);

}  // namespace abstand::tracking
