// Which body parts and links stored clearances are about.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abstand::margin {

/// Constant while clearances are stored.
struct StoreLayout {
  struct Body {
    std::string name;       ///< "operator/hand_left", "left_arm/link7"
    std::size_t object{0};  ///< number of the object in the scene
    std::size_t kind{0};    ///< of a part: the same number for the left hands of all people
  };
  struct Pair {
    std::uint16_t part, link;  ///< indices into `parts` and `links`
  };
  std::vector<Body> parts, links;
  std::vector<Pair> pairs;  ///< those that are checked
};

/// A pair in one frame.
struct PairSample {
  double distance{0.0};     ///< m, measured
  double clearance{0.0};    ///< m, certified: distance - bound - uncertainty; -infinity: not seen
  double uncertainty{0.0};  ///< m, of the poses
  double between{0.0};      ///< m, as ClearanceTrack::between
  double braking{0.0};      ///< m, as ClearanceTrack::braking
  double closing{0.0};      ///< m/s, of the nearest points towards each other
  bool lost{false};         ///< a pose is stale or was rejected
};

}  // namespace abstand::margin
