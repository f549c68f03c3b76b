#include "core/mechanism/effective_mass.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::mechanism {

double mobility(const PostureMass& m, int body, const Vector3d& p_B, const Wrench& w,
                std::span<double> work) {
  ABSTAND_CHECK(m.mass.L.rows() == m.tree.dof);
  std::fill(work.begin(), work.end(), 0.0);
  addBodyEfforts(m.tree, m.state, body, p_B, w, work);
  return mobilityOf(m.mass, work);
}

double effectiveMass(const PostureMass& m, int frame, const Vector3d& p_B, const Vector3d& n_B,
                     std::span<double> work) {
  ABSTAND_CHECK(frame >= 0 && static_cast<std::size_t>(frame) < m.tree.frames.size());
  const int body = m.tree.frames[static_cast<std::size_t>(frame)].body;
  return 1.0 / mobility(m, body, p_B, {n_B, Vector3d::Zero()}, work);
}

}  // namespace abstand::mechanism
