#include "core/physics/physics_world.hpp"

#include <ode/ode.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <mutex>

#include "core/base/error.hpp"
#include "core/mechanism/link_inertia.hpp"

namespace abstand::physics {
namespace {

// N, N m, m/s, rad/s: larger values are not physical and would overflow.
constexpr double kMax = 1e9;

bool sound(double value) { return std::abs(value) <= kMax; }
bool sound(const Vector3d& v) { return v.cwiseAbs().maxCoeff() <= kMax && v.allFinite(); }

Vector3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

Matrix3d matrix(const dReal* R) {
  Matrix3d result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result(row, column) = R[4 * row + column];
  return result;
}

void startOde() {
  static std::once_flag once;
  std::call_once(once, [] { ABSTAND_CHECK(dInitODE2(0) && dCheckConfiguration("ODE_double_precision")); });
}

/// Runs the parts of a step sequentially on the calling thread. ODE's default threading is shared by all
/// worlds, which then must not step at the same time.
dxThreadingImplementation* makeThreading() {
  startOde();
  return dThreadingAllocateSelfThreadedImplementation();
}

dxWorld* makeWorld(const Vector3d& gravity_W, dxThreadingImplementation* threading) {
  dxWorld* world = dWorldCreate();
  dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(threading), threading);
  dWorldSetGravity(world, gravity_W.x(), gravity_W.y(), gravity_W.z());
  // Joints have no position error and are never redundant: see jointed.cpp.
  dWorldSetERP(world, 0.0);
  dWorldSetCFM(world, 0.0);
  return world;
}

}  // namespace

/// In ODE a body's origin is its centre of mass.
struct PhysicsWorld::FreeBody {
  dBodyID id;
  mechanism::LinkInertia inertia;
  Matrix3d inverse;  ///< inverse of the inertia, in the body's axes

  Matrix3d axes() const { return matrix(dBodyGetRotation(id)); }
  Vector3d center() const { return vector(dBodyGetPosition(id)); }
};

PhysicsWorld::PhysicsWorld(const PhysicsOptions& options)
    : gravity_W_(options.gravity_W),
      threading_(makeThreading(), dThreadingFreeImplementation),
      world_(makeWorld(options.gravity_W, threading_.get()), dWorldDestroy) {}

PhysicsWorld::~PhysicsWorld() = default;

int PhysicsWorld::addMechanism(const mechanism::Mechanism& mechanism, const Transform& X_WB,
                               const MechanismOptions& options) {
  mechanisms_.push_back(options.solver == MechanismSolver::kJointed
                            ? makeJointed(world_.get(), mechanism, X_WB, options, gravity_W_)
                            : makeReduced(mechanism, X_WB, options, gravity_W_));
  bases_.push_back(X_WB);
  return static_cast<int>(mechanisms_.size()) - 1;
}

