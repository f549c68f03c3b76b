// Speed-dependent margins of single pairs, and the outcome of many sets of them.
#pragma once

#include <span>
#include <vector>

#include "core/margin/outcome_stream.hpp"

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

/// Outcomes of many sets of margins, each with a margin for each pair, in one pass over a recording. A stop
/// is commanded if any pair is inside its margin. Memory does not grow with the recording. One thread.
class PairMarginSets {
 public:
  /// Frames judged together: a set whose margins are not reached in them costs one comparison for each pair.
  static constexpr std::size_t kBlock = 64;

  /// Throws UsageError for no set, sets of different lengths and invalid margins.
  PairMarginSets(std::vector<std::vector<PairMargin>> sets, const MarginOptions& options);

  void add(const PairFrame& frame);
  /// Outcome of each set, in order. Call once, after the last frame.
  std::vector<MarginOutcome> finish();
  /// `hear` is called at the end of each stop with the index of the set.
  void onStop(const std::function<void(std::size_t set, const Stop& stop)>& hear);

 private:
  struct Row {
    double t, clearance, between, braking;
  };
  void settle();
  void judge(std::size_t set);

  std::size_t pairs_;
  MarginOptions options_;
  std::vector<std::vector<PairMargin>> sets_;
  std::vector<OutcomeStream> streams_;
  std::vector<Row> rows_;
  std::vector<double> clearance_, robot_speed_, person_speed_;  ///< of the block, row by row
  std::vector<double> least_, fastest_robot_, fastest_person_;  ///< extremes of each pair in the block
  double block_least_{kInfinity}, block_between_{kInfinity};
  std::vector<std::size_t> near_;  ///< pairs that may be inside in the block
};

}  // namespace abstand::margin
