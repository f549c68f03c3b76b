// Reads the pairs of a result file, frame by frame.
#pragma once

#include <memory>
#include <vector>

#include "app/hdf5/table_reader.hpp"
#include "app/tune/part_frames.hpp"
#include "core/margin/pair_margins.hpp"

namespace abstand::tune {

/// Reads the values of all pairs of a recording from its result file in blocks of some thousand frames. One
/// thread.
class PairRows {
 public:
  /// The recording has a result file (TunedRecording::file), and `body` is its WholeBody::track; both outlive
  /// this object. `speeds` false: the speeds of pairs are not read, and 0. Throws ParseError.
  explicit PairRows(const TunedRecording& recording, const margin::ClearanceTrack& body, bool speeds = true);

  std::size_t pairs() const { return recording_.pass.pairs.size(); }
  /// Advances to the next frame; false after the last one. Throws ParseError.
  bool next();
  /// Certified clearances of the file, which are rounded to the safe side. The lists are valid until next().
  margin::PairFrame frame() const;
  std::size_t index() const { return index_; }

 private:
  void readBlock();

  const TunedRecording& recording_;
  const margin::ClearanceTrack& body_;
  hdf5::TableReader file_;
  std::size_t index_{0}, first_{0}, rows_{0};  ///< of the frame; of the block in memory
  bool begun_{false}, speeds_;
  std::vector<double> clearance_, robot_speed_, person_speed_;  ///< of the block, row by row
};

}  // namespace abstand::tune
