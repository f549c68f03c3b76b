#include "tests/support/robots.hpp"

#include <array>

#include "tests/support/random_pose.hpp"

namespace abstand::testing {
namespace {

/// Adds a frame with its mass and the limits of its joint; gives its index.
int add(mechanism::Mechanism& m, int parent, mechanism::JointType type, const Vector3d& axis,
        const Vector3d& xyz, const mechanism::LinkInertia& body, double reach, double effort) {
  mechanism::MechanismFrame f =
      jointFrame(static_cast<int>(m.frames.size()) + 1, parent, type, axis, xyz, m.dof++);
  f.inertia = body;
  f.limits = {-reach, reach, 3.0, effort};
  m.frames.push_back(f);
  return static_cast<int>(m.frames.size()) - 1;
}

const Vector3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

/// Seven axes from a shoulder, alternately along the arm (`down`) and across it.
int addArm(mechanism::Mechanism& m, int parent, const Vector3d& shoulder, const Vector3d& down) {
  constexpr std::array kLength{0.11, 0.2, 0.2, 0.2, 0.2, 0.19, 0.08};
  constexpr std::array kMass{3.6, 3.4, 2.9, 2.6, 1.7, 1.5, 0.4};
  constexpr std::array kEffort{200.0, 200.0, 100.0, 100.0, 100.0, 40.0, 40.0};
  Vector3d at = shoulder;
  for (std::size_t i = 0; i < 7; ++i) {
    const Vector3d size = Vector3d::Constant(0.11) + kLength[i] * down.cwiseAbs();
    parent = add(m, parent, mechanism::JointType::kRevolute, i % 2 == 0 ? down : kY, at,
                 boxMass(kMass[i], size, 0.5 * kLength[i] * down), 2.9, kEffort[i]);
    at = kLength[i] * down;
  }
  return parent;
}

}  // namespace

mechanism::MechanismFrame jointFrame(int id, int parent, mechanism::JointType type, const Vector3d& axis,
                                     const Vector3d& xyz, int dof) {
  mechanism::MechanismFrame f;
  f.id = id;
  f.name = std::to_string(id);
  f.parent = parent;
  f.type = type;
  f.has_dh = false;
  f.axis = axis.normalized();
  f.X_PJ.translation() = xyz;
  f.dof = dof;
  return f;
}

mechanism::LinkInertia pointMass(double mass, const Vector3d& com_F) {
  return {mass, com_F, Matrix3d::Zero()};
}

mechanism::LinkInertia boxMass(double mass, const Vector3d& size, const Vector3d& com_F) {
  const Vector3d s = size.cwiseAbs2();
  return {mass, com_F,
          mass / 12.0 * Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal().toDenseMatrix()};
}

mechanism::Mechanism pendulum(double mass, double length) {
  mechanism::Mechanism m;
  m.dof = 1;
  m.frames.push_back(jointFrame(1, -1, mechanism::JointType::kRevolute, kY, Vector3d::Zero(), 0));
  m.frames[0].inertia = pointMass(mass, {0, 0, -length});
  m.prepare();
  return m;
}

mechanism::Mechanism doublePendulum(double m0, double l0, double m1, double l1) {
  mechanism::Mechanism m = pendulum(m0, l0);
  m.dof = 2;
  m.frames.push_back(jointFrame(2, 0, mechanism::JointType::kRevolute, kY, {0, 0, -l0}, 1));
  m.frames[1].inertia = pointMass(m1, {0, 0, -l1});
  m.prepare();
  return m;
}

mechanism::Mechanism randomRobot(std::uint64_t seed, int frames, bool mimic) {
  auto draw = [&, stream = std::uint64_t{1000}]() mutable { return 2.0 * randomUnit(seed, ++stream) - 1.0; };
  const auto vector = [&](double size) { return Vector3d(size * draw(), size * draw(), size * draw()); };
  mechanism::Mechanism m;
  for (int i = 0; i < frames; ++i) {
    // Mostly chains; every fourth frame branches off. Every fifth is fixed, every third of the rest slides.
    const int parent = i == 0 ? -1 : i - 1 - (i % 4 == 3 ? 1 : 0);
    const bool fixed = (i + static_cast<int>(seed % 5)) % 5 == 4;
    const auto type = fixed                                       ? mechanism::JointType::kFixed
                      : (i + static_cast<int>(seed % 3)) % 3 == 2 ? mechanism::JointType::kPrismatic
                                                                  : mechanism::JointType::kRevolute;
    mechanism::MechanismFrame f =
        jointFrame(i + 1, parent, type, i % 3 == 0 ? kZ : vector(1.0), vector(0.4), -1);
    f.X_PJ.linear() = randomPose(seed * 100 + static_cast<std::uint64_t>(i)).linear();
    if (!fixed) {
      const bool shares = mimic && m.dof > 1 && i % 3 == 1;
      f.dof = shares ? m.dof - 1 : m.dof++;
      f.offset = draw();
      f.scale = mimic ? 1.0 + 0.5 * draw() : 1.0;
    }
    const Matrix3d R = randomPose(seed * 100 + 50 + static_cast<std::uint64_t>(i)).linear();
    f.inertia = boxMass(1.5 + draw(), Vector3d::Constant(0.3) + vector(0.2), vector(0.2));
    f.inertia.inertia_F = R * f.inertia.inertia_F * R.transpose();
    m.frames.push_back(f);
  }
  m.prepare();
  return m;
}

mechanism::Mechanism sevenAxisArm() {
  mechanism::Mechanism m;
  m.name = "seven";
  addArm(m, -1, Vector3d::Zero(), kZ);
  m.prepare();
  return m;
}

mechanism::Mechanism humanoid() {
  constexpr auto kTurn = mechanism::JointType::kRevolute, kSlide = mechanism::JointType::kPrismatic;
  mechanism::Mechanism m;
  m.name = "humanoid";
  int at = add(m, -1, kSlide, kX, {0, 0, 0}, boxMass(1.0, {0.3, 0.3, 0.1}, {0, 0, 0.1}), kInfinity, 500);
  at = add(m, at, kSlide, kY, {0, 0, 0}, boxMass(1.0, {0.3, 0.3, 0.1}, {0, 0, 0.1}), kInfinity, 500);
  at = add(m, at, kTurn, kZ, {0, 0, 0}, boxMass(120, {0.7, 0.7, 0.4}, {0, 0, 0.3}), kInfinity, 500);
  at = add(m, at, kTurn, kZ, {0, 0, 0.6}, boxMass(8, {0.2, 0.2, 0.2}, {0, 0, 0.1}), 2.0, 300);
  at = add(m, at, kTurn, kY, {0, 0, 0.2}, boxMass(8, {0.2, 0.2, 0.3}, {0, 0, 0.15}), 1.5, 300);
  const int torso = add(m, at, kTurn, kY, {0, 0, 0.3}, boxMass(20, {0.25, 0.4, 0.4}, {0, 0, 0.2}), 1.5, 300);
  at = add(m, torso, kTurn, kZ, {0, 0, 0.45}, boxMass(1, {0.1, 0.1, 0.1}, {0, 0, 0.05}), 1.5, 20);
  add(m, at, kTurn, kY, {0, 0, 0.1}, boxMass(4, {0.2, 0.15, 0.2}, {0, 0, 0.1}), 0.8, 20);
  for (const double side : {1.0, -1.0}) {
    const int hand = addArm(m, torso, {0, 0.25 * side, 0.35}, -kZ);
    int palm = hand;
    if (side > 0)
      palm = add(m, hand, kTurn, kX, {0, 0, -0.08}, boxMass(0.5, {0.03, 0.1, 0.1}, {0, 0, -0.05}), 0.5, 5);
    for (int finger = 0; finger < 4; ++finger) {
      int bone = palm;
      Vector3d xyz(0, 0.03 * finger - 0.045, -0.1);
      for (int k = 0; k < 3; ++k) {
        bone = add(m, bone, kTurn, kY, xyz, boxMass(0.08, {0.02, 0.02, 0.04}, {0, 0, -0.02}), 1.5, 3);
        xyz = {0, 0, -0.04};
      }
    }
  }
  m.prepare();
  return m;
}

std::vector<double> randomValues(int n, std::uint64_t seed, std::uint64_t stream, double reach) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(reach * (2.0 * randomUnit(seed, stream + static_cast<std::uint64_t>(i)) - 1.0));
  return values;
}

}  // namespace abstand::testing
