// Exposure over all recordings: by body part, link, pair, program segment, and place.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

struct ExposureRow {
  std::string part, link;      ///< empty: all
  double t0{kNaN}, t1{kNaN};   ///< s, of a segment of the program
  margin::ExposureTime spent;  ///< as in Exposure
  double time{0.0}, not_seen{0.0};
  std::size_t approaches{0};   ///< near misses: local minima of a part's clearance below PassOptions::near
  double closing{-kInfinity};  ///< m/s, as in Exposure; for a segment: only of each part's nearest link
  /// The smallest known clearance; empty if there is none.
  struct Nearest {
    double clearance{0.0};  ///< m, certified
    std::string recording, part, link;
    double t{0.0};
  };
  std::optional<Nearest> nearest;
};

struct ExposureTable {
  double near{0.0};  ///< m, PassOptions::near
  ExposureRow body;
  std::vector<ExposureRow> parts, links, pairs;  ///< in the order of the recordings
  std::vector<ExposureRow> phases;               ///< in order of time
  struct Cell {
    std::string part;
    std::size_t cell{0};  ///< humanmodel::cellOf
    margin::ExposureTime spent;
  };
  std::vector<Cell> body_cells;  ///< those with exposure
  std::vector<FloorCell> floor_cells;
  /// Outlines of the robots, from the first recording.
  struct Outline {
    std::string link;
    std::vector<Eigen::Vector2d> corners;  ///< m, world
  };
  std::vector<Outline> outlines;
};

/// Sums over the recordings. `segment`: s, length of the program segments, at the same times in every
/// recording, as in speedTable(). `near`: m, as used in the runs of the recordings.
ExposureTable exposureTable(const std::vector<TunedRecording>& recordings, double segment, double near);

}  // namespace abstand::tune
