// People tracked with one of several cameras alone.
#pragma once

#include <map>

#include "tracking/tracker/people_views.hpp"
#include "tracking/tracker/seen_through.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// Tracks the people in the images of one camera in one pass, with usual bodies, to compare their places with
/// those that other cameras give. One thread. Allocates while people appear.
class LoneCamera {
 public:
  /// `camera` has a pose in the world, and must outlive this object.
  LoneCamera(const DepthCamera& camera, const TrackedPerson::Options& options);

  /// `t` (s) increases; `known` may be empty. The image must be valid until the next call.
  void see(double t, const DepthFrame& frame, const KnownThings& known);

  /// middleJoints() of the people found in the last image.
  std::span<const humanmodel::SkeletonFrame> people() const { return people_; }
  /// Whether the last image shows free space where this person would be: most of the joints are more than
  /// kBehind in front of what is seen there.
  bool seesThrough(const humanmodel::SkeletonFrame& person) const;
  /// The last image, with its people.
  LabelledImage labelled() const { return {&moment_.frames.front()->image, camera_, views_.labels(0)}; }
  /// s, CameraWatch::movedAt() and unchangedSince().
  double movedAt() const { return views_.movedAt(0); }
  double unchangedSince() const { return views_.unchangedSince(0); }

  static constexpr double kBehind = 0.3;  ///< m; a body is no thicker

 private:
  const DepthCamera* camera_;
  TrackedPerson::Options options_;
  PeopleViews views_;
  DepthMoment moment_;
  std::map<int, TrackedPerson> trackers_;
  std::vector<humanmodel::SkeletonFrame> people_;
};

}  // namespace abstand::tracking
