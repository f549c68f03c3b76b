// People of a depth recording as recordings of skeletons.
#pragma once

#include <functional>
#include <map>

#include "tracking/depth/formats/depth_stream.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// A person in an image, as long as the call lasts.
struct ClipMoment {
  std::size_t image;
  int id;
  const DepthFrame& frame;
  const DepthCamera& camera;
  const BodyRig& rig;
  const TrackedBody& body;
};

/// Depths (m; 0: none) of what is known to be there at a time, like a robot; pixels of it are nobody's.
using KnownThings = std::function<const DepthImage*(double, const DepthCamera&)>;

struct ClipTrackerOptions {
  TrackedPerson::Options person;
  std::function<void(std::size_t, std::size_t)> progress;  ///< images done, and all; may be empty
  std::function<bool()> interrupted;                       ///< may be empty
  KnownThings known;                                       ///< may be empty
  std::function<void(const ClipMoment&)> watch;            ///< may be empty
};

/// What became of one person.
struct ClipPerson {
  int id{0};
  humanmodel::HumanOptions body;
  Stature stature;
  Facing facing;  ///< in the first seconds
  std::vector<humanmodel::SkeletonFrame>
      frames;             ///< of every image from the first that shows the person to the last
  std::size_t found{0};   ///< images in which the body was found
  double residual{kNaN};  ///< m, mean over these of the root mean square distance to the body
};

struct ClipTrack {
  DepthCamera camera;              ///< with the pose that the skeletons' world is given by
  std::string world;               ///< where that pose comes from
  std::vector<ClipPerson> people;  ///< who was found in most images first
  std::size_t images{0};
  double seconds{0.0};  ///< of processor time, for all images, without reading them
  bool interrupted{false};
};

/// What an image showed of person `id` of the finder; `body` may be null: not found. `place` says where each
/// number is in track.people, and grows. Frames are added where `keep`, with the camera's spread.
void noteMoment(ClipTrack& track, std::map<int, std::size_t>& place, int id, double t,
                const TrackedBody* body, bool keep);
/// Behind the last image: sums of residuals become means, and who was found in most images comes first.
void finishTrack(ClipTrack& track);

/// Two walks through the stream: the first seconds to learn the sizes of the people, then all of it. People
/// who come later are measured when they come. Where the recording does not say how the camera stands, its
/// floor does; without a floor in sight the camera is taken to be level, over a floor on which the lowest
/// person stands. Throws ParseError for images that cannot be read.
ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options);

}  // namespace abstand::tracking
