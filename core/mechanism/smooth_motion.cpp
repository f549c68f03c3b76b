#include "core/mechanism/smooth_motion.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::mechanism {

SmoothMotion::SmoothMotion(const MotionTable& table)
    : t_(table.times().begin(), table.times().end()),
      q_(table.values().begin(), table.values().end()),
      slopes_(q_.size(), 0.0),
      dof_(table.dof()) {
  const std::size_t rows = t_.size(), n = static_cast<std::size_t>(dof_);
  if (rows < 3) return;
  // Continuity of acceleration at every row, slopes 0 at the ends: a tridiagonal system with one matrix for
  // all joints, solved by the Thomas algorithm.
  std::vector<double> above(rows, 0.0);
  for (std::size_t i = 1; i + 1 < rows; ++i) {
    const double before = 1.0 / (t_[i] - t_[i - 1]), after = 1.0 / (t_[i + 1] - t_[i]);
    const double pivot = 2.0 * (before + after) - before * above[i - 1];
    above[i] = after / pivot;
    for (std::size_t k = 0; k < n; ++k) {
      const double* q = q_.data() + i * n + k;
      const double right = 3.0 * (before * before * (q[0] - *(q - n)) + after * after * (q[n] - q[0]));
      slopes_[i * n + k] = (right - before * slopes_[(i - 1) * n + k]) / pivot;
    }
  }
  for (std::size_t i = rows - 1; i-- > 1;)
    for (std::size_t k = 0; k < n; ++k) slopes_[i * n + k] -= above[i] * slopes_[(i + 1) * n + k];
}

void SmoothMotion::at(double t, std::span<double> q, std::span<double> qd, std::span<double> qdd) const {
  const auto n = static_cast<std::size_t>(dof_);
  ABSTAND_CHECK(q.size() == n && qd.size() == n && qdd.size() == n);
  if (!(t > t_.front() && t < t_.back())) {
    const double* row = t >= t_.back() ? q_.data() + q_.size() - n : q_.data();
    std::copy_n(row, n, q.begin());
    std::fill(qd.begin(), qd.end(), 0.0);
    std::fill(qdd.begin(), qdd.end(), 0.0);
    return;
  }
  const auto after = static_cast<std::size_t>(std::upper_bound(t_.begin(), t_.end(), t) - t_.begin());
  const double h = t_[after] - t_[after - 1], u = (t - t_[after - 1]) / h;
  const double* q0 = q_.data() + (after - 1) * n;
  const double* m0 = slopes_.data() + (after - 1) * n;
  for (std::size_t k = 0; k < n; ++k) {
    // Hermite form: q0 + h u m0 + u^2 (3 D - 2 h m0 - h m1) + u^3 (h m0 + h m1 - 2 D), D = q1 - q0.
    const double d = q0[n + k] - q0[k], a = h * m0[k], b = h * m0[n + k];
    const double c2 = 3.0 * d - 2.0 * a - b, c3 = a + b - 2.0 * d;
    q[k] = q0[k] + u * (a + u * (c2 + u * c3));
    qd[k] = (a + u * (2.0 * c2 + 3.0 * u * c3)) / h;
    qdd[k] = (2.0 * c2 + 6.0 * u * c3) / (h * h);
  }
}

}  // namespace abstand::mechanism
