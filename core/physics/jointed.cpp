// A mechanism as bodies and joints of ODE.
//
// ODE's step solves M v' = M v + h f under J(x) v' = 0, then moves the bodies. On its own this omits the
// velocity terms of the rotating joint axes (the time derivative of J); joints would drift apart and be
// pulled back by error correction. Here joints never drift: every step sets the bodies to the poses and
// velocities of q and qd, ODE computes the new joint velocities, and q is integrated with them, so that
// angles need no unwrapping. The velocity terms are applied as inertial forces: each body's mass times its
// acceleration for qdd = 0, and its gyroscopic torque. This is the step of articulation.hpp, solved by ODE in
// maximal coordinates, with its stops and motors.
#include <ode/ode.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/base/error.hpp"
#include "core/physics/articulation.hpp"

namespace abstand::physics {
namespace {

class Jointed final : public Articulation {
 public:
  Jointed(dxWorld* world, const mechanism::Mechanism& mechanism, const Transform& X_WB,
          const MechanismOptions& options, const Vector3d& gravity_W);
  ~Jointed() override;
  void begin(double h) override;
  void end(double h) override;

 private:
  void placeFree();
  void putBody(std::size_t i);
  void pushBody(std::size_t i);
  void joinHere(std::size_t i);
  void setJoint(std::size_t i, double h);
  double rateOf(std::size_t i) const;
  void share();

