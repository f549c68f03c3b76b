// Exposure of one recording: who was near what, for how long and where.
#pragma once

#include <cstdint>
#include <vector>

#include "core/margin/exposure_time.hpp"

namespace abstand::tune {

/// Exposure of a body part, a link, a pair of both, or of all together (docs/margins.md, "Exposure").
struct Exposure {
  margin::ExposureTime spent;  ///< time with known clearances
  double time{0.0};            ///< s, of all frames
  /// s, in which part of it was unknown (isExposureKnown). Not included in the bands: the true time below a
  /// band is at most the sum of both.
  double not_seen{0.0};
  double min_clearance{kInfinity};  ///< m, certified, over known clearances; infinite: none
  double t_min{kNaN};               ///< s, time of min_clearance
  std::uint16_t part{0}, link{0};   ///< of min_clearance, indices in PassResult
  /// m/s, highest closing speed of the nearest points while nearer than PassOptions::near; -infinity: never
  /// so near.
  double closing{-kInfinity};

  /// Adds a frame that represents `duration` (s). `clearance`: m, smallest known one, +infinity for none;
  /// `seen`: all were known. True if it is the smallest so far.
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

/// Exposure of a surface cell of a part, see humanmodel/body_cells.hpp. Each frame counts for the cell with
/// the part's nearest point to its nearest link, so the cells of a part sum to the exposure of the part.
struct BodyCell {
  std::uint16_t part{0}, cell{0};  ///< part: index in PassResult::parts
  margin::ExposureTime spent;
};

inline constexpr double kFloorCell = 0.05;  ///< m, edge of a cell of the floor

/// What a floor cell counts.
enum class FloorLayer : std::uint8_t {
  kPeople,  ///< nearest points on people
  kRobots,  ///< the corresponding points on robots
};

/// The square from (x, y) to (x + 1, y + 1) times kFloorCell, world, at any height. Its time is that in which
/// the nearest point of any part to its nearest link was there; two parts at the same time count once.
struct FloorCell {
  FloorLayer layer{FloorLayer::kPeople};
  int x{0}, y{0};
  margin::ExposureTime spent;
};

/// Convex outline of a link from above in the first frame, for drawings.
struct LinkOutline {
  std::uint16_t link{0};
  std::vector<Eigen::Vector2d> corners;  ///< m, world
};

struct PassExposure {
  Exposure body;                       ///< of all pairs together
  std::vector<Exposure> parts, links;  ///< in the order of PassResult's
  struct Pair {
    std::uint16_t part, link;
    Exposure exposure;
  };
  std::vector<Pair> pairs;             ///< in order of part and link
  std::vector<BodyCell> body_cells;    ///< those with exposure, in order
  std::vector<FloorCell> floor_cells;  ///< likewise
  std::vector<LinkOutline> outlines;
};

}  // namespace abstand::tune
