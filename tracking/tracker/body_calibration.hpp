// Estimates body sizes of a person from the first seconds of depth images.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tracking/tracker/body_tracker.hpp"

namespace abstand::tracking {

/// Collects images of one person with the tracked poses, and finds the body sizes that explain them best. May
/// allocate.
class BodyCalibration {
 public:
  static constexpr std::size_t kMaxImages = 8;

  /// Keeps well explained images, at least 0.2 s apart, up to kMaxImages.
  void add(double t, const BodyTracker& tracker);
  bool complete() const { return images_.size() == kMaxImages; }

  /// Ratio of the fit costs if the person faces the other way, each image refitted; above 1: worse. NaN
  /// without images.
  double whenTurned(const humanmodel::HumanOptions& body) const;
  /// Whether the person lies in most of the images, and then, whether on the front, as tracked.
  std::optional<bool> lyingOnFront() const;
  /// Declares that the person in the images faces the other way.
  void flipFacing(const humanmodel::HumanOptions& body);

  /// Statures whose mean bodies explain the images, each image refitted.
  struct PlausibleStatures {
    std::array<double, 2> range;  ///< m, nearly as well as the best one, of which common ones are likelier
    double best;                  ///< m, best whether common or not
    bool is_clear;                ///< `best` is smaller than the common ones, which explain the images worse
  };
  /// Within `limits` (m). nullopt without images.
  std::optional<PlausibleStatures> plausibleStatures(const humanmodel::HumanOptions& start,
                                                     const std::array<double, 2>& limits) const;
  /// Fits the poses to the mean body of another stature (m) than that of `start`, in small steps.
  void changeStature(const humanmodel::HumanOptions& start, double height);

  /// Coordinate search over lengths of trunk, arms and legs, and girths, in steps of a few per cent, each
  /// image refitted, as long as the cost decreases. Lengths stay the usual ones of a person who lies on the
  /// front. Keeps the stature of `start` and the parts that it
  /// overrides. Without images returns `start`.
  humanmodel::HumanOptions fit(const humanmodel::HumanOptions& start) const;

 private:
  struct Image {
    double t;
    BodyObservation seen;
    RigPose pose;
    bool lies;  ///< Lying::lies
  };
  std::vector<RigPose> poses() const;
  std::vector<RigPose> turnedPoses(const humanmodel::HumanOptions& body) const;
  double costOf(const humanmodel::HumanOptions& options, int steps, std::vector<RigPose>& poses) const;

  std::vector<Image> images_;
};

}  // namespace abstand::tracking
