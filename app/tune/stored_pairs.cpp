#include "app/tune/stored_pairs.hpp"

#include <cmath>

namespace abstand::tune {
namespace {

/// m: a larger number does not fit into the file, where it stands for infinity.
constexpr double kLargestStored = 2147483647.0 * 1e-5;

}  // namespace

StoredPairReader::StoredPairReader(const TunedRecording& recording)
    : recording_(recording), file_(recording.file) {}

StoredPairs StoredPairReader::rows(std::size_t first, std::size_t count) const {
  const std::size_t pairs = recording_.pass.pairs.size(), all = count * pairs;
  StoredPairs rows;
  rows.distance = file_.rows("distance", first, count, pairs);
  rows.bound = file_.rows("bound", first, count, pairs);
  rows.uncertainty = file_.rows("uncertainty", first, count, pairs);
  rows.clearance.resize(all);
  for (std::size_t i = 0; i < all; ++i) {
    if (!(rows.uncertainty[i] < kLargestStored)) rows.uncertainty[i] = kInfinity;
    const double clearance = rows.distance[i] - rows.bound[i] - rows.uncertainty[i];
    rows.clearance[i] = std::isnan(clearance) ? -kInfinity : clearance;
  }
  const std::vector<double> speeds = file_.rows("pair_speeds", first, count, 2 * pairs);
  rows.robot_speed.resize(all);
  rows.person_speed.resize(all);
  for (std::size_t i = 0; i < all; ++i)
    rows.robot_speed[i] = speeds[2 * i], rows.person_speed[i] = speeds[2 * i + 1];
  const std::vector<double> points = file_.rows("points", first, count, 6 * pairs);
  rows.on_part.resize(3 * all);
  rows.on_link.resize(3 * all);
  for (std::size_t i = 0; i < all; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      rows.on_part[3 * i + k] = points[6 * i + k];
      rows.on_link[3 * i + k] = points[6 * i + 3 + k];
    }
  return rows;
}

}  // namespace abstand::tune
