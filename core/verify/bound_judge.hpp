// Compares one result of the engine with the true distance.
#pragma once

#include "core/query/pair_query.hpp"
#include "core/verify/exact_pair.hpp"

namespace abstand::verify {

struct BoundAnswer {
  double used{kNaN};   ///< (distance - true) / bound
  double below{kNaN};  ///< (true - distance) / size of the pair
  double error{kNaN};  ///< |distance - true| in voxels; NaN if the true distance is not enclosed
  bool breach{false};  ///< the true distance is below distance - bound, or a value is NaN
};

/// Computes the true distance of two bodies in their poses.
class BoundJudge {
 public:
  BoundJudge(const AdversarialBody& a, const Transform& X_WA, const AdversarialBody& b,
             const Transform& X_WB);

  const ExactDistance& exact() const { return exact_; }
  BoundAnswer operator()(const query::PairResult& result) const;

 private:
  double voxel_;     ///< m, the larger of the two voxels
  double size_;      ///< m
  double rounding_;  ///< m, rounding error of the brute force
  ExactDistance exact_;
};

}  // namespace abstand::verify