  mechanism::RigidTree free_;  ///< every joint has a dof of its own, with the joint's value
  mechanism::TreeState free_state_;
  std::vector<double> values_, rates_, scratch_, momenta_;
  std::vector<Wrench> inertia_forces_;  ///< for each body, about its centre of mass
  std::vector<bool> leads_;             ///< for each joint: it is the first of its dof and has the effort
  bool mimic_{false};
  std::vector<dBodyID> bodies_;
  std::vector<dJointID> ode_joints_;
};

// rad or m: above the rounding of poses a kilometre from the world's origin.
constexpr double kRounding = 1e-12;

/// Checks mass and inertia, by which ODE divides.
void judge(const mechanism::Mechanism& mechanism, const mechanism::TreeBody& b) {
  if (b.mass > 0.0 && Eigen::LLT<Matrix3d>(b.inertia).info() == Eigen::Success) return;
  throw ParseError({mechanism.name},
                   "what moves with frame '" + mechanism.frames[static_cast<std::size_t>(b.frame)].name +
                       "': found " + (b.mass > 0.0 ? "a body without extent" : "no mass") +
                       ", expected a mass and an inertia with three positive principal moments",
                   "give the link an inertia in its file, or its mesh a density");
}

Jointed::Jointed(dxWorld* world, const mechanism::Mechanism& mechanism, const Transform& X_WB,
                 const MechanismOptions& options, const Vector3d& gravity_W)
    : Articulation(mechanism, X_WB, options, gravity_W), free_(tree_) {
  for (const mechanism::TreeBody& b : tree_.bodies) judge(mechanism, b);
  const std::size_t n = tree_.bodies.size();
  free_.dof = static_cast<int>(n);
  std::vector<bool> seen(static_cast<std::size_t>(tree_.dof), false);
  for (std::size_t i = 0; i < n; ++i) {
    mechanism::TreeBody& b = free_.bodies[i];
    const auto k = static_cast<std::size_t>(b.dof);
    leads_.push_back(!seen[k]);
    mimic_ = mimic_ || seen[k];
    seen[k] = true;
    b.dof = static_cast<int>(i);
    b.offset = 0.0;
    b.scale = 1.0;
  }
  values_.assign(n, 0.0);
  rates_.assign(n, 0.0);
  scratch_.assign(n, 0.0);
  momenta_.assign(n, 0.0);
  inertia_forces_.assign(n, {});
  placeFree();
  for (std::size_t i = 0; i < n; ++i) {
    const mechanism::TreeBody& b = free_.bodies[i];
    const Matrix3d& I = b.inertia;
    dMass mass;
    dMassSetParameters(&mass, b.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    bodies_.push_back(dBodyCreate(world));
    dBodySetMass(bodies_[i], &mass);
    dBodySetGyroscopicMode(bodies_[i], 0);  // included in the inertial forces
    dBodySetAutoDisableFlag(bodies_[i], 0);
    putBody(i);
    ode_joints_.push_back(b.prismatic ? dJointCreateSlider(world, nullptr)
                                      : dJointCreateHinge(world, nullptr));
    dJointAttach(ode_joints_[i], bodies_[i],
                 b.parent < 0 ? nullptr : bodies_[static_cast<std::size_t>(b.parent)]);
    if (!b.prismatic)
      dJointSetHingeAnchor(ode_joints_[i], free_state_.bodies[i].p_B.x(), free_state_.bodies[i].p_B.y(),
                           free_state_.bodies[i].p_B.z());
    joinHere(i);
  }
}

Jointed::~Jointed() {
  for (const dJointID joint : ode_joints_) dJointDestroy(joint);
  for (const dBodyID body : bodies_) dBodyDestroy(body);
}

/// Computes poses and velocities of all bodies, accelerations for qdd = 0 and the middle rates without
/// gravity, and the gyroscopic torque of these rates.
void Jointed::placeFree() {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const mechanism::TreeBody& b = tree_.bodies[i];
    values_[i] = value(i);
    rates_[i] = b.scale * middle_[static_cast<std::size_t>(b.dof)];
  }
  mechanism::inverseDynamics(free_, {values_, rates_, {}}, {Vector3d::Zero(), {}}, free_state_, scratch_);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const mechanism::TreeBody& b = free_.bodies[i];
    const mechanism::TreeBodyState& s = free_state_.bodies[i];
    const Vector3d omega = s.R_B.transpose() * s.omega, alpha = s.R_B.transpose() * s.alpha;
    inertia_forces_[i].force =
        -b.mass * (s.acceleration + s.alpha.cross(s.com_B) + s.omega.cross(s.omega.cross(s.com_B)));
    inertia_forces_[i].torque = -(s.R_B * (b.inertia * alpha + omega.cross(b.inertia * omega)));
    rates_[i] = tree_.bodies[i].scale * qd_[static_cast<std::size_t>(tree_.bodies[i].dof)];
  }
  mechanism::moveBodies(free_, rates_, free_state_);
}

void Jointed::putBody(std::size_t i) {
  const mechanism::TreeBodyState& s = free_state_.bodies[i];
  dMatrix3 R{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) R[4 * row + column] = s.R_B(row, column);
  const Vector3d c = s.p_B + s.com_B, v = s.velocity + s.omega.cross(s.com_B);
  dBodySetPosition(bodies_[i], c.x(), c.y(), c.z());
  dBodySetRotation(bodies_[i], R);
  dBodySetLinearVel(bodies_[i], v.x(), v.y(), v.z());
  dBodySetAngularVel(bodies_[i], s.omega.x(), s.omega.y(), s.omega.z());
}

/// Applies the external wrench and inertial forces. Gravity is ODE's own.
void Jointed::pushBody(std::size_t i) {
  const mechanism::TreeBodyState& s = free_state_.bodies[i];
  const Vector3d force = external_[i].force + inertia_forces_[i].force;
  const Vector3d torque =
      external_[i].torque - (s.p_B + s.com_B).cross(external_[i].force) + inertia_forces_[i].torque;
  dBodyAddForce(bodies_[i], force.x(), force.y(), force.z());
  dBodyAddTorque(bodies_[i], torque.x(), torque.y(), torque.z());
}

/// Makes the present value of the joint ODE's zero: stops are relative to it, so any range works.
void Jointed::joinHere(std::size_t i) {
  const Vector3d& axis = free_state_.bodies[i].axis_B;
  if (free_.bodies[i].prismatic)
    dJointSetSliderAxis(ode_joints_[i], axis.x(), axis.y(), axis.z());
  else
    dJointSetHingeAxis(ode_joints_[i], axis.x(), axis.y(), axis.z());
}

/// Sets effort, stops, motor or damper of a joint.
void Jointed::setJoint(std::size_t i, double h) {
  const mechanism::TreeBody& b = tree_.bodies[i];
  const auto k = static_cast<std::size_t>(b.dof);
  const dJointID joint = ode_joints_[i];
  const auto set = [&](int what, double to) {
    b.prismatic ? dJointSetSliderParam(joint, what, to) : dJointSetHingeParam(joint, what, to);
  };
  if (leads_[i] && b.scale != 0.0) {
    const double effort = drive_[k] / b.scale;
    b.prismatic ? dJointAddSliderForce(joint, effort) : dJointAddHingeTorque(joint, effort);
  }

  // ODE accepts stops of hinges only within half a turn; a farther one is out of reach.
  bool at_stop = false;
  const JointSide& side = joints_[i];
  if (side.lower > -kInfinity || side.upper < kInfinity) {
    joinHere(i);
    const double down = side.lower - values_[i], up = side.upper - values_[i];
    const double reach = b.prismatic ? kInfinity : kPi;
    at_stop = down >= 0.0 || up <= 0.0;
    // ODE measures the joint again: rounding must not decide whether it is at its stop.
    const double max_overshoot = kStopSpeed * h / kStopReturn;  // largest overshoot reported to ODE
    const double low = down >= 0.0 ? std::clamp(down, kRounding, max_overshoot) : std::min(down, -kRounding);
    const double high = up <= 0.0 ? std::clamp(up, -max_overshoot, -kRounding) : std::max(up, kRounding);
    set(dParamLoStop, low > -reach ? low : -dInfinity);
    set(dParamHiStop, high < reach ? high : dInfinity);
    set(dParamStopERP, kStopReturn);
    set(dParamStopCFM, 0.0);
  }

  // A damper is a motor with target 0 whose compliance is proportional to its force.
  const bool damped = motors_[k].max_effort == 0.0 && side.damping > 0.0 && !at_stop;
  set(dParamVel, damped ? 0.0 : b.scale * motors_[k].velocity);
  set(dParamFMax, damped ? dInfinity : motors_[k].max_effort * side.share);
  set(dParamCFM, damped ? 1.0 / side.damping : 0.0);
}

void Jointed::begin(double h) {
  drive(h);
  placeFree();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    putBody(i);
    pushBody(i);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) setJoint(i, h);
}

