// Many pairs of bodies that are asked together, frame after frame.
#pragma once

#include "abstand/query.hpp"

namespace abstand {

/// Batch queries over pairs that share bodies. Where only the contacts count, or only the smallest distance,
/// pairs that are known to be apart are not looked at, which is many times as fast as asking each
/// (docs/benchmarks.md). What pairs remember of the frames before makes the next one faster and never weakens
/// a bound. One thread at a time; no allocation after construction but for growing lists.
class PairSet {
 public:
  /// Two bodies.
  struct Bodies {
    std::size_t a;  ///< number of A
    std::size_t b;  ///< number of B
  };
  /// A pair whose margins overlap. World frame, SI, as in PairResult.
  struct Contact {
    std::size_t pair;                                   ///< number of the pair
    double depth;                                       ///< m, deepest penetration of the margins
    Eigen::Vector3d force_a{Eigen::Vector3d::Zero()};   ///< N, on A; zero between the shell points
    Eigen::Vector3d torque_a{Eigen::Vector3d::Zero()};  ///< N m, on A about A's centre of mass
    Eigen::Vector3d torque_b{Eigen::Vector3d::Zero()};  ///< N m, on B about B's centre of mass
    int contacts{0};                                    ///< shell points within the margin
  };
  /// The pair with the smallest signed distance.
  struct Nearest {
    std::size_t pair{0};  ///< number of the pair
    PairResult result;    ///< all that is known of it
  };

  /// Throws std::runtime_error without a pair, and for a number beyond the bodies.
  PairSet(std::vector<Structure> bodies, const std::vector<Bodies>& pairs);
  ~PairSet();
  /// The one that was moved from can only be assigned to.
  PairSet(PairSet&& other) noexcept;
  PairSet& operator=(PairSet&& other) noexcept;  ///< likewise

  std::size_t size() const;  ///< pairs

  /// Everything about every pair: results[i] belongs to pair i. `X_WB`: a pose for each body. Throws as
  /// queryPair(), and for sizes that do not fit.
  void distances(std::span<const Pose> X_WB, const QueryOptions& options, std::span<PairResult> results);
  /// Pairs whose margins overlap, in order; valid until the next call. Throws likewise.
  std::span<const Contact> contacts(std::span<const Pose> X_WB, const QueryOptions& options = {});
  /// The nearest pair of all; of several with the same distance, the one of the last call comes first. Throws
  /// likewise.
  Nearest nearest(std::span<const Pose> X_WB, const QueryOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
