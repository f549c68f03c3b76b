// Composite rigid body algorithm and Cholesky factorisation.
#include "core/mechanism/mass_matrix.hpp"

#include <cmath>

#include "core/base/error.hpp"

namespace abstand::mechanism {
namespace {

// Rounding error of a pivot of a dof without mass, relative to its diagonal entry: about 1e-16 times the
// number of dofs. Real mass ratios (a hand, a wheeled base) stay above 1e-8.
constexpr double kNoMass = 1e-13;

/// Composite inertia of every body with all bodies that it carries.
void weld(const RigidTree& tree, TreeState& state) {
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const TreeBody& b = tree.bodies[i];
    TreeBodyState& s = state.bodies[i];
    s.mass = b.mass;
    s.first_moment = b.mass * s.com_B;
    s.inertia_origin = s.R_B * b.inertia * s.R_B.transpose();
    s.inertia_origin.diagonal().array() += s.com_B.dot(s.first_moment);
    s.inertia_origin -= s.com_B * s.first_moment.transpose();
  }
  for (std::size_t i = tree.bodies.size(); i-- > 0;) {
    const TreeBodyState& s = state.bodies[i];
    if (tree.bodies[i].parent < 0) continue;
    TreeBodyState& p = state.bodies[static_cast<std::size_t>(tree.bodies[i].parent)];
    // About the parent's origin, each point is at arm + x: (arm + x)^2 and (arm + x)(arm + x)^T, summed over
    // mass.
    const Vector3d moved = s.first_moment + s.mass * s.arm_B;
    p.mass += s.mass;
    p.first_moment += moved;
    p.inertia_origin += s.inertia_origin;
    p.inertia_origin.diagonal().array() += s.arm_B.dot(moved) + s.arm_B.dot(s.first_moment);
    p.inertia_origin -= s.arm_B * moved.transpose() + s.first_moment * s.arm_B.transpose();
  }
}

}  // namespace

void massMatrix(const RigidTree& tree, TreeState& state, MassMatrix& mass) {
  ABSTAND_CHECK(state.bodies.size() == tree.bodies.size());
  mass.M.setZero(tree.dof, tree.dof);
  weld(tree, state);
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const TreeBody& b = tree.bodies[i];
    const TreeBodyState& s = state.bodies[i];
    // Wrench for unit acceleration of joint i's dof, and its effort at each joint below.
    Vector3d force, moment;
    if (b.prismatic) {
      force = s.mass * s.axis_B;
      moment = s.first_moment.cross(s.axis_B);
    } else {
      force = s.axis_B.cross(s.first_moment);
      moment = s.inertia_origin * s.axis_B;
    }
    mass.M(b.dof, b.dof) += s.axis_B.dot(b.prismatic ? force : moment);
    moment += s.arm_B.cross(force);
    for (int j = b.parent; j >= 0; j = tree.bodies[static_cast<std::size_t>(j)].parent) {
      const TreeBody& c = tree.bodies[static_cast<std::size_t>(j)];
      const TreeBodyState& below = state.bodies[static_cast<std::size_t>(j)];
      const double coupling = below.axis_B.dot(c.prismatic ? force : moment);
      mass.M(b.dof, c.dof) += coupling;
      mass.M(c.dof, b.dof) += coupling;
      moment += below.arm_B.cross(force);
    }
  }
}

int factor(MassMatrix& mass) {
  const Eigen::Index n = mass.M.rows();
  auto& L = mass.L;
  L = mass.M;
  for (Eigen::Index j = 0; j < n; ++j) {
    double pivot = L(j, j);
    for (Eigen::Index k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k);
    if (!(pivot > kNoMass * mass.M(j, j))) return static_cast<int>(j);
    L(j, j) = std::sqrt(pivot);
    const double scale = 1.0 / L(j, j);
    if (j + 1 == n) break;
    auto below = L.col(j).tail(n - j - 1);
    if (j > 0) below.noalias() -= L.block(j + 1, 0, n - j - 1, j) * L.row(j).head(j).transpose();
    below *= scale;
  }
  return -1;
}

double mobilityOf(const MassMatrix& mass, std::span<double> b) {
  ABSTAND_CHECK(static_cast<Eigen::Index>(b.size()) == mass.L.rows());
  double sum = 0.0;
  for (Eigen::Index i = 0; i < mass.L.rows(); ++i) {
    double x = b[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < i; ++k) x -= mass.L(i, k) * b[static_cast<std::size_t>(k)];
    x /= mass.L(i, i);
    b[static_cast<std::size_t>(i)] = x;
    sum += x * x;
  }
  return sum;
}

void solveMass(const MassMatrix& mass, std::span<double> b) {
  const Eigen::Index n = mass.L.rows();
  ABSTAND_CHECK(static_cast<Eigen::Index>(b.size()) == n);
  const auto at = [&](Eigen::Index i) -> double& { return b[static_cast<std::size_t>(i)]; };
  for (Eigen::Index i = 0; i < n; ++i) {
    at(i) /= mass.L(i, i);
    for (Eigen::Index k = i + 1; k < n; ++k) at(k) -= mass.L(k, i) * at(i);
  }
  for (Eigen::Index i = n; i-- > 0;) {
    for (Eigen::Index k = i + 1; k < n; ++k) at(i) -= mass.L(k, i) * at(k);
    at(i) /= mass.L(i, i);
  }
}

}  // namespace abstand::mechanism
