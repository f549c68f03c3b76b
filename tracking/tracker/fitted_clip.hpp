// The bodies that were fitted to the images of a depth recording.
#pragma once

#include <memory>
#include <vector>

#include "tracking/tracker/clip_tracker.hpp"

namespace abstand::tracking {

/// One image with the person's body.
struct FittedImage {
  bool found{false};
  RigPose pose;                        ///< in the world of FittedClip::camera; without meaning if not found
  std::shared_ptr<const BodyRig> rig;  ///< null if not found
  humanmodel::SkeletonFrame joints;    ///< as in the recording
};

/// One person of a depth recording of one camera: enough to draw the body over the images. Constant after
/// construction, shared between threads.
struct FittedClip {
  std::filesystem::path path;
  DepthStreamOptions options;  ///< with which the images were read
  DepthCamera camera;          ///< of the images, with the pose that defines the world
  std::string camera_reason;   ///< source of the intrinsics
  std::string world;           ///< source of the camera's pose
  std::vector<double> times;   ///< s, of all images
  std::vector<FittedImage> images;
  double first_t{0.0};  ///< s, of the first frame of the recording

  /// Index of the image at or just before `t` (s); the first one for earlier times.
  std::size_t imageAt(double t) const;
};

/// Collects fitted bodies while a clip is tracked. One thread.
class FitLog {
 public:
  /// For ClipTrackerOptions::watch.
  void note(const ClipMoment& moment);
  /// Call after tracking: the bodies of `person` in all images of `stream`; path and options are not
  /// set. An image in which the recording
  /// has no pelvis has no body.
  FittedClip clipOf(const ClipTrack& track, std::size_t person, const DepthStream& stream);

 private:
  struct Fit {
    RigPose pose;
    std::shared_ptr<const BodyRig> rig;
  };
  std::map<int, std::map<std::size_t, Fit>> fits_;  // by person and image
};

}  // namespace abstand::tracking
