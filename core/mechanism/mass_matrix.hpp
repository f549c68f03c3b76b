// Mass matrix of a mechanism and its Cholesky factor.
#pragma once

#include "core/mechanism/rigid_tree.hpp"

namespace abstand::mechanism {

/// M(q) of kinetic energy = qd^T M qd / 2. Scratch, one per thread.
struct MassMatrix {
  Eigen::MatrixXd M;  ///< dof x dof, symmetric; kg m^2, kg or kg m by the units of the two dofs
  Eigen::MatrixXd L;  ///< lower triangle from factor(): M = L L^T
};

/// Composite rigid body algorithm [Walker, Orin 1982; Featherstone 2008, 6.2], for the q of the last
/// placeBodies() or inverseDynamics() with this state. Mimic joints are projected onto their dof. No
/// allocation after the first call with the same mass matrix.
void massMatrix(const RigidTree& tree, TreeState& state, MassMatrix& mass);

/// Cholesky factorisation. Returns -1, or the first dof that moves no mass (no inertia is left when the dofs
/// before it move freely); then L must not be used.
int factor(MassMatrix& mass);

/// Mobility b^T M^-1 b = |L^-1 b|^2 of a row b = J^T n of joint efforts; b becomes L^-1 b. After factor().
double mobilityOf(const MassMatrix& mass, std::span<double> b);

/// Replaces b by M^-1 b. After factor().
void solveMass(const MassMatrix& mass, std::span<double> b);

}  // namespace abstand::mechanism
