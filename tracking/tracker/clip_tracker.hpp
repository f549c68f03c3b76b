// Skeleton recordings of the people in depth recordings.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "tracking/recording/recording.hpp"
#include "tracking/tracker/depth_moments.hpp"
#include "tracking/tracker/people_views.hpp"
#include "tracking/tracker/tracked_person.hpp"

namespace abstand::tracking {

/// A person in an image; valid during the call. Of several cameras the first that sees the person.
struct ClipMoment {
  std::size_t image;
  int id;
  const DepthFrame& frame;
  const DepthCamera& camera;
  const std::shared_ptr<const BodyRig>& rig;
  const TrackedBody& body;
};

struct ClipTrackerOptions {
  TrackedPerson::Options person;
  double until{kInfinity};  ///< s; later images are not tracked
  /// Images done, and total, of both passes; may be empty.
  std::function<void(std::size_t, std::size_t)> progress;
  std::function<bool()> interrupted;             ///< may be empty
  KnownThings known;                             ///< may be empty
  std::function<void(const ClipMoment&)> watch;  ///< may be empty
};

/// Result for one person.
struct ClipPerson {
  int id{0};
  humanmodel::HumanOptions body;
  Stature stature;
  Facing facing;  ///< in the first seconds
  std::vector<humanmodel::SkeletonFrame>
      frames;             ///< for every image from the first to the last that shows the person
  std::size_t found{0};   ///< images in which the body was found
  double residual{kNaN};  ///< m, mean over these images of the RMS distance to the body
  /// Images in which the left and the right hand held a thing, and the largest extent (m) beyond the hand.
  std::array<std::size_t, 2> held{};
  HeldThings::Extents held_extent{};
};

struct ClipTrack {
  /// The first, with the pose that defines the skeletons' world; its spread is the largest of all cameras.
  DepthCamera camera;
  std::vector<CameraShare> cameras;
  double lag{0.0};                 ///< s, largest difference in time of images that were fitted together
  std::string world;               ///< source of that pose
  std::vector<ClipPerson> people;  ///< sorted by the number of images found, descending
  std::size_t images{0};           ///< images of one camera, moments of several
  double begin{0.0};               ///< s, of the first one
  double seconds{0.0};             ///< s of processor time of all passes, without reading images
  bool interrupted{false};
};

/// Records the result of an image for person `id` of the finder; `body` null: not found. `place` maps ids to
/// indices in track.people, and grows. Frames are added if `keep`, with the camera's spread.
void noteMoment(ClipTrack& track, std::map<int, std::size_t>& place, int id, double t,
                const TrackedBody* body, bool keep);
/// After noteMoment() with a body that was found: things in the person's hands.
void noteHeld(ClipPerson& person, const HeldThings::Extents& extent);
/// Loses everybody since `t` (s): those frames were fitted to images of a camera that had been moved.
void loseSince(ClipTrack& track, double t);
/// Adds to the joints of `frame` what each moved since `before` in `lag` (s) at that speed.
void widenByLag(double lag, const humanmodel::SkeletonFrame& before, humanmodel::SkeletonFrame& frame);
/// Call after the last image: turns sums of residuals into means and sorts people by the number of images
/// found.
void finishTrack(ClipTrack& track);

/// Two passes over the stream: the first finds the people and learns the size of each from the first seconds
/// in view, the second tracks their bodies. A person who was in images before the first one in which the body
/// is found is tracked backwards through these (KeptImages). If the recording has no camera pose, it is
/// estimated from the floor; without a visible floor the camera is assumed level, see CameraStand. Throws
/// ParseError for images that cannot be read.
ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options);

/// The same for several cameras that look at the same people: one fit to the images of all of them. Each must
/// know its pose in one world. Images that lie beside each other in time (DepthMoments) are fitted together;
/// what a joint moves between them is added to its spread. Throws UsageError for no camera, more than
/// BodyObservation::kMaxViews, or one without a pose.
ClipTrack trackClips(std::span<const ClipCamera> cameras, const ClipTrackerOptions& options);

}  // namespace abstand::tracking
