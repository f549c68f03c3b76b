// Forces that keep velocities, within bounds.
#pragma once

#include <vector>

#include "core/math/transform.hpp"

namespace abstand::physics {

/// A linear complementarity problem with bounds: w = A x - b, lower <= x <= upper, and for every i w_i = 0,
/// or x_i = lower_i and w_i >= 0, or x_i = upper_i and w_i <= 0. For a symmetric positive definite A there is
/// exactly one solution. Scratch too; sizes may only shrink without allocation.
struct BoxLcp {
  Eigen::MatrixXd A;
  Eigen::VectorXd b, lower, upper, x;
  std::vector<int> side;  ///< -1 at the lower bound, 0 between, 1 at the upper
  std::vector<Eigen::Index> free;
  Eigen::MatrixXd L;
  Eigen::VectorXd y;

  void reserve(Eigen::Index most);
};

/// Solves the first `n` rows by principal pivoting: all wrong rows at once, and after some rounds the first
/// one alone, which ends for certain [Judice, Pires 1994, A block principal pivoting algorithm for
/// large-scale strictly monotone LCPs]. Gives false when it did not end within 50 rounds and 20 more per row
/// (A is hardly definite); `x` is then within its bounds. No allocation when reserved.
bool solveBoxLcp(BoxLcp& problem, Eigen::Index n);

}  // namespace abstand::physics
