#include "core/robot_file/dh_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "core/math/turn_between.hpp"
#include "core/mechanism/joint_range.hpp"

namespace abstand::robot_file {
namespace {

bool moves(const mechanism::MechanismFrame& f) {
  return f.type != mechanism::JointType::kFixed && f.dof >= 0;
}

/// The constant part, including the joint value of a joint that nothing moves.
Transform constantPart(const mechanism::MechanismFrame& f) {
  Transform X = f.X_PJ;
  if (f.type == mechanism::JointType::kPrismatic && f.dof < 0) X.translate(f.offset * f.axis);
  if (f.type == mechanism::JointType::kRevolute && f.dof < 0) X.rotate(Eigen::AngleAxisd(f.offset, f.axis));
  return X;
}

class DhBuilder {
 public:
  DhBuilder(const Robot& robot, const DhTolerance& tolerance)
      : from_(robot.mechanism), tolerance_(tolerance) {
    const std::size_t n = from_.frames.size();
    next_.assign(n + 1, -1);
    carrier_.resize(n);
    std::vector<int> body(n);  // movable frame that carries each frame, plus one; 0: the base
    for (std::size_t i = 0; i < n; ++i) {
      const auto& f = from_.frames[i];
      const int below = f.parent < 0 ? 0 : body[static_cast<std::size_t>(f.parent)];
      body[i] = moves(f) ? static_cast<int>(i) + 1 : below;
      int& next = next_[static_cast<std::size_t>(below)];
      if (moves(f) && next < 0) next = static_cast<int>(i);
      if (!f.name.empty()) names_.insert(f.name);
    }
  }

  mechanism::Mechanism run() {
    for (std::size_t i = 0; i < from_.frames.size(); ++i) carry(i);
    for (std::size_t i = 0; i < from_.frames.size(); ++i) place(i);
    to_.name = from_.name;
    to_.dof = from_.dof;
    to_.prepare();
    return std::move(to_);
  }
  /// New index of each old frame.
  const std::vector<int>& places() const { return places_; }

 private:
  /// A frame of the robot relative to the joint frame `joint` (-1: the base) that moves it.
  struct Carrier {
    int joint{-1};
    Transform X_JL{Transform::Identity()};
  };

  Carrier carrierOf(int frame) const {
    return frame < 0 ? Carrier{} : carrier_[static_cast<std::size_t>(frame)];
  }

  void carry(std::size_t i) {
    const auto& f = from_.frames[i];
    const Carrier below = carrierOf(f.parent);
    const Transform X_JL = below.X_JL * constantPart(f);
    if (!moves(f)) {
      carrier_[i] = {below.joint, X_JL};
      return;
    }
    // The joint's frame, initially the robot's own with z rotated onto the axis; it depends on the next joint
    // below.
    Transform X_LJ = Transform::Identity();
    if (f.axis != Vector3d::UnitZ())
      X_LJ.linear() = turnBetween(Vector3d::UnitZ(), f.axis).toRotationMatrix();
    if (const int k = next_[i + 1]; k >= 0) {
      const auto& next = from_.frames[static_cast<std::size_t>(k)];
      Transform X_LK = constantPart(next);
      for (int p = next.parent; p != static_cast<int>(i);
           p = from_.frames[static_cast<std::size_t>(p)].parent)
        X_LK = constantPart(from_.frames[static_cast<std::size_t>(p)]) * X_LK;
      const Transform X_JK = X_LJ.inverse() * X_LK;
      X_LJ = X_LJ * transformOf(rowToNormal(X_JK.translation(), X_JK.linear() * next.axis, tolerance_));
    }
    addJoint(i, below.joint, X_JL * X_LJ, X_LJ);
  }

  void addJoint(std::size_t i, int parent, const Transform& X, const Transform& X_LJ) {
    const auto& f = from_.frames[i];
    const auto rows = dhRows(X, tolerance_);
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) parent = add(rows[r], parent);
    const int joint = add(rows.back(), parent);
    auto& g = to_.frames.back();
    g.type = f.type;
    g.dof = f.dof;
    g.scale = f.scale;
    g.mimic = f.mimic;
    g.joint = f.joint;
    g.limits = f.limits;
    double& constant = f.type == mechanism::JointType::kRevolute ? g.theta : g.d;
    g.offset = f.offset + constant;
    g.limits.lower += constant;
    g.limits.upper += constant;
    constant = 0.0;
    carrier_[i] = {joint, X_LJ.inverse()};
  }

