// Batch queries of a fixed set of pairs, frame by frame.
#pragma once

#include "abstand/query.hpp"

namespace abstand {

/// Batch queries of pairs that share bodies. contacts() and nearest() skip pairs that are known to be apart,
/// which is many times faster than querying each pair (docs/benchmarks.md). Warm starts from the previous
/// frames are faster and never weaken a bound. One thread at a time; no allocation after construction, except
/// for growing lists.
class PairSet {
 public:
  /// Two bodies.
  struct Bodies {
    std::size_t a;  ///< index of A
    std::size_t b;  ///< index of B
  };
  /// A pair whose margins overlap. World frame, SI, as in PairResult.
  struct Contact {
    std::size_t pair;                                   ///< index of the pair
    double depth;                                       ///< m, deepest penetration of the margins
    Eigen::Vector3d force_a{Eigen::Vector3d::Zero()};   ///< N, on A; zero between the shell points
    Eigen::Vector3d torque_a{Eigen::Vector3d::Zero()};  ///< N m, on A about A's centre of mass
    Eigen::Vector3d torque_b{Eigen::Vector3d::Zero()};  ///< N m, on B about B's centre of mass
    int contacts{0};                                    ///< shell points within the margin
  };
  /// The pair with the smallest signed distance.
  struct Nearest {
    std::size_t pair{0};  ///< index of the pair
    PairResult result;    ///< full result of the pair
  };

  /// Throws std::runtime_error if there is no pair, and for an index out of range.
  PairSet(std::vector<Structure> bodies, const std::vector<Bodies>& pairs);
  ~PairSet();
  /// A moved-from set can only be assigned to.
  PairSet(PairSet&& other) noexcept;
  PairSet& operator=(PairSet&& other) noexcept;  ///< likewise

  std::size_t size() const;  ///< number of pairs

  /// Full results of all pairs: results[i] belongs to pair i. `X_WB`: a pose for each body. Throws as
  /// queryPair(), and if the sizes do not match.
  void distances(std::span<const Pose> X_WB, const QueryOptions& options, std::span<PairResult> results);
  /// The pairs whose margins overlap, in order of index; valid until the next call. Throws likewise.
  std::span<const Contact> contacts(std::span<const Pose> X_WB, const QueryOptions& options = {});
  /// The pair with the smallest distance; if equal, the pair of the last call has priority. Throws likewise.
  Nearest nearest(std::span<const Pose> X_WB, const QueryOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
