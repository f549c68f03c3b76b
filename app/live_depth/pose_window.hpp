// Where the objects of a served scene were lately.
#pragma once

#include <string>
#include <vector>

#include "app/viewer/live_record.hpp"

namespace abstand::live_depth {

/// Poses of objects during the last kWindow seconds, from the moments of a server: a depth image shows the
/// robots as they were when it was exposed, and that time is not known exactly. One thread.
class PoseWindow {
 public:
  /// s. A Kinect's image arrives 0.05 to 0.1 s after its exposure.
  static constexpr double kWindow = 0.15;
  /// m and rad; smaller changes are no other pose: what is removed extends 6 cm ahead of the surface, and a
  /// pixel of a Kinect has 4 mm at 2 m.
  static constexpr double kStep = 0.01, kTurn = 0.03;

  /// Of the scene of `card`. Throws UsageError if it has not all of `objects` (names).
  PoseWindow(const moment::SceneCard& card, const std::vector<std::string>& objects);

  /// Takes over what has come. `now`: s, as for LiveRecord. Returns whether any pose is another one than
  /// after the last call, or is no longer known.
  bool update(const viewer::LiveRecord& record, double now);

  /// Of an object, newest first, each at least kStep or kTurn from the one before. Empty if it is not known
  /// where it is: the server does not answer, or its joint values are stale.
  const std::vector<Transform>& poses(std::size_t object) const { return poses_[object]; }

 private:
  void add(const viewer::LiveRecord::Copy& copy, bool is_newest);

  std::vector<std::size_t> number_;  ///< of each object, in moments
  moment::Moment moment_;
  viewer::LiveRecord::Copy copy_;
  std::vector<std::vector<Transform>> poses_, last_;
};

}  // namespace abstand::live_depth
