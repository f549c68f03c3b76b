// Finds people in images of a fixed depth camera.
#pragma once

#include "tracking/depth/people/crouched_people.hpp"
#include "tracking/depth/people/floor_plane.hpp"
#include "tracking/depth/people/followed_people.hpp"
#include "tracking/depth/people/furniture.hpp"
#include "tracking/depth/people/headless_people.hpp"
#include "tracking/depth/people/heads.hpp"
#include "tracking/depth/people/learned_background.hpp"
#include "tracking/depth/people/lying_people.hpp"
#include "tracking/depth/people/plan_view.hpp"
#include "tracking/depth/people/things_beside.hpp"

namespace abstand::tracking {

struct PeopleFinderOptions {
  double nearest{0.4}, farthest{6.0};  ///< m, depth gate
  double learn_after{2.0};    ///< s; an unassigned surface that is static for this long becomes background
  double keep{2.0};           ///< s; time for which an unseen person keeps the id
  double without_head{10.0};  ///< s; time for which a person is followed without a visible head
  std::uint64_t seed{1};      ///< for the floor search
};

/// What a finder knows after a recording.
struct SeenBefore {
  std::vector<Arrival> arrivals;
  std::vector<ThingPixel> things;
};

struct FoundPerson {
  int id{-1};                           ///< constant between images, from 1
  bool foreseen{false};                 ///< before the arrival (PeopleFinder::expect)
  Vector3d centroid{kNaN, kNaN, kNaN};  ///< m, camera's frame: mean over the pixels
  double top{kNaN};                     ///< m above the floor, highest pixel
  std::size_t pixels{0};
  int left{0}, above{0}, right{-1}, below{-1};  ///< bounding box in pixels, inclusive
};

struct PeopleImage {
  std::vector<std::uint8_t> label;   ///< for each pixel: 0 unassigned, else 1 + index in `persons`
  std::vector<FoundPerson> persons;  ///< by increasing id
  std::optional<FloorPlane> floor;   ///< nullopt if the floor was neither given nor found
};

/// Projects pixels that are above the floor, not background and not otherwise known to a plan view. A person
/// is detected by a head: a peak of a head's breadth with free space and shoulders beside it, above enough of
/// a body. Touching people are separated by their heads and their earlier positions; people who overlap in
/// the image but not on the floor are separate anyway. Detected people are followed without a visible head,
/// too. A person who lies is detected by the outline (LyingPeople), one whose head is above the image, or
/// beside or under the hands, by the trunk (HeadlessPeople). One who squats or bends, with the head lower
/// than the back, is detected while moving (CrouchedPeople). Raised fists above one trunk are one person
/// (shareTrunk).
///
/// Surfaces too large and flat for a person (Furniture) belong to nobody, nor do things that stand beside a
/// person (ThingsBeside). A new person near a known one needs a body that is not connected to that of the
/// known one.
///
/// Background is learned for each pixel: the farthest depth of an unassigned surface that was stable for
/// `learn_after`. A detected person is never learned; an undetected person who stands still is. Newly
/// uncovered background has a person's outline but continues the learned background around it: it is learned
/// at once.
///
/// If the camera's X_WC is given (not the identity), the floor is the world's z = 0; otherwise it is
/// searched. If none is found, the lowest object in the image defines it.
///
/// Not shared between threads. find() does not throw, and allocates only for the floor search in the first
/// image. Cost: see README.md.
class PeopleFinder {
 public:
  static constexpr int kMaxPeople = FollowedPeople::kMax;  ///< at once

  explicit PeopleFinder(const DepthCamera& camera, const PeopleFinderOptions& options = {});

  /// Of a finder that has seen the same images: these people get the same ids, and are foreseen in up to
  /// FollowedPeople::kForesight of images before, as soon as half of the surface that they had is at the
  /// place. Things are known from the first image on.
  void expect(SeenBefore seen);
  const std::vector<Arrival>& arrivals() const { return followed_.arrivals(); }
  /// These, and the things in the last image.
  SeenBefore seen() const { return {arrivals(), things_.things()}; }

  /// `t` (s) increases. `known`: depths (m; 0: none) of known objects, such as a robot; pixels within 6 cm of
  /// them or behind them are unassigned. The result is valid until the next call.
  const PeopleImage& find(double t, const DepthImage& image, const DepthImage* known = nullptr);
  const PeopleImage& people() const { return people_; }
  /// 1 for the pixels of a person in the last image, otherwise 0; all 0 if there is no such person.
  void mask(int id, std::vector<std::uint8_t>& is_person) const;

 private:
  using Place = PlanView::Place;
  class PlanAxes;

  void findFloor(double t, const DepthImage& image);
  void estimateFloorFromScene(const DepthImage& image);
  void projectToPlan(const DepthImage& image, const DepthImage* known);
  std::span<const int> columnsToProject(const DepthImage& image, int v, bool notes_background);
  void project(const DepthImage& image, const DepthImage* known, const PlanAxes& axes);
  void addToPlan(std::uint32_t i, const DepthImage& image, const DepthImage* known, float h);
  void removeFurniture(const DepthImage& image, const DepthImage* known, const PlanAxes& axes);
  void addHeads(double t, const DepthImage& image);
  bool hasOwnBody(const Head& head, const DepthImage& image);
  void followLying(double t);
  void followHeadless(double t);
  void followOnFloor(double t);
  void followCrouched(double t);
  void label();
  void dropUncovered(const DepthImage& image);
  void describe(double t, const DepthImage& image);

  DepthCamera camera_;
  PeopleFinderOptions options_;
  FloorFinder floor_finder_;
  FloorPlane plane_;  ///< the floor, or its substitute
  bool floor_given_{false};
  double next_floor_{-kInfinity};  ///< s, time of the next search
  PlanView plan_;
  Furniture furniture_;
  LyingPeople lying_;
  HeadlessPeople headless_;
  CrouchedPeople crouched_;
  ThingsBeside things_;
  SurfacePieces pieces_;
  std::vector<std::uint8_t> is_object_;  ///< of each pixel, for pieces_
  std::vector<int> cell_of_;             ///< of each pixel; -1: ignored
  std::vector<std::uint32_t> objects_;   ///< pixels that have a cell
  std::vector<int> columns_;             ///< of a row
  LearnedBackground background_;
  std::vector<float> x_, y_;  ///< of the rays with z = 1
  std::vector<Head> heads_;
  FollowedPeople followed_;
  PeopleImage people_;
  double last_t_{kNaN};
};

}  // namespace abstand::tracking
