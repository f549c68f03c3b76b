// What all engines did in one run, side by side.
#pragma once

#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/engine.hpp"

namespace abstand::bench {

/// Times of every frame, and what was said of distances and touching. Where a frame was run several times,
/// the least time counts: its work is the same each time, and what comes on top is the machine's. One thread.
class Ledger {
 public:
  /// `answers` of kDistance and kCollide are kept for the accuracy table; of other work they are not looked
  /// at.
  void add(const BenchScene& scene, Work work, Kind kind, std::size_t frame, double seconds,
           std::span<const Answer> answers);
  bool empty() const { return rows_.empty(); }
  /// Two Markdown tables: times with ratios, and distances against FCL's. A ratio is the median of the
  /// other's times over the median of ours on the same frames.
  void print(std::ostream& out) const;

 private:
  struct Row {
    std::map<std::size_t, double> times;  ///< us, of each frame
    std::map<std::size_t, std::vector<Answer>> answers;
  };
  struct Key {
    std::size_t scene;
    Work work;
    Kind kind;
    auto operator<=>(const Key&) const = default;
  };
  std::size_t indexOf(const BenchScene& scene);
  const Row* find(std::size_t scene, Work work, Kind kind) const;
  void printTimes(std::ostream& out) const;
  void printAccuracy(std::ostream& out) const;

  std::vector<const BenchScene*> scenes_;
  std::map<Key, Row> rows_;
};

}  // namespace abstand::bench
