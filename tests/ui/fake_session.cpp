// A session that is only made up.
#include "tests/ui/fake_session.hpp"
#include "core/math/turn_between.hpp"
#include "core/view/plot_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/ui/simple_meshes.hpp"

namespace abstand::ui {

namespace {

constexpr double kEnd = 12.0;          // s
constexpr double kPeriod = 0.02;       // s
constexpr double kStiffness = 2500.0;  // N/m
constexpr int kLinks = 5;
const Vector3d kLinkHalf(0.07, 0.07, 0.19);
const Vector3d kPersonAt(1.05, 0.1, 0.0);

struct Part {
  const char* name;
  Vector3d centre, half;
  double exponent;
};

const Part kParts[] = {{"torso", {0, 0, 1.18}, {0.13, 0.19, 0.31}, 0.7},
                       {"head", {0, 0, 1.66}, {0.09, 0.08, 0.12}, 1.0},
                       {"biceps_left", {0, 0.25, 1.28}, {0.05, 0.05, 0.16}, 0.9},
                       {"biceps_right", {0, -0.25, 1.28}, {0.05, 0.05, 0.16}, 0.9},
                       {"forearm_left", {0, 0, 0}, {0.04, 0.04, 0.15}, 0.9},
                       {"forearm_right", {0, 0, 0}, {0.04, 0.04, 0.15}, 0.9},
                       {"hand_left", {0, 0, 0}, {0.025, 0.045, 0.09}, 0.8},
                       {"hand_right", {0, 0, 0}, {0.025, 0.045, 0.09}, 0.8},
                       {"thigh_left", {0, 0.1, 0.66}, {0.08, 0.08, 0.23}, 0.9},
                       {"thigh_right", {0, -0.1, 0.66}, {0.08, 0.08, 0.23}, 0.9},
                       {"calf_left", {0, 0.1, 0.25}, {0.055, 0.055, 0.21}, 0.9},
                       {"calf_right", {0, -0.1, 0.25}, {0.055, 0.055, 0.21}, 0.9},
                       {"foot_left", {-0.06, 0.1, 0.04}, {0.13, 0.045, 0.04}, 0.7},
                       {"foot_right", {-0.06, -0.1, 0.04}, {0.13, 0.045, 0.04}, 0.7}};

Transform along(const Vector3d& from, const Vector3d& direction, double offset) {
  Transform X = Transform::Identity();
  X.linear() = turnBetween(Vector3d::UnitZ(), direction.normalized()).toRotationMatrix();
  X.translation() = from + offset * direction.normalized();
  return X;
}

std::string line(const char* command, double value) {
  std::ostringstream text;
  text << command << ' ' << value;
  return text.str();
}

}  // namespace

FakeSession::FakeSession() {
  outline_.title = "made-up";
  outline_.end = kEnd;
  outline_.frame_period = kPeriod;
  addRobot();
  addPerson();
  addThings();
  const auto n = static_cast<int>(outline_.objects.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      if (outline_.objects[static_cast<std::size_t>(a)].group !=
          outline_.objects[static_cast<std::size_t>(b)].group)
        outline_.pairs.emplace_back(a, b);
  for (int j = 0; j < kLinks; ++j)
    outline_.joints.push_back({"arm", "joint" + std::to_string(j + 1), false, -kPi, kPi, 60.0});
  outline_.robots.push_back({"arm", "/cell/arm.urdf", "/cell/arm.csv", Transform::Identity(), 0, kLinks});
  outline_.people.push_back({"operator", 1.78, 80.0, "m", std::nullopt, "/cell/walk.bvh"});
  for (std::size_t i = 0; i < outline_.objects.size(); ++i)
    outline_.bodies.push_back({Vector3d::Constant(2.0 * radii_[i]), 1234, 0.005, 0.004, 0.0031});
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      const auto& info = outline_.objects[static_cast<std::size_t>(a)];
      if (info.group != outline_.objects[static_cast<std::size_t>(b)].group) continue;
      outline_.unchecked.push_back({a, b,
                                    info.human                          ? view::UncheckedReason::kOnePerson
                                    : info.group == "arm" && b == a + 1 ? view::UncheckedReason::kAdjacent
                                                                        : view::UncheckedReason::kOneGroup});
    }
  snapshot_.movers.by_hand = {false};
  snapshot_.movers.person_age = {0.0};
  outline_.reacting = {"arm"};
  outline_.reactions.resize(1);
  outline_.reactions[0].torque.emplace();
  snapshot_.robots.resize(1);
  snapshot_.loop_start = 0.0;
  snapshot_.objects.resize(outline_.objects.size());
  for (std::size_t i = 0; i < snapshot_.objects.size(); ++i)
    snapshot_.objects[i].margin = outline_.objects[i].human ? 0.04 : 0.01;
  snapshot_.pairs.resize(outline_.pairs.size());
  snapshot_.joint_positions.resize(outline_.joints.size());
  snapshot_.joint_efforts.resize(outline_.joints.size());
  snapshot_.joint_torques.resize(outline_.joints.size());
  snapshot_.movers.joint_axes.resize(outline_.joints.size());
  // Pairs with the person, and the others.
  outline_.pair_groups = {"people", "things"};
  for (const auto& [a, b] : outline_.pairs)
    snapshot_.pair_group.push_back(outline_.objects[static_cast<std::size_t>(a)].human ||
                                           outline_.objects[static_cast<std::size_t>(b)].human
                                       ? 0
                                       : 1);
  snapshot_.groups.resize(2);
  group();
  compute(0.0);
}

int FakeSession::addObject(const std::string& name, const std::string& group, bool human,
                           geometry::TriangleMesh mesh, double radius) {
  outline_.objects.push_back({name, group, human, true});
  outline_.meshes.push_back(std::move(mesh));
  radii_.push_back(radius);
  return static_cast<int>(outline_.objects.size()) - 1;
}

void FakeSession::addRobot() {
  for (int k = 0; k < kLinks; ++k)
    addObject("arm/link" + std::to_string(k), "arm", false, roundedBody(kLinkHalf, 0.55), 0.09);
}

void FakeSession::addPerson() {
  for (const Part& part : kParts)
    addObject(std::string("operator/") + part.name, "operator", true, roundedBody(part.half, part.exponent),
              part.half.head<2>().maxCoeff());
}

void FakeSession::addThings() {
  addObject("table", "objects", false, box({0.35, 0.6, 0.03}), 0.03);
  addObject("ball", "objects", false, roundedBody(Vector3d::Constant(0.07), 1.0), 0.07);
}

void FakeSession::place(double t) {
  std::size_t i = 0;
  Vector3d at(0.0, 0.0, 0.0);
  for (int k = 0; k < kLinks; ++k, ++i) {
    const auto joint = static_cast<std::size_t>(k);
    const double bend = !hand_.empty() ? hand_[joint]
                        : k == 0       ? 0.0
                                       : 0.25 + 0.42 * k * (0.55 + 0.35 * std::sin(0.9 * t));
    const double yaw = 0.5 * std::sin(0.5 * t);
    const Vector3d direction(std::sin(bend) * std::cos(yaw), std::sin(bend) * std::sin(yaw), std::cos(bend));
    snapshot_.objects[i].X_WB = along(at, direction, kLinkHalf.z());
    snapshot_.movers.joint_axes[joint] = {at, Vector3d(-std::sin(yaw), std::cos(yaw), 0.0), false};
    at += 2.0 * kLinkHalf.z() * 0.95 * direction;
    snapshot_.joint_positions[static_cast<std::size_t>(k)] = bend;
  }
  const double reach = 0.5 - 0.5 * std::cos(1.1 * t);
  for (std::size_t p = 0; p < std::size(kParts); ++p, ++i) {
    Transform X = Transform::Identity();
    X.translation() = kPersonAt + kParts[p].centre;
    const bool left = p % 2 == 0;
    const Vector3d elbow = kPersonAt + Vector3d(-0.03, left ? 0.27 : -0.27, 1.12);
    const Vector3d forearm(-(left ? reach : 0.25), left ? -0.45 * reach : 0.0,
                           left ? -0.85 + 0.9 * reach : -1.0);
    if (p == 4 || p == 5) X = along(elbow, forearm, 0.15);
    if (p == 6 || p == 7) X = along(elbow, forearm, 0.37);
    snapshot_.objects[i].X_WB = X;
  }
  snapshot_.objects[i++].X_WB = Transform(Eigen::Translation3d(0.55, -0.75, 0.72));
  snapshot_.objects[i].X_WB = Transform(Eigen::Translation3d(0.5, -0.6 + 0.1 * std::sin(2.0 * t), 0.83));
}

void FakeSession::relate() {
  for (view::ObjectSnapshot& object : snapshot_.objects) {
    object.contact = {};
    object.colliding = false;
  }
  snapshot_.nearest_pair = -1;
  double nearest = kInfinity, force = 0.0;
  for (std::size_t p = 0; p < outline_.pairs.size(); ++p) {
    const auto a = static_cast<std::size_t>(outline_.pairs[p].first);
    const auto b = static_cast<std::size_t>(outline_.pairs[p].second);
    view::ObjectSnapshot &one = snapshot_.objects[a], &other = snapshot_.objects[b];
    view::PairSnapshot& pair = snapshot_.pairs[p];
    const Vector3d between = other.p_WCom - one.p_WCom;
    const Vector3d n = between.normalized();
    pair.margin = one.margin + other.margin;
    const int of = snapshot_.pair_group[p];
    pair.paused =
        of < 0 || snapshot_.groups[static_cast<std::size_t>(of)].state != view::PairGroupState::kRunning;
    if (pair.paused) continue;
    query::PairResult& result = pair.result;
    result.distance = between.norm() - radii_[a] - radii_[b];
    result.bound = 0.0015;
    result.witness_a = one.p_WCom + radii_[a] * n;
    result.witness_b = other.p_WCom - radii_[b] * n;
    result.depth = std::max(0.0, pair.margin - result.distance);
    result.contacts = static_cast<int>(std::ceil(result.depth * 1000.0));
    result.force_a = -kStiffness * result.depth * n;
    result.torque_a = 0.4 * radii_[a] * Vector3d::UnitZ().cross(result.force_a);
    result.torque_b = -result.torque_a;
    one.contact += Wrench{result.force_a, result.torque_a};
    other.contact += Wrench{-result.force_a, result.torque_b};
    one.colliding |= result.contacts > 0;
    other.colliding |= result.contacts > 0;
    force = std::max(force, result.force_a.norm());
    if (result.distance < nearest) {
      nearest = result.distance;
      snapshot_.nearest_pair = static_cast<int>(p);
    }
  }
  view::TorqueParts peak{0.0, 0.0, 0.0, 0.0};
  for (std::size_t j = 0; j < snapshot_.joint_efforts.size(); ++j) {
    snapshot_.joint_efforts[j] = 0.1 * force * static_cast<double>(snapshot_.joint_efforts.size() - j);
    const double share = static_cast<double>(j + 1);
    snapshot_.joint_torques[j] = {snapshot_.joint_efforts[j], snapshot_.torques_on ? -2.0 * share : 0.0,
                                  -3.0 * share, 0.5 * share};
    peak = {std::max(peak.contact, snapshot_.joint_efforts[j]), snapshot_.torques_on ? 2.0 * share : 0.0,
            3.0 * share, 0.5 * share};
  }
  view::PlotSample sample{.t = snapshot_.t,
                          .peak_torque = peak,
                          .cycle_s = 1e-6 * snapshot_.cycle_us,
                          .step_s = snapshot_.step_s,
                          .played = snapshot_.playing,
                          .margin_edits = margin_edits_};
  view::fillSample(outline_, snapshot_, sample);
  samples_.push_back(sample);
}

void FakeSession::group() {
  for (view::PairGroupSnapshot& group : snapshot_.groups) group.pairs = 0;
  for (const int of : snapshot_.pair_group)
    if (of >= 0) ++snapshot_.groups[static_cast<std::size_t>(of)].pairs;
}

void FakeSession::setTorques(bool on) {
  log.push_back(on ? "torques on" : "torques off");
  snapshot_.torques_on = on;
  compute(snapshot_.t);
}

void FakeSession::setGroup(int group, view::PairGroupState state) {
  constexpr const char* kStates[]{"run", "pause", "stop"};
  log.push_back(kStates[static_cast<std::size_t>(state)] + (" " + std::to_string(group)));
  snapshot_.groups[static_cast<std::size_t>(group)].state = state;
  compute(snapshot_.t);
}

void FakeSession::addPair(int group, int pair) {
  log.push_back("add " + std::to_string(group) + " " + std::to_string(pair));
  snapshot_.pair_group[static_cast<std::size_t>(pair)] = group;
  this->group();
  compute(snapshot_.t);
}

void FakeSession::removePair(int pair) {
  log.push_back("remove " + std::to_string(pair));
  snapshot_.pair_group[static_cast<std::size_t>(pair)] = -1;
  group();
  compute(snapshot_.t);
}

void FakeSession::poseJoint(int joint, double value) {
  log.push_back(line(("pose " + std::to_string(joint)).c_str(), value));
  if (hand_.empty()) hand_ = snapshot_.joint_positions;
  hand_[static_cast<std::size_t>(joint)] = value;
  snapshot_.movers.by_hand[0] = true;
  compute(snapshot_.t);
}

void FakeSession::followMotion(int robot) {
  log.push_back("follow " + std::to_string(robot));
  hand_.clear();
  snapshot_.movers.by_hand[0] = false;
  compute(snapshot_.t);
}

void FakeSession::setReaction(int robot, const control::ReactionDescription& reaction) {
  log.push_back("reaction " + std::to_string(robot));
  reactions.push_back(reaction);
}

void FakeSession::poke(int object, const Vector3d& p_B, const Vector3d& target_W) {
  log.push_back("poke " + std::to_string(object));
  const auto i = static_cast<std::size_t>(object);
  const Vector3d p_W = snapshot_.objects[i].X_WB * p_B;
  snapshot_.movers.poke = {object, p_W, 400.0 * (target_W - p_W)};
  fresh_ = true;
}

void FakeSession::endPoke() {
  log.push_back("end poke");
  snapshot_.movers.poke = {};
  fresh_ = true;
}

void FakeSession::compute(double t) {
  // Velocities from the pose a moment before.
  place(t - 1e-3);
  std::vector<Vector3d> before;
  for (const view::ObjectSnapshot& object : snapshot_.objects) before.push_back(object.X_WB.translation());
  place(t);
  for (std::size_t i = 0; i < before.size(); ++i) {
    view::ObjectSnapshot& object = snapshot_.objects[i];
    object.p_WCom = object.X_WB.translation();
    object.velocity.linear = (object.p_WCom - before[i]) / 1e-3;
  }
  snapshot_.t = t;
  ++snapshot_.step;
  snapshot_.cycle_us = snapshot_.cycle_median_us = 64.0;
  snapshot_.cycle_p99_us = 121.0;
  snapshot_.real_time_factor = snapshot_.playing ? speed : kNaN;
  relate();
  fresh_ = true;
}

void FakeSession::advance(double seconds) {
  if (!snapshot_.playing) return;
  for (double left = seconds * speed; left > 1e-9 && snapshot_.playing; left -= kPeriod) {
    double t = snapshot_.t + kPeriod;
    if (t > kEnd + 1e-9) {
      if (loop)
        t = 0.0;
      else {
        play(false);
        return;
      }
    }
    compute(t);
  }
}

bool FakeSession::takeSnapshot(view::SceneSnapshot& out) {
  if (!fresh_) return false;
  out = snapshot_;
  fresh_ = false;
  return true;
}

void FakeSession::drainPlot(std::vector<view::PlotSample>& out) {
  out.insert(out.end(), samples_.begin(), samples_.end());
  samples_.clear();
}

void FakeSession::play(bool on) {
  log.push_back(on ? "play" : "pause");
  snapshot_.playing = on;
  fresh_ = true;
}

void FakeSession::step(int frames) {
  log.push_back(line("step", frames));
  snapshot_.playing = false;
  const double frame = std::round(snapshot_.t / kPeriod) + frames;
  compute(std::clamp(frame * kPeriod, 0.0, kEnd));
}

void FakeSession::seek(double t) {
  log.push_back(line("seek", t));
  compute(std::clamp(t, 0.0, kEnd));
}

void FakeSession::setReact(bool on) {
  log.push_back(on ? "react on" : "react off");
  snapshot_.robots.resize(on ? 1 : 0);
  fresh_ = true;
}

void FakeSession::resetStops() { log.push_back("reset stops"); }

void FakeSession::setMargin(int object, double metres) {
  log.push_back(line(("margin " + std::to_string(object)).c_str(), metres));
  snapshot_.objects[static_cast<std::size_t>(object)].margin = metres;
  ++margin_edits_;
  compute(snapshot_.t);
}

void FakeSession::setClassMargin(view::PairClass pair_class, std::optional<double> metres) {
  log.push_back(
      line(("class margin " + std::to_string(static_cast<int>(pair_class))).c_str(), metres.value_or(-1.0)));
  fresh_ = true;
}

void FakeSession::placeThing(int object, const std::optional<Transform>& X_WB) {
  log.push_back(line(("place " + std::to_string(object)).c_str(), X_WB ? X_WB->translation().x() : kNaN));
  if (X_WB) snapshot_.objects[static_cast<std::size_t>(object)].X_WB = *X_WB;
  fresh_ = true;
}

void FakeSession::setPoseUncertainty(int object, double metres) {
  snapshot_.objects[static_cast<std::size_t>(object)].pose_uncertainty = metres;
  fresh_ = true;
}

void FakeSession::setPoseState(int object, scene::PoseState state) {
  snapshot_.objects[static_cast<std::size_t>(object)].pose_state = state;
  fresh_ = true;
}

void FakeSession::setWork(const scene::StepCounts& work) {
  snapshot_.work = work;
  fresh_ = true;
}

int FakeSession::indexOf(const std::string& name) const {
  for (std::size_t i = 0; i < outline_.objects.size(); ++i)
    if (outline_.objects[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace abstand::ui
