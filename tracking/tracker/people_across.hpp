// Common ids for people whom several depth cameras see.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::tracking {

/// A person found in the image of one camera.
struct SeenPlace {
  std::size_t camera;
  int id;                 ///< of the camera's PeopleFinder
  Eigen::Vector2d place;  ///< m, estimated middle of the body on the floor, world
};

/// Matches people by their places on the floor: found within 0.5 m of a person of another camera, they are
/// the same. A match persists as long as both cameras keep their ids; after half a second of other evidence
/// it is given up (views farther apart than 0.9 m) or made (views of two people within 0.5 m). One thread;
/// may allocate.
class PeopleAcross {
 public:
  /// `t` (s) increases. Ids from 1, for each of `seen`; a person is seen by each camera at most once. Valid
  /// until the next call.
  std::span<const int> match(double t, std::span<const SeenPlace> seen);

 private:
  using Key = std::pair<std::size_t, int>;  ///< camera, id of its finder
  struct Person {
    Eigen::Vector2d place{Eigen::Vector2d::Zero()};
    double t{-kInfinity};  ///< s, of the place
  };
  struct Member {
    int person;
    double doubted_since{kInfinity};  ///< s, since when the place tells otherwise
  };

  int nearest(double t, std::span<const SeenPlace> seen, std::size_t i) const;
  bool isTaken(std::span<const SeenPlace> seen, std::size_t camera, int person) const;
  void place(double t, std::span<const SeenPlace> seen);
  void doubt(double t, std::span<const SeenPlace> seen, std::size_t i);

  std::map<Key, Member> members_;
  std::map<int, Person> persons_;
  std::vector<int> ids_;
  int next_{1};
};

}  // namespace abstand::tracking