/// The joint's velocity after ODE's step, about or along its axis before the step.
double Jointed::rateOf(std::size_t i) const {
  const auto vector = [](const dReal* v) { return Vector3d(v[0], v[1], v[2]); };
  const mechanism::TreeBodyState& s = free_state_.bodies[i];
  const int parent = free_.bodies[i].parent;
  const Vector3d omega = vector(dBodyGetAngularVel(bodies_[i]));
  if (!free_.bodies[i].prismatic) {
    if (parent < 0) return s.axis_B.dot(omega);
    return s.axis_B.dot(omega - vector(dBodyGetAngularVel(bodies_[static_cast<std::size_t>(parent)])));
  }
  const Vector3d v = vector(dBodyGetLinearVel(bodies_[i]));
  if (parent < 0) return s.axis_B.dot(v);
  const auto p = static_cast<std::size_t>(parent);
  const mechanism::TreeBodyState& below = free_state_.bodies[p];
  const Vector3d arm = s.p_B + s.com_B - below.p_B - below.com_B;
  return s.axis_B.dot(v - vector(dBodyGetLinearVel(bodies_[p])) -
                      vector(dBodyGetAngularVel(bodies_[p])).cross(arm));
}

/// Joints that share a dof get different velocities from ODE's step. They are replaced by those nearest in
/// kinetic energy (Gauss's principle of least constraint): M qd = sum of scale times the joints' momenta.
void Jointed::share() {
  mechanism::inverseDynamics(free_, {values_, {}, rates_}, {Vector3d::Zero(), {}}, free_state_, momenta_);
  std::fill(qd_.begin(), qd_.end(), 0.0);
  for (std::size_t i = 0; i < momenta_.size(); ++i)
    qd_[static_cast<std::size_t>(tree_.bodies[i].dof)] += tree_.bodies[i].scale * momenta_[i];
  mechanism::massMatrix(tree_, state_, mass_);
  if (mechanism::factor(mass_) < 0) mechanism::solveMass(mass_, qd_);
}

void Jointed::end(double h) {
  for (std::size_t i = 0; i < rates_.size(); ++i) rates_[i] = rateOf(i);
  if (mimic_) {
    share();
  } else {
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      const mechanism::TreeBody& b = tree_.bodies[i];
      qd_[static_cast<std::size_t>(b.dof)] = b.scale == 0.0 ? 0.0 : rates_[i] / b.scale;
    }
  }
  advance(h);
}

}  // namespace

std::unique_ptr<Articulation> makeJointed(dxWorld* world, const mechanism::Mechanism& mechanism,
                                          const Transform& X_WB, const MechanismOptions& options,
                                          const Vector3d& gravity_W) {
  return std::make_unique<Jointed>(world, mechanism, X_WB, options, gravity_W);
}

}  // namespace abstand::physics
