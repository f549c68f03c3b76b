// Distance, contact and penalty force of two bodies.
#pragma once

#include "core/kernels/pair_scratch.hpp"
#include "core/query/placed_body.hpp"

namespace abstand::query {

/// kVolume: f_i = k a_i depth_i n_i, k in N/m^3, so pressing a body into a wall gives k times the overlapping
/// volume whatever the sampling. kThesis: f_i = k_t V_i n_i [thesis eq. 2.2], unweighted, k_t in N/m.
enum class ForceLaw { kVolume, kThesis };

/// m; nearer, the distance is that of the nearest points within 1e-5 m, farther away within a share of it.
inline constexpr double kRelativeFrom = 0.1;
/// PairOptions::far_share unless something else is asked for: within a hundredth of the smallest.
inline constexpr double kColdFarShare = 0.0099;

struct PairOptions {
  double margin{0.0};       ///< m, sum of both objects' safety margins
  double stiffness{1.0e6};  ///< N/m^3 (kVolume) or N/m (kThesis)
  ForceLaw law{ForceLaw::kVolume};
  /// Of an answer beyond kRelativeFrom: by so much it may exceed the smallest distance of the shell's points.
  double far_share{kColdFarShare};
};

/// Result of one pair A, B in one cycle. World frame, SI. Distances are between the bare surfaces, without
/// margins: positive apart, negative inside (then minus the deepest penetration). f_b = -f_a always;
/// T_b = -T_a - (p_a - p_b) x f_a with p_a, p_b the centres of mass, so that the sum about any point is zero.
struct PairResult {
  double distance{kNaN};                         ///< m, signed
  double bound{kNaN};                            ///< m; the true distance is never below distance - bound
  Vector3d witness_a{Vector3d::Constant(kNaN)};  ///< nearest point on A (deepest, when inside)
  Vector3d witness_b{Vector3d::Constant(kNaN)};  ///< nearest point on B
  Vector3d force_a{Vector3d::Zero()};            ///< N, penalty force on A; on B the opposite
  Vector3d torque_a{Vector3d::Zero()};           ///< N m, on A about A's centre of mass
  Vector3d torque_b{Vector3d::Zero()};           ///< N m, on B about B's centre of mass
  int contacts{0};                               ///< shell points within the margin
  double depth{0.0};                             ///< m, deepest penetration of the margins, >= 0
};

/// Lines along which parts of the two bodies were apart (unit vectors in the axes of the field's body); zero:
/// none.
struct PartAxes {
  static constexpr std::size_t kMax = 2;
  Vector3d n[kMax]{Vector3d::Zero(), Vector3d::Zero()};
  std::size_t next{0};  ///< to be replaced
};

/// What a pair knew after a query: where its nearest points were, and how near the bodies could be at most.
struct PairCache {
  bool apart{false};                ///< in the last query; else nothing below holds
  Vector3d on_a{Vector3d::Zero()};  ///< the witnesses in the frames of their own bodies
  Vector3d on_b{Vector3d::Zero()};
  double distance{0.0};  ///< m
  std::uint32_t hint_a{geometry::kNoHint},
      hint_b{geometry::kNoHint};   ///< where on the surfaces the witnesses are
  bool hulls{false};               ///< the convex-hull test proved the last distance
  bool by_parts{false};            ///< it was proven by the hulls of the bodies' parts
  bool touching{false};            ///< forces were wanted
  std::uint32_t idle{0};           ///< queries to skip before the hull test is retried
  Vector3d n_a{Vector3d::Zero()};  ///< the unit vector from B to A between the witnesses, in each body's axes
  Vector3d n_b{Vector3d::Zero()};
  Transform X_FP{Transform::Identity()};  ///< pose of one body in the other at the last full search ...
  double searched{-kInfinity};  ///< ... the least distance (m) of any shell point that it proved ...
  double found{-kInfinity};     ///< ... the distance (m) that it found ...
  double runner_up_distance{
      -kInfinity};  ///< ... and the least (m) of the shell points that are not about `witness_on_points`
  PartAxes part_axes;
  Vector3d witness_on_points{
      Vector3d::Zero()};  ///< the witness on the body that gave the points, in its frame
};

/// What a pair remembers from one cycle to the next. It speeds up the next query of the same two structures
/// and never weakens its bound. A fresh one remembers nothing.
struct PairMemory {
  PairCache last;
  /// As it was when a body jumped last. A tracker that wavers between two explanations of what it sees (an
  /// elbow that turns over, left taken for right) jumps back soon.
  PairCache before_jump;
};

/// What a warm query works with: the pair's own memory, and work space of its thread.
struct QueryContext {
  PairMemory& memory;
  kernels::PairScratch& scratch;
};

/// True when A gives the points and B the field. The body with the smaller bounding sphere gives the points,
/// A on a tie, so that a small body pressed into a large one is integrated over its own surface.
bool pointsFromA(const structure::HapticStructure& a, const structure::HapticStructure& b);

/// Both structures must outlive the call. No allocation, no lock, no throw. The result depends only on the
/// arguments' values (so on earlier calls only through `memory`), never on the thread.
///
/// How: where the nearest points were, they may be still: the distance of these two points of the surfaces is
/// proven by a slab across it that parts the two hulls (separation.hpp), or by an earlier search less what
/// the bodies have moved since. They may have slid on, to be found from where they were, while no other
/// candidates are as near; or a body has turned about itself, and others are the outermost along the same
/// line. Else the point-sphere tree of one body is searched in the field of the other, branch and bound, with
/// certified lower bounds f of the true distance (field_lanes.hpp): every shell point is at least best_f
/// away, and every surface point at least best_f - covering radius. The best point is then moved along the
/// exact surfaces (witness.hpp). Where the bodies may touch, the other body's points are searched as well.
/// Inside, the depth is that of the deepest surface point that was found of either body in the other.
///
/// With a memory, distances beyond kRelativeFrom may exceed the smallest of the shell's points by
/// options.far_share of themselves, as far as the field there tells them apart; `bound` says by how much in
/// each case.
void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               const QueryContext& context, PairResult& result) noexcept;
/// A cold query: nothing is remembered.
void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               kernels::PairScratch& scratch, PairResult& result) noexcept;

}  // namespace abstand::query
