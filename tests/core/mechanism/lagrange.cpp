#include "tests/core/mechanism/lagrange.hpp"

#include <vector>

namespace abstand::testing {

Eigen::MatrixXd lagrangeMass(const mechanism::Mechanism& mechanism, std::span<const double> q) {
  mechanism::MechanismState state;
  mechanism::forward(mechanism, q, state);
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(mechanism.dof, mechanism.dof);
  Eigen::Matrix<double, 6, Eigen::Dynamic> J;
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    const mechanism::LinkInertia& body = mechanism.frames[i].inertia;
    mechanism::jacobian(mechanism, state, static_cast<int>(i), J);
    const Matrix3d R_BF = state.X_BF[i].linear();
    const Vector3d c_B = R_BF * body.com_F;
    const Eigen::MatrixXd angular = J.bottomRows<3>();
    Eigen::MatrixXd linear = J.topRows<3>();
    for (Eigen::Index k = 0; k < J.cols(); ++k) linear.col(k) += Vector3d(angular.col(k)).cross(c_B);
    M += body.mass * linear.transpose() * linear +
         angular.transpose() * (R_BF * body.inertia_F * R_BF.transpose()) * angular;
  }
  return M;
}

double lagrangePotential(const mechanism::Mechanism& mechanism, std::span<const double> q,
                         const Vector3d& gravity_B) {
  mechanism::MechanismState state;
  mechanism::forward(mechanism, q, state);
  double potential = 0.0;
  for (std::size_t i = 0; i < mechanism.frames.size(); ++i) {
    const mechanism::LinkInertia& body = mechanism.frames[i].inertia;
    potential -= body.mass * gravity_B.dot(state.X_BF[i] * body.com_F);
  }
  return potential;
}

Eigen::VectorXd lagrangeEfforts(const mechanism::Mechanism& mechanism, std::span<const double> q,
                                std::span<const double> qd, std::span<const double> qdd,
                                const Vector3d& gravity_B) {
  const Eigen::Index n = mechanism.dof;
  const Eigen::Map<const Eigen::VectorXd> rate(qd.data(), n), change(qdd.data(), n);
  Eigen::VectorXd efforts = lagrangeMass(mechanism, q) * change;
  std::vector<double> near(q.begin(), q.end());
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    near[at] = q[at] + kLagrangeStep;
    const Eigen::MatrixXd M_plus = lagrangeMass(mechanism, near);
    const double U_plus = lagrangePotential(mechanism, near, gravity_B);
    near[at] = q[at] - kLagrangeStep;
    const Eigen::MatrixXd M_minus = lagrangeMass(mechanism, near);
    const double U_minus = lagrangePotential(mechanism, near, gravity_B);
    near[at] = q[at];
    const Eigen::MatrixXd dM = (M_plus - M_minus) / (2.0 * kLagrangeStep);
    efforts += rate[k] * dM * rate;
    efforts[k] += -0.5 * rate.dot(dM * rate) + (U_plus - U_minus) / (2.0 * kLagrangeStep);
  }
  return efforts;
}

}  // namespace abstand::testing
