// The equations of motion by brute force: Lagrange's, with differences. Knows nothing of rigid_tree.hpp.
#pragma once

#include <span>

#include "core/mechanism/mechanism.hpp"

namespace abstand::testing {

/// M(q) as the sum of J^T diag(m, I) J over all frames, fixed ones too.
Eigen::MatrixXd lagrangeMass(const mechanism::Mechanism& mechanism, std::span<const double> q);

/// -sum of m g^T c over all frames that move. J.
double lagrangePotential(const mechanism::Mechanism& mechanism, std::span<const double> q,
                         const Vector3d& gravity_B);

/// M qdd + dM/dt qd - grad (qd^T M qd / 2 - U), gradients by central differences of step kLagrangeStep.
Eigen::VectorXd lagrangeEfforts(const mechanism::Mechanism& mechanism, std::span<const double> q,
                                std::span<const double> qd, std::span<const double> qdd,
                                const Vector3d& gravity_B);

inline constexpr double kLagrangeStep = 1e-5;

}  // namespace abstand::testing
