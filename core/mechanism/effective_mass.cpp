#include "core/mechanism/effective_mass.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::mechanism {

double mobility(const RigidTree& tree, const TreeState& state, const MassMatrix& mass, int body,
                const Vector3d& p_B, const Wrench& w, std::span<double> work) {
  ABSTAND_CHECK(mass.L.rows() == tree.dof);
  std::fill(work.begin(), work.end(), 0.0);
  addBodyEfforts(tree, state, body, p_B, w, work);
  return mobilityOf(mass, work);
}

double effectiveMass(const RigidTree& tree, const TreeState& state, const MassMatrix& mass, int frame,
                     const Vector3d& p_B, const Vector3d& n_B, std::span<double> work) {
  ABSTAND_CHECK(frame >= 0 && static_cast<std::size_t>(frame) < tree.frames.size());
  const int body = tree.frames[static_cast<std::size_t>(frame)].body;
  return 1.0 / mobility(tree, state, mass, body, p_B, {n_B, Vector3d::Zero()}, work);
}

}  // namespace abstand::mechanism
