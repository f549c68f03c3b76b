// Exposure over all recordings: of body parts, links, pairs, stretches of the program, and places.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

struct ExposureRow {
  std::string part, link;      ///< empty: all
  double t0{kNaN}, t1{kNaN};   ///< s, of a stretch of the program
  margin::ExposureTime spent;  ///< as in Exposure
  double time{0.0}, not_seen{0.0};
  std::size_t approaches{0};   ///< near misses: local minima of a part's clearance below PassOptions::near
  double closing{-kInfinity};  ///< m/s, as in Exposure; of a stretch: of each part's nearest link only
  /// The least clearance of what was seen; none where nothing was.
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
  std::vector<ExposureRow> phases;               ///< rising in time
  struct Cell {
    std::string part;
    std::size_t cell{0};  ///< humanmodel::cellOf
    margin::ExposureTime spent;
  };
  std::vector<Cell> body_cells;  ///< those with some exposure
  std::vector<FloorCell> floor_cells;
  /// Of the robots, as the first recording has them.
  struct Outline {
    std::string link;
    std::vector<Eigen::Vector2d> corners;  ///< m, world
  };
  std::vector<Outline> outlines;
};

/// Sums of the recordings. `segment`: s, length of the stretches of the program, which are the same times in
/// every recording, as in speedTable(). `near`: m, with which the recordings were run.
ExposureTable exposureTable(const std::vector<TunedRecording>& recordings, double segment, double near);

}  // namespace abstand::tune
