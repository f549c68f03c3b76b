// Who was near what, for how long and where: of one recording.
#pragma once

#include <cstdint>
#include <vector>

#include "core/margin/exposure_time.hpp"

namespace abstand::tune {

/// Of a body part, a link, a pair of both, or of all together (docs/margins.md, "Exposure").
struct Exposure {
  margin::ExposureTime spent;  ///< of what was seen
  double time{0.0};            ///< s, of all frames
  /// s, in which something of it was not known (isExposureKnown). The bands do not have it: the true time
  /// below a band is at most the sum of both.
  double not_seen{0.0};
  double min_clearance{kInfinity};  ///< m, certified, of what was seen; infinite: nothing was
  double t_min{kNaN};               ///< s, of min_clearance
  std::uint16_t part{0}, link{0};   ///< of min_clearance, indices into PassResult
  /// m/s, the highest speed of nearest points towards each other while nearer than PassOptions::near;
  /// -infinity: nothing was so near.
  double closing{-kInfinity};

  /// A frame that stands for `duration` (s). `clearance`: m, the least of what was seen, +infinity for
  /// nothing; `seen`: all was. True where it is the least so far.
  bool add(double t, double clearance, bool seen, double duration) {
    time += duration;
    if (!seen) not_seen += duration;
    spent.add(clearance, duration);
    if (!(clearance < min_clearance)) return false;
    min_clearance = clearance;
    t_min = t;
    return true;
  }
};

/// Of the surface of a part: see humanmodel/body_cells.hpp. Each frame counts for the cell that holds the
/// part's nearest point to its nearest link, so the cells of a part add up to the exposure of the part.
struct BodyCell {
  std::uint16_t part{0}, cell{0};  ///< part: index into PassResult::parts
  margin::ExposureTime spent;
};

inline constexpr double kFloorCell = 0.05;  ///< m, edge of a cell of the floor

/// What a cell of the floor counts.
enum class FloorLayer : std::uint8_t {
  kPeople,  ///< nearest points on people
  kRobots,  ///< the points on robots that they were nearest to
};

/// The square from (x, y) to (x + 1, y + 1) times kFloorCell, world, over the whole height. Its time is that
/// in which the nearest point of some part to its nearest link was there; two parts at once count once.
struct FloorCell {
  FloorLayer layer{FloorLayer::kPeople};
  int x{0}, y{0};
  margin::ExposureTime spent;
};

/// The convex outline of a link from above in the first frame, for drawings.
struct LinkOutline {
  std::uint16_t link{0};
  std::vector<Eigen::Vector2d> corners;  ///< m, world
};

struct PassExposure {
  Exposure body;                       ///< of all pairs
  std::vector<Exposure> parts, links;  ///< in the order of PassResult's
  struct Pair {
    std::uint16_t part, link;
    Exposure exposure;
  };
  std::vector<Pair> pairs;             ///< in order of part and link
  std::vector<BodyCell> body_cells;    ///< those with some exposure, in order
  std::vector<FloorCell> floor_cells;  ///< likewise
  std::vector<LinkOutline> outlines;
};

}  // namespace abstand::tune
