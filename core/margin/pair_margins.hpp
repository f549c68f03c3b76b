// Speed-dependent margins of single pairs, and the outcome of many sets of them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/margin/frame_block.hpp"
#include "core/margin/threshold_masks.hpp"

namespace abstand::margin {

/// Margin of a pair of a body part and a link. It increases with the approach speeds of the nearest points of
/// the two bodies; a receding body adds nothing.
struct PairMargin {
  double margin{0.0};       ///< m
  double robot_time{0.0};   ///< s: m per m/s of the link
  double person_time{0.0};  ///< s: m per m/s of the part

  /// Margin (m) at these speeds (m/s).
  double at(double robot_speed, double person_speed) const;
  bool operator==(const PairMargin&) const = default;
};

/// Throws UsageError for values that are negative or not finite.
void validate(const PairMargin& margin);

/// One frame of a recording. Lists have an entry for each pair.
struct PairFrame {
  double t{0.0};                                      ///< s
  std::span<const double> clearance;                  ///< m, certified
  std::span<const double> robot_speed, person_speed;  ///< m/s, towards each other
  double between{kInfinity}, braking{kInfinity};      ///< m, minimum over all pairs
};

/// The outcomes of many sets of margins, a margin for each pair in each set, in one pass over a recording.
/// The robot is told to stop where any pair is inside its own. Frames are judged in blocks: a set costs a
/// comparison for each pair, a search for each pair that is near, and a few operations for each stop. Memory
/// does not grow with the recording. One thread.
class PairMarginSets {
 public:
  /// Throws UsageError for no set, for sets of different lengths and for bad margins.
  PairMarginSets(std::vector<std::vector<PairMargin>> sets, const MarginOptions& options);

  void add(const PairFrame& frame);
  /// Outcome of each set, in order. Call once, after the last frame.
  std::vector<MarginOutcome> finish();
  /// `hear` is called at the end of each stop with the index of the set.
  void onStop(const std::function<void(std::size_t set, const Stop& stop)>& hear);

 private:
  struct Set {
    std::vector<PairMargin> margins;
    std::vector<double> fixed;  ///< m, of margins that do not depend on speeds; else empty
    double largest{0.0};        ///< m, of `fixed`
    OutcomeStream stream;
  };
  void settle();
  /// Frames of the block in which some pair is inside its margin, a bit each.
  std::uint64_t inside(const Set& set);
  std::uint64_t insideFixed(const std::vector<double>& margins, double largest_margin);
  /// Of one pair in the block.
  std::uint64_t inside(std::size_t pair, const PairMargin& margin) const;
  std::size_t at(std::size_t pair) const { return pair * FrameBlock::kFrames; }

  std::size_t pairs_;
  MarginOptions options_;
  std::vector<Set> sets_;
  FrameBlock block_;
  std::vector<double> clearance_, robot_speed_, person_speed_;     ///< of the block's frames, pair by pair
  std::vector<double> least_, largest_;                            ///< m, of each pair in the block
  double block_minimum_{kInfinity}, smallest_maximum_{kInfinity};  ///< m, the least of those two lists
  std::vector<double> fastest_robot_, fastest_person_;             ///< m/s, likewise
  std::vector<std::optional<ThresholdMasks>> masks_;               ///< of pairs that were near in the block
};

}  // namespace abstand::margin
