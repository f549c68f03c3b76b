// A body, and what follows it through images.
#pragma once

#include <memory>

#include "tracking/tracker/body_path.hpp"
#include "tracking/tracker/body_tracker.hpp"
#include "tracking/tracker/facing.hpp"
#include "tracking/tracker/held_things.hpp"
#include "tracking/tracker/stature.hpp"

namespace abstand::tracking {

/// A body of a person with its tracker, where it was, and the things in its hands. One thread. Not copied, as
/// the tracker refers to the rig.
struct BodyFollower {
  BodyFollower() = default;  ///< none
  BodyFollower(const humanmodel::HumanOptions& options, const Stature& stature, const Facing& facing,
               std::uint64_t seed);
  explicit operator bool() const { return tracker != nullptr; }

  /// One image of each camera that looks at `t` (s).
  const TrackedBody& track(double t, std::span<const PersonImage> images);
  /// After track(): learns the things in the hands, if the body was found, and widens the hands by them.
  void learn();
  /// Continues where another body of the same person is, on its path.
  void continueFrom(const BodyFollower& last);
  /// Starts where another body with the same rig is, in the image that it tracked last, but facing the other
  /// way: turned in place, or searched for, whichever explains the image better.
  void startTurned(const BodyFollower& last);

  humanmodel::HumanOptions body;
  std::shared_ptr<const BodyRig> rig;
  std::unique_ptr<BodyTracker> tracker;
  HeldThings held;
  BodyPath path;
};

}  // namespace abstand::tracking
