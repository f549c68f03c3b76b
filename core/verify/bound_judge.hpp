// One answer of the engine against the true distance.
#pragma once

#include "core/query/pair_query.hpp"
#include "core/verify/exact_pair.hpp"

namespace abstand::verify {

struct BoundAnswer {
  double used{kNaN};   ///< (distance - true) / bound
  double below{kNaN};  ///< (true - distance) / size of the pair
  double error{kNaN};  ///< |distance - true| in voxels; NaN where the truth is not enclosed
  bool breach{false};  ///< the true distance is below distance - bound, or they are not numbers
};

/// Knows the true distance of two bodies as they lie.
class BoundJudge {
 public:
  BoundJudge(const AdversarialBody& a, const Transform& X_WA, const AdversarialBody& b,
             const Transform& X_WB);

  const ExactDistance& exact() const { return exact_; }
  BoundAnswer operator()(const query::PairResult& result) const;

 private:
  double voxel_;     ///< the larger of the two; m
  double size_;      ///< m
  double rounding_;  ///< m, of the brute force
  ExactDistance exact_;
};

}  // namespace abstand::verify
