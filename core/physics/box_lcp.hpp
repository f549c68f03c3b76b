// Box-constrained linear complementarity problem (LCP).
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand::physics {

/// w = A x - b, lower <= x <= upper, and for every i either w_i = 0, or x_i = lower_i and w_i >= 0, or x_i =
/// upper_i and w_i <= 0. Unique solution for a symmetric positive definite A. Includes scratch memory;
/// shrinking the problem does not allocate.
struct BoxLcp {
  Eigen::MatrixXd A;
  Eigen::VectorXd b, lower, upper, x;
  std::vector<int> side;  ///< -1 at the lower bound, 0 between, 1 at the upper
  std::vector<Eigen::Index> free;
  Eigen::MatrixXd L;
  Eigen::VectorXd y;

  void reserve(Eigen::Index max_size);
};

/// Solves the first `n` rows by block principal pivoting, falling back to single pivots, which always
/// terminates [Judice, Pires 1994, A block principal pivoting algorithm for large-scale strictly monotone
/// LCPs]. False after 50 rounds and 20 more for each row (A is nearly singular); `x` is then within its
/// bounds. No allocation if reserved.
bool solveBoxLcp(BoxLcp& problem, Eigen::Index n);

}  // namespace abstand::physics
