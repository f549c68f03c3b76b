#include "core/scene/temporal_culling.hpp"

#include <algorithm>

namespace abstand::scene {
namespace {

// Exceeds the rounding of differences and sums of two lengths.
constexpr double kRoundUp = 1.0 + 1e-12;

}  // namespace

void PairProof::update(const query::PairResult& result, const Transform& X_WA, const Transform& X_WB) {
  lower = result.distance - result.bound;
  apart = result.distance > 0.0;
  p_Aa = X_WA.inverse() * result.witness_a;
  p_Bb = X_WB.inverse() * result.witness_b;
}

void PairProof::carry(const Transform& X_WA, const Transform& X_WB, double lower_now,
                      query::PairResult& result) const {
  if (apart) {
    result.witness_a = X_WA * p_Aa;
    result.witness_b = X_WB * p_Bb;
    result.distance = (result.witness_a - result.witness_b).norm();
  }
  result.bound = std::max(0.0, result.distance - lower_now);
}

double allowanceOf(const PairProof& proof, const query::PairResult& result, double contact_distance,
                   double share) {
  const double clearance = proof.lower - contact_distance;
  return share > 0.0 && clearance > 0.0 && result.contacts == 0 ? share * clearance : -1.0;
}

double contactDistance(const structure::HapticStructure& a, const structure::HapticStructure& b,
                       const query::PairOptions& options) {
  return options.margin + std::max(a.errorBound(), b.errorBound());
}

void TemporalCulling::update(const query::PairResult& result, const Moved& a, const Moved& b,
                             double contact_distance, const QueryCulling& culling) {
  proof_.update(result, a.X_WB, b.X_WB);
  travelled_a_ = a.bound.travelled();
  travelled_b_ = b.bound.travelled();
  contact_distance_ = contact_distance;
  touches_ = result.contacts > 0;
  allowance_ = allowanceOf(proof_, result, contact_distance, culling.rest);
}

double TemporalCulling::movement(const MotionBound& a, const MotionBound& b) const {
  return ((a.travelled() - travelled_a_) + (b.travelled() - travelled_b_)) * kRoundUp;
}

PairOutcome TemporalCulling::outcome(const MotionBound& a, const MotionBound& b,
                                     const QueryCulling& culling) const {
  if (!proven()) return PairOutcome::kChecked;
  if (movement(a, b) <= allowance_) return PairOutcome::kCulled;
  if (!touches_ && proof_.apart && gapOf(a, b) > std::max(culling.horizon, contact_distance_))
    return PairOutcome::kBeyondHorizon;
  return PairOutcome::kChecked;
}

double TemporalCulling::lowerNow(const MotionBound& a, const MotionBound& b) const {
  return std::max(proof_.lower - movement(a, b), gapOf(a, b));
}

}  // namespace abstand::scene
