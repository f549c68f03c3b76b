// The size of a person from the first seconds of depth.
#pragma once

#include <vector>

#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// Collects images of one person together with the poses that a tracker found in them, and looks for the body
/// that explains them best. May allocate.
class BodyCalibration {
 public:
  static constexpr std::size_t kMaxImages = 8;

  /// Keeps images that are explained well, at least 0.2 s apart, until there are kMaxImages.
  void add(double t, const BodyTracker& tracker);
  bool complete() const { return images_.size() == kMaxImages; }

  /// How much worse the images are explained when the person faces the other way: ratio of the costs, each
  /// image fitted anew. NaN without images.
  double whenTurned(const humanmodel::HumanOptions& body) const;
  /// From now on the images are of a person who faces the other way.
  void turnRound(const humanmodel::HumanOptions& body);

  /// Lengths of trunk, arms and legs, and girths: one after the other by a few per cent, each image fitted
  /// anew, as long as the images are explained better. The height of `start` stays, and so do the parts that
  /// it overrides. Without images `start` itself.
  humanmodel::HumanOptions fit(const humanmodel::HumanOptions& start) const;

 private:
  struct Image {
    double t;
    BodyObservation seen;
    RigPose pose;
  };
  std::vector<RigPose> poses() const;
  std::vector<RigPose> turnedPoses(const humanmodel::HumanOptions& body) const;
  double costOf(const humanmodel::HumanOptions& options, int steps, std::vector<RigPose>& poses) const;

  std::vector<Image> images_;
};

}  // namespace abstand::tracking
