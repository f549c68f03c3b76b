// Distance, contact and penalty force of two bodies.
#pragma once

#include "core/kernels/pair_scratch.hpp"
#include "core/query/placed_body.hpp"

namespace abstand::query {

/// kVolume: f_i = k a_i depth_i n_i, k in N/m^3; the force of a body pressed into a wall is k times the
/// overlapping volume for any sampling. kThesis: f_i = k_t V_i n_i [thesis eq. 2.2], unweighted, k_t in N/m.
enum class ForceLaw { kVolume, kThesis };

/// m; the tolerance of smaller distances is 1e-5 m, that of larger ones is relative.
inline constexpr double kRelativeFrom = 0.1;
/// Default of PairOptions::far_share: within one percent of the smallest distance.
inline constexpr double kColdFarShare = 0.0099;
/// Largest tolerance of distances beyond kRelativeFrom with a warm start, and its default: shares of the
/// smallest distance.
inline constexpr double kMaxFarTolerance = 0.1, kFarTolerance = 0.002;
/// A tolerance as a share of the reported distance, for PairOptions::far_share.
constexpr double farShareOf(double far_tolerance) { return far_tolerance / (1.0 + far_tolerance); }

struct PairOptions {
  double margin{0.0};       ///< m, sum of both objects' safety margins
  double stiffness{1.0e6};  ///< N/m^3 (kVolume) or N/m (kThesis)
  ForceLaw law{ForceLaw::kVolume};
  /// Relative tolerance of distances beyond kRelativeFrom: excess over the smallest distance of the shell
  /// points.
  double far_share{kColdFarShare};
};

/// Result of one pair A, B in one cycle. World frame, SI. Distances are between the bare surfaces, without
/// margins: positive apart, negative inside (minus the deepest penetration). f_b = -f_a always; T_b = -T_a -
/// (p_a - p_b) x f_a with p_a, p_b the centres of mass, so that the sum about any point is zero.
struct PairResult {
  double distance{kNaN};                         ///< m, signed
  double bound{kNaN};                            ///< m; the true distance is never below distance - bound
  Vector3d witness_a{Vector3d::Constant(kNaN)};  ///< nearest point on A (deepest, if inside)
  Vector3d witness_b{Vector3d::Constant(kNaN)};  ///< nearest point on B
  Vector3d force_a{Vector3d::Zero()};            ///< N, penalty force on A; on B the opposite
  Vector3d torque_a{Vector3d::Zero()};           ///< N m, on A about A's centre of mass
  Vector3d torque_b{Vector3d::Zero()};           ///< N m, on B about B's centre of mass
  int contacts{0};                               ///< shell points within the margin
  double depth{0.0};                             ///< m, deepest penetration of the margins, >= 0
};

/// Separating axes of parts of the two bodies (unit vectors in the axes of the field's body); zero: unused.
struct PartAxes {
  static constexpr std::size_t kMax = 2;
  Vector3d n[kMax]{Vector3d::Zero(), Vector3d::Zero()};
  std::size_t next{0};  ///< index of the next entry to replace
};

/// Witness and search data of a pair's last query, for a warm start.
struct PairCache {
  bool apart{false};                ///< the bodies were apart in the last query; otherwise all other members
                                    ///< are invalid
  Vector3d on_a{Vector3d::Zero()};  ///< witness points, each in the frame of its own body
  Vector3d on_b{Vector3d::Zero()};
  double distance{0.0};  ///< m
  std::uint32_t hint_a{geometry::kNoHint},
      hint_b{geometry::kNoHint};  ///< locations of the witness points on the surfaces
  bool hulls{false};              ///< the last distance was at most 3 % above the separation of the convex
                                  ///< hulls
  bool by_parts{false};           ///< the hulls of the parts proved the last distance
  bool touching{false};           ///< the last query computed forces
  std::uint32_t hull_test_cooldown{0};  ///< queries to skip before the local refinement with its hull test is
                                        ///< retried
  Vector3d n_a{Vector3d::Zero()};  ///< unit vector from B to A between the witness points, in each body's
                                   ///< axes
  Vector3d n_b{Vector3d::Zero()};
  Transform X_FP{Transform::Identity()};  ///< pose of one body in the other at the last full search ...
  double searched{-kInfinity};            ///< ... the lower bound (m) that it proved for all shell points ...
  double found{-kInfinity};               ///< ... the distance (m) that it found ...
  double runner_up_distance{
      -kInfinity};  ///< ... and the lower bound (m) for the shell points away from `witness_on_points`
  PartAxes part_axes;
  Vector3d witness_on_points{
      Vector3d::Zero()};  ///< witness point on the body that gave the points, in that body's frame
};

/// State of a pair between cycles, for warm starts of queries of the same two structures. It never weakens
/// the bound. Default-constructed: cold start.
struct PairMemory {
  PairCache last;
  /// The cache before the last jump of a body. A tracker that alternates between two explanations of an image
  /// (an elbow flipped, left and right exchanged) jumps back soon.
  PairCache before_jump;
};

/// State of a warm query: the pair's memory and the thread's work space.
struct QueryContext {
  PairMemory& memory;
  kernels::PairScratch& scratch;
};

/// True if A gives the points and B the field. The body with the smaller bounding sphere gives the points, A
/// if they are equal, so that a small body pressed into a large one is integrated over its own surface.
bool pointsFromA(const structure::HapticStructure& a, const structure::HapticStructure& b);

/// Distance, contact and penalty force of two bodies. Both structures must outlive the call. No allocation,
/// no lock, no throw. The result depends only on the arguments' values (on earlier calls only through
/// `memory`), never on the thread.
///
/// Cold start: branch and bound over the point-sphere tree of one body in the field of the other, with
/// certified lower bounds f of the true distance (field_lanes.hpp). Every shell point is at least best_f
/// away, every surface point at least best_f - covering radius. The best point is then refined on the exact
/// surfaces (witness.hpp). If the bodies may touch, the other body's points are searched too. Inside, the
/// depth is that of the deepest surface point found of either body in the other.
///
/// Warm start: the last witness points, moved with the bodies, are accepted if a slab across them that
/// separates the hulls (separation.hpp), or the last search's bound less the motion since, proves their
/// distance. Otherwise they are refined locally, accepted if no runner-up can be as near, or replaced by the
/// support points along the last witness line if a body has rotated. If nothing is proven, the search
/// follows.
///
/// With a memory, distances beyond kRelativeFrom may exceed the smallest distance of the shell points by the
/// share options.far_share, as far as the field distinguishes them; `bound` states the excess in each case.
void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               const QueryContext& context, PairResult& result) noexcept;
/// Cold query, without a memory.
void queryPair(const PlacedBody& a, const PlacedBody& b, const PairOptions& options,
               kernels::PairScratch& scratch, PairResult& result) noexcept;

}  // namespace abstand::query
