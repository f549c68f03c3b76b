// Values of all pairs of a recording, as its result file has them.
#pragma once

#include <vector>

#include "app/hdf5/table_reader.hpp"
#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Some frames, row by row: a row a frame, with a number for each of PassResult::pairs. Result files round to
/// the safe side (docs/margins.md, "Result files").
struct StoredPairs {
  std::vector<double> distance, bound;  ///< m
  std::vector<double> uncertainty;      ///< m, of the person's pose; infinite: not seen
  std::vector<double> clearance;  ///< m, certified: distance - bound - uncertainty; -infinity: not known
  /// m/s, of the nearest points towards each other; 0 where one goes away.
  std::vector<double> robot_speed, person_speed;
  /// m, world, x y z of each pair: nearest points; NaN beyond 0.5 m.
  std::vector<double> on_part, on_link;
};

/// Reads any frames of one result file. One thread.
class StoredPairReader {
 public:
  /// The recording was read from a result file (TunedRecording::file) and outlives this object. Throws
  /// ParseError.
  explicit StoredPairReader(const TunedRecording& recording);

  /// `count` frames from frame `first` on. Throws ParseError.
  StoredPairs rows(std::size_t first, std::size_t count) const;

 private:
  const TunedRecording& recording_;
  hdf5::TableReader file_;
};

}  // namespace abstand::tune
