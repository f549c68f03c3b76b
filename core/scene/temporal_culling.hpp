// What the last query of a pair still proves after its bodies have moved.
#pragma once

#include <cstdint>

#include "core/query/pair_query.hpp"
#include "core/scene/motion_bound.hpp"
#include "core/scene/query_culling.hpp"

namespace abstand::scene {

/// How a pair came to its result in the step that renewed it last.
enum class PairOutcome : std::uint8_t {
  kChecked,  ///< queried at the present poses
  kRested,   ///< its bodies have hardly moved since it was queried
  kBeyond,   ///< farther apart than the horizon
  kPutOff,   ///< ought to have been queried, but the time was up
};

/// A queried result that can be carried on to other poses.
struct PairProof {
  double lower{kNaN};  ///< m, the true distance was not below it; NaN: nothing proven yet
  Vector3d p_Aa{Vector3d::Zero()}, p_Bb{Vector3d::Zero()};  ///< the witnesses, each on its body
  bool apart{false};                                        ///< distance > 0

  void take(const query::PairResult& result, const Transform& X_WA, const Transform& X_WB);
  /// Brings the result to new poses of which only `lower_now` is proven: the witnesses go with their bodies,
  /// so that `distance` stays that of two points of the surfaces, never below the true one, and distance -
  /// bound is lower_now. A result that was not apart keeps its distance, witnesses and forces. No allocation.
  void carry(const Transform& X_WA, const Transform& X_WB, double lower_now, query::PairResult& result) const;
};

/// m of movement after which a pair has to be queried again: a share of its clearance beyond `touch_from`;
/// negative when it may not rest.
double allowanceOf(const PairProof& proof, const query::PairResult& result, double touch_from, double share);
/// m: what is certified to be farther apart has no contacts; fields may see one earlier, by their error.
double touchFrom(const structure::HapticStructure& a, const structure::HapticStructure& b,
                 const query::PairOptions& options);

/// Decides when a pair rests in lock step, by how far its bodies have really come (motion_bound.hpp).
class TemporalCulling {
 public:
  /// Nothing is proven any more: the pair has to be queried.
  void forget() { proof_.lower = kNaN; }
  /// A body of the pair at the query.
  struct Moved {
    const Transform& X_WB;
    const MotionBound& bound;
  };
  /// After a query. `touch_from` (m): what is certified to be farther apart has no contacts.
  void take(const query::PairResult& result, const Moved& a, const Moved& b, double touch_from,
            const QueryCulling& culling);
  /// Whether the pair may do without a query at the present poses, and why; kChecked: it may not.
  PairOutcome outcome(const MotionBound& a, const MotionBound& b, const QueryCulling& culling) const;
  /// m: what is proven at the present poses.
  double lowerNow(const MotionBound& a, const MotionBound& b) const;
  const PairProof& proof() const { return proof_; }
  bool proven() const { return proof_.lower > -kInfinity; }  ///< false for NaN
  double touchFrom() const { return touch_from_; }

 private:
  /// m: bound on what the distance can have lost since the query.
  double movement(const MotionBound& a, const MotionBound& b) const;

  PairProof proof_;
  double way_a_{0.0}, way_b_{0.0};  ///< of the bodies at the query
  double allowance_{-1.0};          ///< m of movement, below 0: none
  double touch_from_{0.0};
  bool touches_{false};
};

}  // namespace abstand::scene
