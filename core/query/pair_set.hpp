// Batch queries of a fixed set of pairs.
#pragma once

#include <span>
#include <vector>

#include "core/query/pair_query.hpp"
#include "core/query/penalty_force.hpp"

namespace abstand::query {

/// Computes less than queryPair() for each pair: the forces of the pairs in contact, or the nearest pair. Far
/// pairs are culled by bounding spheres, others by their last separating axis. Forces, and the distance of
/// the nearest pair, are those of queryPair() with a memory. One thread; no allocation after construction, no
/// throw.
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

  /// Full result of every pair. `X_WB`: a pose for each structure; `results`: one entry for each pair.
  void distances(std::span<const Transform> X_WB, const PairOptions& options, std::span<PairResult> results);

  /// The pairs in contact, in order; contacts only between the shell points have no force. Valid until the
  /// next call.
  std::span<const Touch> contacts(std::span<const Transform> X_WB, const PairOptions& options);

  /// The smallest signed distance of all pairs; if equal, the pair of the last call, then the first in order.
  const Nearest& nearest(std::span<const Transform> X_WB, const PairOptions& options);

 private:
  /// Separating axis: unit vector from B to A, in the axes of each body. Zero: unknown.
  struct SeparatingAxis {
    Vector3d in_a{Vector3d::Zero()}, in_b{Vector3d::Zero()};
  };
  /// Calls until the next search for a separating axis; doubles with failures.
  struct Backoff {
    std::uint32_t remaining{0}, next{0};
    bool shouldSkip() { return remaining > 0 && remaining-- > 0; }
    void failed(std::uint32_t min, std::uint32_t max);
  };
  struct PairAxes {
    SeparatingAxis last, previous;  ///< `previous`: a different earlier axis, for bodies that jump to and fro
    PartAxes of_parts;
    Backoff hull_backoff, parts_backoff;
  };
  struct BoundingSphere {
    Vector3d centre;  ///< world
    double radius;
  };

  void updateSpheres(std::span<const Transform> X_WB);
  bool spheresApart(const Bodies& pair, double by) const;
  /// True if a stored separating axis still proves that the hulls are farther apart than `by` (m).
  bool provenApart(std::size_t pair, std::span<const Transform> X_WB, double by);
  /// The same for the hulls of all parts.
  bool partsApart(std::size_t pair, std::span<const Transform> X_WB, double by);
  bool findAxis(std::size_t pair, std::span<const Transform> X_WB, double by);
  void storeAxis(std::size_t pair, std::span<const Transform> X_WB, const Vector3d& n);

  std::vector<const structure::HapticStructure*> structures_;
  std::vector<Bodies> pairs_;
  std::vector<BoundingSphere> spheres_;  ///< of the structures
  std::vector<PairAxes> axes_;
  std::vector<PairMemory> memories_;
  std::vector<Touch> touches_;
  kernels::PairScratch scratch_;
  Nearest nearest_;
};

}  // namespace abstand::query
