// People tracked with one of several cameras alone.
#pragma once

#include <algorithm>
#include <functional>
#include <map>

#include "tracking/tracker/people_views.hpp"
#include "tracking/tracker/seen_through.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// Tracks the people in the images of one camera in one pass, with usual bodies and without spreads, to
/// compare their places with those that other cameras give. One thread. Allocates while people appear.
class LoneCamera {
 public:
  /// `camera`: number `number` of the PeopleViews; has a pose in the world, and must outlive this object.
  LoneCamera(const DepthCamera& camera, std::size_t number, const TrackedPerson::Options& options);

  /// After `views` has seen the moment, with an image of this camera. Both must be valid until the next call.
  void see(const DepthMoment& moment, PeopleViews& views);

  const DepthCamera& camera() const { return *camera_; }
  /// A person found in the last image.
  struct Seen {
    int id;  ///< PeopleViews::idOf()
    humanmodel::SkeletonFrame joints;
    humanmodel::SkeletonFrame middles;  ///< middleJoints()
    double explained;                   ///< DepthMisfit::explained
    /// Whether the body explains nearly all points, so that its place counts.
    bool hasPlace() const { return explained >= kPlaceExplained; }
  };
  std::span<const Seen> people() const { return people_; }
  bool findsPlaces() const {
    return std::any_of(people_.begin(), people_.end(), std::mem_fn(&Seen::hasPlace));
  }
  /// Whether the last image shows free space where this person would be: most of the joints are more than
  /// kBehind in front of what is seen there.
  bool seesThrough(const humanmodel::SkeletonFrame& person) const;
  /// The last image, with its people.
  LabelledImage labelled() const { return {image_, camera_, labels_}; }

  static constexpr double kBehind = 0.3;          ///< m; a body is no thicker
  static constexpr double kPlaceExplained = 0.9;  ///< share of the points

 private:
  const DepthCamera* camera_;
  std::size_t number_;
  TrackedPerson::Options options_;
  const DepthImage* image_{nullptr};      ///< null: none so far
  std::span<const std::uint8_t> labels_;  ///< of its pixels
  std::map<int, TrackedPerson> trackers_;
  std::vector<Seen> people_;
};

}  // namespace abstand::tracking
