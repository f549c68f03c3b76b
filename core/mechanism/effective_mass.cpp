#include "core/mechanism/effective_mass.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand {

double mobility(const RigidTree& tree, const TreeState& state, const MassMatrix& mass, int body,
                const Vector3d& p_B, const Wrench& w, std::span<double> work) {
  ABSTAND_CHECK(mass.L.rows() == tree.dof);
  std::fill(work.begin(), work.end(), 0.0);
  addBodyEfforts(tree, state, body, p_B, w, work);
  // x = L^-1 J^T w; then w^T J M^-1 J^T w is x^T x.
  double sum = 0.0;
  for (Eigen::Index i = 0; i < mass.L.rows(); ++i) {
    double x = work[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < i; ++k) x -= mass.L(i, k) * work[static_cast<std::size_t>(k)];
    x /= mass.L(i, i);
    work[static_cast<std::size_t>(i)] = x;
    sum += x * x;
  }
  return sum;
}

double effectiveMass(const RigidTree& tree, const TreeState& state, const MassMatrix& mass, int frame,
                     const Vector3d& p_B, const Vector3d& n_B, std::span<double> work) {
  ABSTAND_CHECK(frame >= 0 && static_cast<std::size_t>(frame) < tree.frames.size());
  const int body = tree.frames[static_cast<std::size_t>(frame)].body;
  return 1.0 / mobility(tree, state, mass, body, p_B, {n_B, Vector3d::Zero()}, work);
}

}  // namespace abstand
