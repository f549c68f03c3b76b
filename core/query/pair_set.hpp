// Pairs of bodies that are asked together, cycle after cycle.
#pragma once

#include <span>
#include <vector>

#include "core/query/pair_query.hpp"
#include "core/query/penalty_force.hpp"

namespace abstand::query {

/// Batch queries: contacts only, or the minimum only: the forces of those that touch, or the one that is
/// nearest. Pairs that are far apart end at their bounding spheres, others at the line across which they were
/// apart before. Forces, and the distance of the nearest pair, are those of queryPair() with a memory. One
/// thread; no allocation after construction, no throw.
class PairSet {
 public:
  struct Bodies {
    std::uint32_t a, b;  ///< indices of the structures
  };
  /// A pair whose margins overlap.
  struct Touch {
    std::uint32_t pair;
    PenaltyForce penalty;
  };
  struct Nearest {
    std::uint32_t pair{0};
    PairResult result;
  };

  /// The structures must outlive the set. At least one pair.
  PairSet(std::vector<const structure::HapticStructure*> structures, std::vector<Bodies> pairs);

  std::size_t size() const { return pairs_.size(); }

  /// All of a pair, for every one. `X_WB`: a pose for each structure; `results` has a place for each pair.
  void distances(std::span<const Transform> X_WB, const PairOptions& options, std::span<PairResult> results);

  /// The pairs that touch, in order; where they touch between the points only, without a force. Valid until
  /// the next call.
  std::span<const Touch> contacts(std::span<const Transform> X_WB, const PairOptions& options);

  /// The smallest signed distance of all; of several, the pair of the last call before the first in order.
  const Nearest& nearest(std::span<const Transform> X_WB, const PairOptions& options);

 private:
  /// Unit vector from B to A along which the two were apart, in the axes of each. Zero: none is known.
  struct Line {
    Vector3d in_a{Vector3d::Zero()}, in_b{Vector3d::Zero()};
  };
  /// Calls until it is worth to look for another line: the longer, the more often there was none.
  struct Backoff {
    std::uint32_t left{0}, next{0};
    bool waits() { return left > 0 && left-- > 0; }
    void failed(std::uint32_t least, std::uint32_t most);
  };
  struct Lines {
    Line last, before;  ///< `before`: another one than the last, for bodies that jump to and fro
    PartAxes of_parts;
    Backoff hulls, parts;
  };
  struct Ball {
    Vector3d centre;  ///< world
    double radius;
  };

  void place(std::span<const Transform> X_WB);
  bool ballsApart(const Bodies& pair, double by) const;
  /// The pair's hulls are known to be farther apart than this (m).
  bool knownApart(std::size_t pair, std::span<const Transform> X_WB, double by);
  /// The same of all of their parts.
  bool partsApart(std::size_t pair, std::span<const Transform> X_WB, double by);
  bool seekLine(std::size_t pair, std::span<const Transform> X_WB, double by);
  void keepLine(std::size_t pair, std::span<const Transform> X_WB, const Vector3d& n);

  std::vector<const structure::HapticStructure*> structures_;
  std::vector<Bodies> pairs_;
  std::vector<Ball> balls_;  ///< of the structures
  std::vector<Lines> lines_;
  std::vector<PairMemory> memories_;
  std::vector<Touch> touches_;
  kernels::PairScratch scratch_;
  Nearest nearest_;
};

}  // namespace abstand::query
