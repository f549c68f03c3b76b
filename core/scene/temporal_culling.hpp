// Temporal culling: what the last query of a pair still proves after motion of its bodies.
#pragma once

#include <cstdint>

#include "core/query/pair_query.hpp"
#include "core/scene/motion_bound.hpp"
#include "core/scene/query_culling.hpp"

namespace abstand::scene {

/// Outcome of a pair in the step that last updated it.
enum class PairOutcome : std::uint8_t {
  kChecked,        ///< queried at the current poses
  kCulled,         ///< culled: motion since the query is within the allowed share
  kBeyondHorizon,  ///< culled: farther apart than the horizon
  kDeferred,       ///< deferred: the time budget was used up
};

/// A queried result that can be carried to other poses.
struct PairProof {
  double lower{kNaN};  ///< m, lower bound of the true distance at the query; NaN: nothing proven yet
  Vector3d p_Aa{Vector3d::Zero()}, p_Bb{Vector3d::Zero()};  ///< witness points, each in its body's frame
  bool apart{false};                                        ///< distance > 0

  void update(const query::PairResult& result, const Transform& X_WA, const Transform& X_WB);
  /// Carries the result to new poses with the proven lower bound `lower_now` (m): the witness points move
  /// with their bodies, so `distance` stays that of two surface points, never below the true one, and
  /// distance - bound = lower_now. A result with distance <= 0 keeps its distance, witness points and forces.
  /// No allocation.
  void carry(const Transform& X_WA, const Transform& X_WB, double lower_now, query::PairResult& result) const;
};

/// Motion (m) after which a pair must be queried again: a share of its clearance beyond `contact_distance`;
/// negative if it may not be culled.
double allowanceOf(const PairProof& proof, const query::PairResult& result, double contact_distance,
                   double share);
/// m: pairs certified to be farther apart have no contacts; includes the error of the fields, which may
/// report one earlier.
double contactDistance(const structure::HapticStructure& a, const structure::HapticStructure& b,
                       const query::PairOptions& options);

/// Decides which queries are skipped in lock-step mode, by the motion bounds of the bodies
/// (motion_bound.hpp).
class TemporalCulling {
 public:
  /// Discards the proof: the pair must be queried.
  void invalidate() { proof_.lower = kNaN; }
  /// Motion bound and pose of a body at the query.
  struct Moved {
    const Transform& X_WB;
    const MotionBound& bound;
  };
  /// Stores the result of a query. `contact_distance` (m): pairs certified to be farther apart have no
  /// contacts.
  void update(const query::PairResult& result, const Moved& a, const Moved& b, double contact_distance,
              const QueryCulling& culling);
  /// Whether the query may be skipped at the current poses, and why; kChecked: it may not.
  PairOutcome outcome(const MotionBound& a, const MotionBound& b, const QueryCulling& culling) const;
  /// Proven lower bound (m) at the current poses.
  double lowerNow(const MotionBound& a, const MotionBound& b) const;
  const PairProof& proof() const { return proof_; }
  bool proven() const { return proof_.lower > -kInfinity; }  ///< false for NaN
  double contactDistance() const { return contact_distance_; }

 private:
  /// Upper bound (m) on the decrease of the distance since the query.
  double movement(const MotionBound& a, const MotionBound& b) const;

  PairProof proof_;
  double travelled_a_{0.0}, travelled_b_{0.0};  ///< accumulated motion bounds of the bodies at the query
  double allowance_{-1.0};                      ///< m of motion; negative: none
  double contact_distance_{0.0};
  bool touches_{false};
};

}  // namespace abstand::scene
