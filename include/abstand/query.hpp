// Distance and contact of two bodies.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "abstand/structure.hpp"

namespace abstand {

/// Parameters of a query.
struct QueryOptions {
  /// kVolume: f_i = k a_i depth_i n_i, so that pressing a body into a flat wall gives k times the overlapping
  /// volume. kThesis: f_i = k V_i n_i (thesis eq. 2.2), unweighted.
  enum class Law { kVolume, kThesis };

  double margin{0.0};       ///< m, 0 or more: contacts begin at this distance
  double stiffness{1.0e6};  ///< k, N/m^3 (kVolume) or N/m (kThesis), 0 or more
  Law law{Law::kVolume};    ///< force law
  /// 0 to 0.1. With a warm start, a distance beyond 0.1 m may exceed the smallest one by this share; `bound`
  /// includes the excess. No effect on a cold start.
  double far_tolerance{0.002};
};

/// Result of a query of a pair A, B. World frame, SI.
struct PairResult {
  /// m, between the bare surfaces without margins: positive outside; inside, minus the deepest penetration.
  double distance{std::numeric_limits<double>::quiet_NaN()};
  /// m: the true distance is never below distance - bound.
  double bound{std::numeric_limits<double>::quiet_NaN()};
  Eigen::Vector3d witness_a{Eigen::Vector3d::Zero()};  ///< m, nearest point on A; inside, the deepest
  Eigen::Vector3d witness_b{Eigen::Vector3d::Zero()};  ///< m, nearest point on B
  Eigen::Vector3d force_a{Eigen::Vector3d::Zero()};    ///< N, on A; the opposite acts on B
  Eigen::Vector3d torque_a{Eigen::Vector3d::Zero()};   ///< N m, on A about A's centre of mass
  Eigen::Vector3d torque_b{Eigen::Vector3d::Zero()};   ///< N m, on B about B's centre of mass
  int contacts{0};                                     ///< shell points within the margin
  double depth{0.0};                                   ///< m, deepest penetration of the margins, >= 0
};

/// Data of a pair from one query to the next, for a warm start. A warm start is faster and never weakens the
/// bound; see QueryOptions::far_tolerance. For one pair of structures, and one thread at a time; a new state
/// gives a cold start.
class PairState {
 public:
  PairState();
  ~PairState();
  /// A moved-from state can only be assigned to.
  PairState(PairState&& other) noexcept;
  PairState& operator=(PairState&& other) noexcept;  ///< likewise
  /// Discards all data, for use with another pair or for a cold start.
  void reset() noexcept;

  /// @cond library
  struct Impl;
  Impl& impl() { return *impl_; }
  /// @endcond

 private:
  std::unique_ptr<Impl> impl_;
};

/// Queries one pair (cold start). The result depends only on the arguments, not on the thread. Any thread.
/// Throws std::runtime_error for a pose that is not finite or not a rotation (within 1e-6), and for invalid
/// options.
PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options = {});
/// The same with a warm start; earlier calls affect the result only through `state`. No allocation.
PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options, PairState& state);

/// Parameters of a batch.
struct BatchOptions {
  QueryOptions query{};  ///< parameters of each query
  int threads{1};        ///< 0: all cores; does not affect the bits
  /// The poses are consecutive frames of a motion: warm starts within blocks of kBatchBlock poses.
  bool sequence{false};
};
/// Number of poses in a block; the first one of each block is a cold start.
inline constexpr std::size_t kBatchBlock = 128;

/// Queries one pair in many poses: results[i] belongs to the i-th poses. X_WA or X_WB may hold a single pose,
/// which is then used for all. Without `sequence`, the bits are those of queryPair() without a state. Any
/// thread; no allocation with one thread. Throws as queryPair(), before the first query, and if the sizes do
/// not match.
void queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                std::span<const Pose> X_WB, const BatchOptions& options, std::span<PairResult> results);
/// The same, returning a new array of max(X_WA.size(), X_WB.size()) results.
std::vector<PairResult> queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                                   std::span<const Pose> X_WB, const BatchOptions& options = {});

}  // namespace abstand
