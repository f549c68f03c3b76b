// A mechanism in joint coordinates, by own forward dynamics.
//
// (M + h D) qd' = M qd + h (efforts - C u - g + J^T w) + G^T x, with x the impulses of stops and motors: each
// of their joints has its target velocity, or x is at its bound.
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/mechanism/mass_matrix.hpp"
#include "core/physics/articulation.hpp"
#include "core/physics/box_lcp.hpp"

namespace abstand::physics {
namespace {

class Reduced final : public Articulation {
 public:
  Reduced(const mechanism::Mechanism& mechanism, const Transform& X_WB, const MechanismOptions& options,
          const Vector3d& gravity_W);
  void begin(double h) override;
  void end(double h) override;

 private:
  void gatherRows(double h);
  void addRow(std::size_t body, double velocity, double lower, double upper);
  void solveRows();
  double pushAtStop(std::size_t body) const;
  bool atStop(std::size_t body) const {
    return value(body) <= joints_[body].lower || value(body) >= joints_[body].upper;
  }
  std::size_t dofOf(std::size_t body) const { return static_cast<std::size_t>(tree_.bodies[body].dof); }

  mechanism::TreeState bias_state_;
  mechanism::MassMatrix step_mass_;  ///< M + h D
  std::vector<double> next_, bias_;
  BoxLcp rows_;
  std::vector<std::size_t> row_bodies_;
  std::vector<Eigen::Index> motor_rows_;  ///< of each dof, -1: none
  Eigen::MatrixXd responses_;             ///< one column for each row: change of qd by a unit of its impulse
};

Reduced::Reduced(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                 const MechanismOptions& options, const Vector3d& gravity_W)
    : Articulation(mechanism, X_WB, options, gravity_W) {
  mechanism::massMatrix(tree_, state_, mass_);
  if (const int dof = mechanism::factor(mass_); dof >= 0) {
    std::string name;
    for (const mechanism::TreeBody& b : tree_.bodies)
      if (b.dof == dof) name = mechanism.frames[static_cast<std::size_t>(b.frame)].name;
    throw ParseError({mechanism.name},
                     "the dof of frame '" + name + "' moves no mass, expected a mass on or beyond it",
                     "give the link an inertia in its file, or its mesh a density");
  }
  const auto n = static_cast<Eigen::Index>(tree_.bodies.size());
  rows_.reserve(n);
  row_bodies_.reserve(tree_.bodies.size());
  motor_rows_.assign(q_.size(), -1);
  responses_.setZero(tree_.dof, n);
  next_.assign(q_.size(), 0.0);
  bias_.assign(q_.size(), 0.0);
}

void Reduced::addRow(std::size_t body, double velocity, double lower, double upper) {
  const auto r = static_cast<Eigen::Index>(row_bodies_.size());
  row_bodies_.push_back(body);
  const mechanism::TreeBody& b = tree_.bodies[body];
  auto response = responses_.col(r);
  response.setZero();
  response[b.dof] = b.scale;
  mechanism::solveMass(step_mass_, {response.data(), next_.size()});
  rows_.b[r] = velocity - b.scale * next_[static_cast<std::size_t>(b.dof)];
  rows_.lower[r] = lower;
  rows_.upper[r] = upper;
  for (Eigen::Index k = 0; k <= r; ++k) {
    const mechanism::TreeBody& other = tree_.bodies[row_bodies_[static_cast<std::size_t>(k)]];
    rows_.A(k, r) = rows_.A(r, k) = other.scale * response[other.dof];
  }
}

/// Collects rows for active stops, and for motors of the other joints.
void Reduced::gatherRows(double h) {
  row_bodies_.clear();
  std::fill(motor_rows_.begin(), motor_rows_.end(), -1);
  for (std::size_t i = 0; i < tree_.bodies.size(); ++i) {
    const mechanism::TreeBody& b = tree_.bodies[i];
    const Motor& motor = motors_[static_cast<std::size_t>(b.dof)];
    if (b.scale == 0.0) continue;
    const double down = joints_[i].lower - value(i), up = joints_[i].upper - value(i);
    if (down >= 0.0)
      addRow(i, std::min(kStopReturn * down / h, kStopSpeed), 0.0, kInfinity);
    else if (up <= 0.0)
      addRow(i, std::max(kStopReturn * up / h, -kStopSpeed), -kInfinity, 0.0);
    else if (motor.max_effort > 0.0) {
      // Mimic joints are driven as one: separate rows would be linearly dependent.
      Eigen::Index& row = motor_rows_[static_cast<std::size_t>(b.dof)];
      const double max_impulse = h * motor.max_effort * joints_[i].share;
      if (row < 0) {
        row = static_cast<Eigen::Index>(row_bodies_.size());
        addRow(i, b.scale * motor.velocity, -max_impulse, max_impulse);
      } else {
        const double first = tree_.bodies[row_bodies_[static_cast<std::size_t>(row)]].scale;
        const double more = max_impulse * std::abs(b.scale / first);
        rows_.lower[row] -= more;
        rows_.upper[row] += more;
      }
    }
  }
}

void Reduced::solveRows() {
  const auto n = static_cast<Eigen::Index>(row_bodies_.size());
  if (n == 0) return;
  solveBoxLcp(rows_, n);
  for (Eigen::Index r = 0; r < n; ++r)
    for (std::size_t k = 0; k < next_.size(); ++k)
      next_[k] += rows_.x[r] * responses_(static_cast<Eigen::Index>(k), r);
}

/// Effort of a motor on a dof whose joint is at a stop, as in ODE: its full effort in the direction of the
/// target velocity; at target 0, into the stop.
double Reduced::pushAtStop(std::size_t i) const {
  const Motor& motor = motors_[dofOf(i)];
  if (motor.max_effort == 0.0 || !atStop(i)) return 0.0;
  const double velocity = tree_.bodies[i].scale * motor.velocity;
  const double direction = velocity != 0.0                ? std::copysign(1.0, velocity)
                           : value(i) <= joints_[i].lower ? -1.0
                                                          : 1.0;
  return tree_.bodies[i].scale * direction * motor.max_effort * joints_[i].share;
}

void Reduced::begin(double h) {
  drive(h);
  mechanism::inverseDynamics(tree_, {q_, middle_, {}}, {gravity_W_, external_}, bias_state_, bias_);
  mechanism::massMatrix(tree_, state_, mass_);
  step_mass_.M = mass_.M;
  for (std::size_t k = 0; k < q_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    double momentum = 0.0;
    for (Eigen::Index i = 0; i < mass_.M.rows(); ++i)
      momentum += mass_.M(at, i) * qd_[static_cast<std::size_t>(i)];
    next_[k] = momentum + h * (drive_[k] - bias_[k]);
  }
  for (std::size_t i = 0; i < tree_.bodies.size(); ++i) {
    next_[dofOf(i)] += h * pushAtStop(i);
    const double scale = tree_.bodies[i].scale;
    const int k = tree_.bodies[i].dof;
    if (motors_[dofOf(i)].max_effort == 0.0 && !atStop(i))
      step_mass_.M(k, k) += h * scale * scale * joints_[i].damping;
  }
  if (mechanism::factor(step_mass_) >= 0) {
    std::copy(qd_.begin(), qd_.end(), next_.begin());
    return;
  }
  mechanism::solveMass(step_mass_, next_);
  gatherRows(h);
  solveRows();
}

void Reduced::end(double h) {
  qd_ = next_;
  advance(h);
}

}  // namespace

std::unique_ptr<Articulation> makeReduced(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                                          const MechanismOptions& options, const Vector3d& gravity_W) {
  return std::make_unique<Reduced>(mechanism, X_WB, options, gravity_W);
}

}  // namespace abstand::physics
