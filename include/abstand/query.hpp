// Distance and contact of two bodies.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "abstand/structure.hpp"

namespace abstand {

/// What a query is asked for.
struct QueryOptions {
  /// kVolume: f_i = k a_i depth_i n_i, so that pressing a body into a flat wall gives k times the overlapping
  /// volume. kThesis: f_i = k V_i n_i (thesis eq. 2.2), unweighted.
  enum class Law { kVolume, kThesis };

  double margin{0.0};       ///< m, 0 or more: contacts begin at this distance
  double stiffness{1.0e6};  ///< k, N/m^3 (kVolume) or N/m (kThesis), 0 or more
  Law law{Law::kVolume};    ///< of the forces
};

/// What is known of a pair A, B. World frame, SI.
struct PairResult {
  /// m, between the bare surfaces without margins: positive apart, negative inside (then less the deepest
  /// penetration).
  double distance{std::numeric_limits<double>::quiet_NaN()};
  /// m: the true distance is never below distance - bound.
  double bound{std::numeric_limits<double>::quiet_NaN()};
  Eigen::Vector3d witness_a{Eigen::Vector3d::Zero()};  ///< m, nearest point on A; the deepest one inside
  Eigen::Vector3d witness_b{Eigen::Vector3d::Zero()};  ///< m, nearest point on B
  Eigen::Vector3d force_a{Eigen::Vector3d::Zero()};    ///< N, on A; the opposite acts on B
  Eigen::Vector3d torque_a{Eigen::Vector3d::Zero()};   ///< N m, on A about A's centre of mass
  Eigen::Vector3d torque_b{Eigen::Vector3d::Zero()};   ///< N m, on B about B's centre of mass
  int contacts{0};                                     ///< shell points within the margin
  double depth{0.0};                                   ///< m, deepest penetration of the margins, >= 0
};

/// What a pair remembers from one query to the next, which makes the next one faster and never weakens its
/// bound. For one pair of structures, and one thread at a time; a new one remembers nothing. Beyond 0.1 m the
/// distance may then exceed the smallest one by 1 %; `bound` says by how much in each case.
class PairState {
 public:
  PairState();
  ~PairState();
  /// The one that was moved from can only be assigned to.
  PairState(PairState&& other) noexcept;
  PairState& operator=(PairState&& other) noexcept;  ///< likewise
  /// Forgets everything. For another pair, and for results that depend on nothing before.
  void reset() noexcept;

  /// @cond library
  struct Impl;
  Impl& impl() { return *impl_; }
  /// @endcond

 private:
  std::unique_ptr<Impl> impl_;
};

/// Asks one pair. The result depends on the arguments alone, never on the thread. Any thread. Throws
/// std::runtime_error for a pose that is not finite or no rotation (within 1e-6), and for bad options.
PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options = {});
/// The same with a warm start; the result depends on the calls before through `state` alone. No allocation.
PairResult queryPair(const Structure& a, const Pose& X_WA, const Structure& b, const Pose& X_WB,
                     const QueryOptions& options, PairState& state);

/// How a batch goes about.
struct BatchOptions {
  QueryOptions query{};
  int threads{1};  ///< 0: all cores. The bits do not depend on it.
  /// The poses follow each other like the frames of a motion: warm starts within blocks of kBatchBlock poses.
  bool sequence{false};
};
/// Poses of a block; the first one of each is asked without a memory.
inline constexpr std::size_t kBatchBlock = 128;

/// Asks one pair in many poses: results[i] belongs to the i-th poses. One of X_WA and X_WB may hold a single
/// pose, which then stands for all. Without `sequence` the bits are those of queryPair() without a state. Any
/// thread; no allocation with one thread. Throws as queryPair(), before anything is asked, and for sizes that
/// do not fit.
void queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                std::span<const Pose> X_WB, const BatchOptions& options, std::span<PairResult> results);
/// The same into a new array of max(X_WA.size(), X_WB.size()) results.
std::vector<PairResult> queryPoses(const Structure& a, std::span<const Pose> X_WA, const Structure& b,
                                   std::span<const Pose> X_WB, const BatchOptions& options = {});

}  // namespace abstand
