// People in the images of several depth cameras.
#pragma once

#include <functional>

#include "tracking/depth/people/camera_watch.hpp"
#include "tracking/depth/people/people_finder.hpp"
#include "tracking/tracker/body_observation.hpp"
#include "tracking/tracker/depth_moments.hpp"
#include "tracking/tracker/people_across.hpp"

namespace abstand::tracking {

/// Depth image (m; 0: none) of known objects at a time, such as a robot; their pixels are not assigned to
/// people.
using KnownThings = std::function<const DepthImage*(double, const DepthCamera&)>;

/// Share of one camera in a track.
struct CameraShare {
  std::size_t images{0};    ///< images that were used
  std::size_t without{0};   ///< moments without an image of this camera
  std::size_t people{0};    ///< images with at least one person
  std::size_t repeated{0};  ///< images equal to the one before
  /// s, of the camera's first image after it was moved (CameraWatch); infinite: it was not. From then on its
  /// images are not used, as its pose is not known, and nobody is found at the moments that had been tracked.
  double moved_at{kInfinity};
  /// s, since which the camera repeated an image for kHung or longer for the first time; infinite: it did
  /// not. Of several recordings and of live cameras, its images are not used then.
  double hung_at{kInfinity};
  /// Of several recordings, CameraFault::Kind::kApart and kLate: s since when, infinite: never; and the
  /// largest distance (m) and difference in time (s).
  double apart_since{kInfinity}, apart{0.0};
  bool apart_certain{true};  ///< it is this camera; otherwise all joints are as uncertain as that
  double late_since{kInfinity}, late{0.0};

  static constexpr double kHung = 0.2;  ///< s, six images of a Kinect
};

/// Throws UsageError unless `count` cameras can be used together: 1 to BodyObservation::kMaxViews, several of
/// them with poses in one world.
void requireCameras(std::size_t count, bool poses_known);

/// Finds the people of each moment in the images of all cameras, with common ids. A camera that was moved is
/// not used any more. One that hangs, so that its images have been equal for `hung_after` (s), is not used
/// until there is another image: the noise of a depth camera makes all images differ. One thread. Allocates
/// while people appear.
class PeopleViews {
 public:
  /// With poses in one world; they must outlive this object.
  explicit PeopleViews(std::span<const DepthCamera> cameras, double hung_after = kInfinity);

  /// For each camera, what a first pass over the same recordings has seen (PeopleFinder::expect).
  void expect(const std::vector<SeenBefore>& seen);
  std::vector<SeenBefore> seen() const;
  std::vector<std::vector<Arrival>> arrivals() const;

  /// `moment.t` (s) increases; it must be valid until the last call of each(). `known` may be empty.
  void see(const DepthMoment& moment, const KnownThings& known);
  /// Adds the last moment to `shares`, one for each camera. Returns the time (s) since which the images of a
  /// camera that is now known to be moved are wrong; infinite: none.
  double note(std::vector<CameraShare>& shares) const;

  /// CameraWatch::movedAt(), s; infinite: not moved.
  double movedAt(std::size_t camera) const { return views_[camera].watch.movedAt(); }
  /// CameraWatch::unchangedSince(), s.
  double unchangedSince(std::size_t camera) const { return views_[camera].watch.unchangedSince(); }
  /// From the next moment on, the images of a camera are not used, or are again.
  void leaveOut(std::size_t camera, bool is_out) { views_[camera].is_out = is_out; }
  bool isMoved(std::size_t camera) const { return std::isfinite(movedAt(camera)); }
  /// At the last moment.
  bool isHung(std::size_t camera) const;
  /// For each pixel of a camera's last image, not 0 for people (PeopleImage::label).
  std::span<const std::uint8_t> labels(std::size_t camera) const {
    return views_[camera].finder.people().label;
  }
  /// Id of a person of the last moment in the images of one camera; -1: it does not see the person.
  int idOf(int person, std::size_t camera) const;
  bool empty() const { return sightings_.empty(); }
  std::size_t size() const { return views_.size(); }

  /// Calls use(id, index of the first camera that sees the person, one PersonImage for each that does), by
  /// increasing id.
  template <class Use>
  void each(Use use) {
    for (std::size_t k = 0; k < sightings_.size();) {
      const int person = sightings_[k].person;
      const std::size_t first = sightings_[k].camera;
      images_.clear();
      for (; k < sightings_.size() && sightings_[k].person == person; ++k)
        images_.push_back(imageOf(sightings_[k]));
      use(person, first, std::span<const PersonImage>(images_));
    }
  }
  /// Calls use(idOf(), PersonImage) for the people of the last moment in the images of one camera.
  template <class Use>
  void eachIn(std::size_t camera, Use use) {
    for (const Sighting& sighting : sightings_)
      if (sighting.camera == camera) use(sighting.id, imageOf(sighting));
  }
  /// Calls use(PersonImage, idOf() of the later person) for people before their arrival, whom each() leaves
  /// out (PeopleFinder::expect).
  template <class Use>
  void eachForeseen(Use use) {
    for (const Sighting& sighting : foreseen_) use(imageOf(sighting), sighting.id);
  }

 private:
  struct View {
    const DepthCamera* camera;
    PeopleFinder finder;
    CameraWatch watch;
    std::vector<std::uint8_t> mask;
    bool is_out{false};
  };
  /// A person in one camera's image.
  struct Sighting {
    int person;  ///< common to all cameras
    std::size_t camera;
    int id;  ///< of the camera's finder
  };
  PersonImage imageOf(const Sighting& sighting);

  std::vector<View> views_;
  double hung_after_;
  PeopleAcross across_;
  std::vector<Sighting> sightings_, foreseen_;
  std::vector<SeenPlace> places_;
  std::vector<PersonImage> images_;
  const DepthMoment* moment_{nullptr};
};

}  // namespace abstand::tracking
