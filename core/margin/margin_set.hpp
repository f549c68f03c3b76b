// Fast evaluation of many sets of margins over one recording.
#pragma once

#include "core/margin/margin_outcome.hpp"

namespace abstand::margin {

/// Tracks of one recording with the minimum and maximum of every kBlock frames, so that blocks entirely
/// outside or inside are processed at once. A set has a margin for each track; a stop is commanded if any
/// track is inside its own. Constant after construction; every function is thread-safe.
class MarginSets {
 public:
  static constexpr std::size_t kBlock = 64;

  /// The tracks must outlive this object. Throws UsageError for none, and for tracks with different times.
  explicit MarginSets(std::vector<const ClearanceTrack*> tracks);

  std::size_t tracks() const { return tracks_.size(); }
  /// outcome() of all tracks together; for one track identical to outcome(). `margins`: m, one for each
  /// track.
  MarginOutcome outcome(std::span<const double> margins, const MarginOptions& options) const;

 private:
  struct Block {
    double least, largest;  ///< of the clearance
    double between;         ///< minimum
  };
  /// The run of inside frames that starts at `begin`.
  struct Run {
    std::size_t end{0};
    double least{kInfinity};
    std::optional<double> lead_time;
  };
  const Block& block(std::size_t track, std::size_t b) const { return blocks_[track * block_count_ + b]; }
  bool inside(std::size_t frame, std::span<const double> margins) const;
  bool allOutside(std::size_t b, std::span<const double> margins) const;
  bool allInside(std::size_t b, std::span<const double> margins) const;
  double leastAt(std::size_t frame) const;    ///< of the clearance
  double betweenAt(std::size_t frame) const;  ///< minimum over all tracks
  Run runFrom(std::size_t begin, std::span<const double> margins, const MarginOptions& options) const;

  std::vector<const ClearanceTrack*> tracks_;
  std::size_t frames_{0}, block_count_{0};
  std::vector<Block> blocks_;  ///< of each track, concatenated
  std::vector<Block> of_all_;  ///< of all tracks together
};

}  // namespace abstand::margin
