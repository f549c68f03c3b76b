// Where people are in the images of a depth camera that stands still.
#pragma once

#include "tracking/depth/people/floor_plane.hpp"
#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

struct PeopleFinderOptions {
  double nearest{0.4}, farthest{6.0};  ///< m, depth gate
  double learn_after{2.0};    ///< s; what is nobody's and stands still so long is background from then on
  double keep{2.0};           ///< s; a person who is not seen keeps the number so long
  double without_head{10.0};  ///< s; so long a person is followed of whom no head is seen
  std::uint64_t seed{1};      ///< of the search for the floor
};

struct FoundPerson {
  int id{-1};                           ///< the same from image to image, from 1
  Vector3d centroid{kNaN, kNaN, kNaN};  ///< m, in the camera's frame: mean of the pixels
  double top{kNaN};                     ///< m over the floor, of the highest pixel
  std::size_t pixels{0};
  int left{0}, above{0}, right{-1}, below{-1};  ///< pixels, both ends included
};

struct PeopleImage {
  std::vector<std::uint8_t> label;   ///< of each pixel: 0 nobody's, else 1 + index in `persons`
  std::vector<FoundPerson> persons;  ///< by rising id
  std::optional<FloorPlane> floor;   ///< nothing where the floor was neither given nor seen
};

/// Pixels that stand up from the floor, are not background and not known otherwise are looked at from above.
/// A person is a head, as broad as one and with nothing beside it, over enough of a body. Touching people are
/// told apart by their heads, and by where they were before; people who overlap in the image but not on the
/// floor are apart anyway. Who was found once is followed without a head in sight, too.
///
/// Background is learned pixel by pixel: the farthest depth that nobody's surface kept for `learn_after`. A
/// person is never learned as long as he is found; one who is not found and stands still is. A part of the
/// wall that somebody uncovers has his outline, but goes on in the learned wall around it: it is learned at
/// once.
///
/// With a camera whose X_WC is given (not the identity) the floor is the world's z = 0; else it is searched.
/// Where there is none to be seen, the lowest thing in the image stands for it.
///
/// Not shared between threads. find() does not throw, and allocates nothing but for the search of the floor
/// in the first image. Cost: see README.md.
class PeopleFinder {
 public:
  static constexpr int kMaxPeople = 64;

  explicit PeopleFinder(const DepthCamera& camera, const PeopleFinderOptions& options = {});

  /// `t` (s) rises. `known`: depths (m; 0: none) of things that are known, like a robot; pixels within 6 cm
  /// of them or behind are nobody's. The result is there until the next call.
  const PeopleImage& find(double t, const DepthImage& image, const DepthImage* known = nullptr);
  const PeopleImage& people() const { return people_; }
  /// 1 for the pixels of a person of the last image, else 0; all 0 where there is no such person.
  void mask(int id, std::vector<std::uint8_t>& is_person) const;

 private:
  using Place = PlanView::Place;
  struct Track {
    int id{-1};
    Place place{Place::Zero()}, speed{Place::Zero()};  ///< m, m/s
    double born{0.0}, seen{0.0}, headed{0.0};  ///< s, when first, when last, and when last with a head
    bool here{false};                          ///< in this image
    bool matched{false};                       ///< to a head of this image
    bool suspect{false};                       ///< younger than a second, or where it was not before
  };
  struct Head {
    int cell{-1};
    Place place{Place::Zero()};  ///< m
    double body{0.0};            ///< m^2 seen below it, nearer to it than to other heads
  };

  /// What a pixel has been seeing: the mean depth (m; 0: nothing), the mean deviation from it (m), and for
  /// how long (s).
  struct Still {
    float z{0.0f}, wavers{0.0f}, lasts{0.0f};
  };

  void findFloor(double t, const DepthImage& image);
  void estimateFloorFromScene(const DepthImage& image);
  void lookFromAbove(const DepthImage& image, const DepthImage* known);
  void findHeads();
  bool isHead(int cell) const;
  void dropHeadsWithoutBody();
  Place middleOfBody(Place place) const;
  double bodyArea(const Place& place, double radius) const;
  void follow(double t);
  void own();
  void label(const DepthImage& image);
  bool isUncovered(std::size_t track, const DepthImage& image) const;
  void dropUncovered(const DepthImage& image);
  void describe(double t, const DepthImage& image);
  static bool keeps(const Still& still, float z);
  void learn(std::size_t pixel, float z, float dt);

  DepthCamera camera_;
  PeopleFinderOptions options_;
  FloorFinder floor_finder_;
  FloorPlane plane_;  ///< the floor, or what stands for it
  bool floor_given_{false};
  double next_floor_{-kInfinity};  ///< s, when to look for it again
  PlanView plan_;
  std::vector<int> cell_of_;       ///< of each pixel; -1: not looked at
  std::vector<Still> still_;       ///< of nobody's surface, at the moment
  std::vector<Still> background_;  ///< learned; z 0: not
  std::vector<float> x_, y_;       ///< of the rays with z = 1
  std::vector<Head> heads_;
  std::vector<Track> tracks_;
  PeopleImage people_;
  int next_id_{1};
  double last_t_{kNaN};
};

}  // namespace abstand::tracking