  int add(const DhRow& row, int parent) {
    mechanism::MechanismFrame f;
    f.id = static_cast<int>(to_.frames.size()) + 1;
    f.name = std::to_string(f.id);
    f.parent = parent;
    f.a = row.a;
    f.alpha = row.alpha;
    f.d = row.d;
    f.theta = row.theta;
    to_.frames.push_back(f);
    taken_.push_back(false);
    return static_cast<int>(to_.frames.size()) - 1;
  }

  bool isSame(const Transform& X) const {
    return X.translation().norm() <= tolerance_.length &&
           (X.linear() - Matrix3d::Identity()).norm() <= tolerance_.angle;
  }

  /// Adds frame i of the robot: the joint's own frame, or fixed frames from it.
  void place(std::size_t i) {
    const auto& f = from_.frames[i];
    const Carrier& c = carrier_[i];
    int at = c.joint;
    if (at < 0 || taken_[static_cast<std::size_t>(at)] || !isSame(c.X_JL))
      for (const DhRow& row : dhRows(c.X_JL, tolerance_)) at = add(row, at);
    taken_[static_cast<std::size_t>(at)] = true;
    auto& g = to_.frames[static_cast<std::size_t>(at)];
    g.name = f.name;
    g.inertia = f.inertia;
    g.has_center = f.has_center;
    g.X_FC = f.X_FC;
    if (moves(f) && at != c.joint) nameJoint(to_.frames[static_cast<std::size_t>(c.joint)], f);
    places_.push_back(at);
  }

  /// A joint's frame that does not exist in the robot gets the joint's name.
  void nameJoint(mechanism::MechanismFrame& joint, const mechanism::MechanismFrame& f) {
    std::string name = f.joint.empty() ? f.name + ".joint" : f.joint;
    while (!names_.insert(name).second) name += '_';
    joint.name = name;
  }

  const mechanism::Mechanism& from_;
  DhTolerance tolerance_;
  mechanism::Mechanism to_;
  std::vector<int> next_;         ///< for the base and each movable frame: the first movable frame on its
                                  ///< body
  std::vector<Carrier> carrier_;  ///< of each old frame
  std::vector<int> places_;
  std::vector<bool> taken_;  ///< new frames that are old ones
  std::unordered_set<std::string> names_;
};

}  // namespace

Robot toDh(const Robot& robot, const DhTolerance& tolerance) {
  DhBuilder builder(robot, tolerance);
  Robot out = robot;
  out.mechanism = builder.run();
  for (auto& g : out.geometry)
    if (g.frame >= 0) g.frame = builder.places()[static_cast<std::size_t>(g.frame)];
  return out;
}

PostureResidual postureResidual(const mechanism::Mechanism& a, const mechanism::Mechanism& b, int postures,
                                const std::vector<double>& scale_b) {
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < b.frames.size(); ++i) index.emplace(b.frames[i].name, i);
  const auto ranges = mechanism::jointRanges(a);
  std::vector<double> q(ranges.size()), q_b(static_cast<std::size_t>(b.dof));
  mechanism::MechanismState state_a, state_b;
  PostureResidual out{postures, 0.0, 0.0, {}};
  for (int k = 0; k < postures; ++k) {
    Random random(1, static_cast<std::uint64_t>(k));
    mechanism::randomPosture(ranges, random, q);
    for (std::size_t i = 0; i < q_b.size(); ++i) q_b[i] = q[i] * (scale_b.empty() ? 1.0 : scale_b[i]);
    mechanism::forward(a, q, state_a);
    mechanism::forward(b, q_b, state_b);
    for (std::size_t i = 0; i < a.frames.size(); ++i) {
      const auto at = index.find(a.frames[i].name);
      if (at == index.end()) continue;
      const Transform &X = state_a.X_BF[i], &Y = state_b.X_BF[at->second];
      const double distance = (X.translation() - Y.translation()).norm();
      // The Frobenius norm |R - S| is 2 sqrt(2) sin(angle / 2).
      const double chord = (X.linear() - Y.linear()).norm() / (2.0 * std::sqrt(2.0));
      out.angle = std::max(out.angle, 2.0 * std::asin(std::min(1.0, chord)));
      if (distance <= out.position) continue;
      out.position = distance;
      out.frame = a.frames[i].name;
    }
  }
  return out;
}

}  // namespace abstand::robot_file
