#include "core/mechanism/effective_mass.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand {

double effectiveMass(const RigidTree& tree, const TreeState& state, const MassMatrix& mass, int frame,
                     const Vector3d& p_B, const Vector3d& n_B, std::span<double> work) {
  ABSTAND_CHECK(frame >= 0 && static_cast<std::size_t>(frame) < tree.frames.size());
  ABSTAND_CHECK(mass.L.rows() == tree.dof);
  std::fill(work.begin(), work.end(), 0.0);
  addBodyEfforts(tree, state, tree.frames[static_cast<std::size_t>(frame)].body, p_B, {n_B, Vector3d::Zero()},
                 work);
  // x = L^-1 J^T n; then n^T J M^-1 J^T n is x^T x.
  double mobility = 0.0;
  for (Eigen::Index i = 0; i < mass.L.rows(); ++i) {
    double x = work[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < i; ++k) x -= mass.L(i, k) * work[static_cast<std::size_t>(k)];
    x /= mass.L(i, i);
    work[static_cast<std::size_t>(i)] = x;
    mobility += x * x;
  }
  return 1.0 / mobility;
}

}  // namespace abstand