int PhysicsWorld::addFreeBody(const mechanism::LinkInertia& body, const Transform& X_WF,
                              const Twist& twist_W) {
  std::string fault = mechanism::inertiaFault(body);
  if (fault.empty() && !(body.mass > 0.0 && Eigen::LLT<Matrix3d>(body.inertia_F).info() == Eigen::Success))
    fault = "found a body without mass or extent, expected a mass and three positive principal moments";
  if (!fault.empty()) throw UsageError("free body: " + fault);
  if (!isPose(X_WF)) throw UsageError("free body: found a pose that is none, expected a rotation and metres");

  const dBodyID id = dBodyCreate(world_.get());
  const Matrix3d& I = body.inertia_F;
  dMass mass;
  dMassSetParameters(&mass, body.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  dBodySetMass(id, &mass);
  dBodySetAutoDisableFlag(id, 0);
  dBodySetFiniteRotationMode(id, 1);
  dBodySetMaxAngularSpeed(id, kMaxRate);
  const Vector3d center = X_WF * body.com_F;
  dBodySetPosition(id, center.x(), center.y(), center.z());
  dMatrix3 R{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) R[4 * row + column] = X_WF.linear()(row, column);
  dBodySetRotation(id, R);
  dBodySetLinearVel(id, twist_W.linear.x(), twist_W.linear.y(), twist_W.linear.z());
  dBodySetAngularVel(id, twist_W.angular.x(), twist_W.angular.y(), twist_W.angular.z());
  bodies_.push_back({id, body, I.inverse()});
  return static_cast<int>(bodies_.size()) - 1;
}

void PhysicsWorld::setJointEffort(int mechanism_number, int dof, double effort) {
  Articulation& m = mechanism(mechanism_number);
  ABSTAND_CHECK(dof >= 0 && dof < m.dof());
  if (sound(effort))
    m.setEffort(dof, effort);
  else
    ++dropped_;
}

void PhysicsWorld::setMotor(int mechanism_number, int dof, double velocity, double max_effort) {
  Articulation& m = mechanism(mechanism_number);
  ABSTAND_CHECK(dof >= 0 && dof < m.dof());
  if (sound(velocity) && sound(max_effort) && max_effort >= 0.0)
    m.setMotor(dof, velocity, max_effort);
  else
    ++dropped_;
}

bool PhysicsWorld::accept(const Wrench& w, const Vector3d& p) {
  const bool good = sound(w.force) && sound(w.torque) && sound(p);
  if (!good) ++dropped_;
  return good;
}

void PhysicsWorld::applyWrench(const PhysicsObject& object, const Wrench& w_W, const Vector3d& p_W) {
  if (object.index < 0 || !accept(w_W, p_W)) return;
  if (object.mechanism >= 0) {
    mechanism(object.mechanism).addWrench(object.index, w_W, p_W);
    return;
  }
  const FreeBody& body = bodies_.at(static_cast<std::size_t>(object.index));
  const Vector3d torque = w_W.torque + (p_W - body.center()).cross(w_W.force);
  dBodyAddForce(body.id, w_W.force.x(), w_W.force.y(), w_W.force.z());
  dBodyAddTorque(body.id, torque.x(), torque.y(), torque.z());
}

double PhysicsWorld::mobilityOf(const PhysicsObject& object, const Vector3d& p_W, const Wrench& w_W) {
  if (object.index < 0) return 0.0;
  if (object.mechanism >= 0) return mechanism(object.mechanism).mobilityOf(object.index, p_W, w_W);
  const FreeBody& body = bodies_.at(static_cast<std::size_t>(object.index));
  const Vector3d torque = body.axes().transpose() * (w_W.torque + (p_W - body.center()).cross(w_W.force));
  return w_W.force.squaredNorm() / body.inertia.mass + torque.dot(body.inverse * torque);
}

void PhysicsWorld::applyContact(const PhysicsObject& a, const PhysicsObject& b, const Contact& contact,
                                const ContactOptions& options, double h) {
  const Wrench penalty{contact.force_a, contact.torque_a};
  if (!accept(penalty, contact.p_a) || !sound(contact.near)) return;
  if (!sound(contact.carried.linear) || !sound(contact.carried.angular)) return;
  if (contact.force_a.squaredNorm() == 0.0) return;
  const Vector3d c_W = contactPoint(contact);
  const Twist twist_a = velocityAt(a, c_W), twist_b = velocityAt(b, c_W);
  ContactMotion motion;
  const Twist& carried = contact.carried;
  motion.relative.angular = twist_a.angular - twist_b.angular + carried.angular;
  motion.relative.linear =
      twist_a.linear - twist_b.linear + carried.linear + carried.angular.cross(Vector3d(c_W - contact.near));
  const auto both = [&](const Wrench& unit) { return mobilityOf(a, c_W, unit) + mobilityOf(b, c_W, unit); };
  const Vector3d normal = contact.force_a.normalized();
  const Vector3d slip = motion.relative.linear - normal.dot(motion.relative.linear) * normal;
  motion.normal_mobility = both({normal, Vector3d::Zero()});
  motion.slip_mobility = both({slip.normalized(), Vector3d::Zero()});
  motion.turn_mobility = both({Vector3d::Zero(), motion.relative.angular.normalized()});

  const Wrench damping = contactDamping(contact, motion, options, h);
  applyWrench(a, penalty, contact.p_a);
  applyWrench(b, {-penalty.force, -penalty.torque}, contact.p_a);
  applyWrench(a, damping, c_W);
  applyWrench(b, {-damping.force, -damping.torque}, c_W);
}

void PhysicsWorld::step(double h) {
  ABSTAND_CHECK(h > 0.0 && std::isfinite(h));
  for (const auto& m : mechanisms_) m->begin(h);
  dWorldStep(world_.get(), h);
  for (const auto& m : mechanisms_) m->end(h);
  time_ += h;
}

Transform PhysicsWorld::pose(const PhysicsObject& object) const {
  if (object.mechanism >= 0 && object.index >= 0) return mechanism(object.mechanism).pose(object.index);
  if (object.mechanism >= 0) return bases_.at(static_cast<std::size_t>(object.mechanism));
  Transform X_WF = Transform::Identity();
  if (object.index < 0) return X_WF;
  const FreeBody& body = bodies_.at(static_cast<std::size_t>(object.index));
  X_WF.linear() = body.axes();
  X_WF.translation() = body.center() - X_WF.linear() * body.inertia.com_F;
  return X_WF;
}

Twist PhysicsWorld::velocityAt(const PhysicsObject& object, const Vector3d& p_W) const {
  if (object.index < 0) return {};
  if (object.mechanism >= 0) return mechanism(object.mechanism).velocityAt(object.index, p_W);
  const FreeBody& body = bodies_.at(static_cast<std::size_t>(object.index));
  const Vector3d omega = vector(dBodyGetAngularVel(body.id));
  return {vector(dBodyGetLinearVel(body.id)) + omega.cross(p_W - body.center()), omega};
}

mechanism::MechanicalEnergy PhysicsWorld::energy() {
  mechanism::MechanicalEnergy sum;
  for (const auto& m : mechanisms_) {
    const mechanism::MechanicalEnergy e = m->energy();
    sum.kinetic += e.kinetic;
    sum.potential += e.potential;
  }
  for (const FreeBody& body : bodies_) {
    const Vector3d omega = body.axes().transpose() * vector(dBodyGetAngularVel(body.id));
    sum.kinetic += 0.5 * (body.inertia.mass * vector(dBodyGetLinearVel(body.id)).squaredNorm() +
                          omega.dot(body.inertia.inertia_F * omega));
    sum.potential -= body.inertia.mass * gravity_W_.dot(body.center());
  }
  return sum;
}

}  // namespace abstand::physics
