#include "app/serve/served_scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/directed_uncertainty.hpp"
#include "humanmodel/part_uncertainty.hpp"

namespace abstand::serve {

control::ReactionDescription usualReaction() {
  control::ReactionDescription reaction;
  reaction.torque.emplace();
  reaction.speed.emplace();
  return reaction;
}

ServedScene::ServedScene(std::unique_ptr<session::Session> session, const ServedOptions& options)
    : session_(std::move(session)), control_(*session_), watch_(options.reaction.watch) {
  const scene_file::SceneDescription& d = session_->description();
  scene::Scene& scene = session_->scene();
  session_->step(0.0);
  std::vector<int> robot_of(scene.objectCount(), -1), person_of(scene.objectCount(), -1);
  for (std::size_t m = 0; m < d.mechanisms.size(); ++m) {
    const session::MechanismDriver& driver = *session_->mechanisms()[m];
    format_.mechanisms.push_back({d.mechanisms[m].name, static_cast<std::size_t>(driver.dof())});
    for (const auto& link : driver.links()) {
      links_.push_back(*link.object);
      robot_of[link.object->index()] = static_cast<int>(m);
    }
    driver.markStale(0.0, scene);
  }
  for (std::size_t p = 0; p < d.humans.size(); ++p) {
    const session::HumanDriver& driver = *session_->humans()[p];
    format_.people.push_back(d.humans[p].name);
    for (const session::HumanDriver::Body& body : driver.bodies())
      person_of[body.object.index()] = static_cast<int>(p);
    driver.markStale(0.0, scene);
  }
  for (const ObjectId id : links_) names_.links.push_back(scene.object(id).spec.name);
  for (const scene::Object& o : scene.objects()) names_.objects.push_back(o.spec.name);
  format_.objects = names_.objects;
  for (const session::PairGroup& group : session_->pairGroups()) format_.groups.push_back(group.name);

  std::vector<bool> people(scene.objectCount());
  for (std::size_t i = 0; i < people.size(); ++i) people[i] = person_of[i] >= 0;
  bool offsets = false;
  for (std::size_t m = 0; m < d.mechanisms.size(); ++m) {
    control::ReactionDescription reaction = options.reaction;
    if (options.scene_first && d.mechanisms[m].reaction) {
      reaction = *d.mechanisms[m].reaction;
      reaction.watch.input_age = watch_.input_age;
      reaction.watch.person_age = watch_.person_age;
      if (std::isfinite(options.reaction.stop.resume_after))
        reaction.stop.resume_after = options.reaction.stop.resume_after;
    }
    offsets = offsets || reaction.admittance;
    const std::string remark =
        session::massRemark(d.mechanisms[m].name, session_->mechanisms()[m]->mechanism(), reaction);
    if (!remark.empty()) remarks_.push_back(remark);
    robots_.push_back(std::make_unique<ServedRobot>(
        *session_->mechanisms()[m], session_->description().mechanisms[m], scene, people, reaction));
  }
  people_.resize(d.humans.size());

  for (const scene::Pair& pair : scene.pairs()) {
    const auto a = pair.a.index(), b = pair.b.index();
    const int robot = std::max(robot_of[a], robot_of[b]), person = std::max(person_of[a], person_of[b]);
    separation_of_.push_back(robot < 0 || person < 0 ? -1
                                                     : person * static_cast<int>(robots_.size()) + robot);
  }
  const std::size_t separations = people_.size() * robots_.size();
  separations_.resize(separations);
  nearest_.assign(std::min(options.nearest, scene.pairs().size()), {kInfinity, PairId(0)});

  report_.person_age.assign(people_.size(), kInfinity);
  report_.robots.resize(robots_.size());
  report_.torque.assign(format_.dof(), 0.0);
  report_.offset.assign(offsets ? format_.dof() : 0, 0.0);
  report_.links.resize(links_.size());
  report_.separation.resize(separations);
  report_.nearest.resize(options.nearest);
}

void ServedScene::take(const Packet& packet, double t) {
  if (packet.type == PacketType::kSkeleton) {
    Person& person = people_[packet.index];
    humanmodel::SkeletonFrame frame = packet.skeleton;
    frame.t = t;
    // A joint marked as inferred by the sender's tracker without a spread.
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (frame.state[j] == humanmodel::JointState::kInferred && frame.spread[j] == 0.0)
        frame.spread[j] = humanmodel::kGuessedSpread;
    session_->humans()[packet.index]->follow(frame, session_->scene());
    person.last_t = t;
    person.stale = false;
    return;
  }
  const double stamp = 1e-6 * static_cast<double>(packet.time_us);
  std::size_t first = 0;
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    if (packet.index != m && packet.index != kAllMechanisms) continue;
    ServedRobot& robot = *robots_[m];
    robot.moveTo(std::span(packet.q).subspan(first, robot.dof()), t, stamp, session_->scene());
    if (packet.reset) robot.reset();
    first += robot.dof();
  }
}

session::PairControl::Outcome ServedScene::handle(const Control& control, double t) {
  const auto to = [&](view::PairGroupState state) {
    if (control.group != kAllGroups) return control_.setState(static_cast<int>(control.group), state, t);
    control_.setAll(state, t);
    return session::PairControl::Outcome::kDone;
  };
  const auto torques = [&](bool on) {
    for (const auto& robot : robots_) robot->setTorques(on);
    report_.torques_on = on;
    return session::PairControl::Outcome::kDone;
  };
  const auto pair = control_.findPair(static_cast<int>(control.a), static_cast<int>(control.b));
  switch (control.order) {
    case ControlOrder::kReport:
      return session::PairControl::Outcome::kDone;
    case ControlOrder::kRun:
      return to(view::PairGroupState::kRunning);
    case ControlOrder::kPause:
      return to(view::PairGroupState::kPaused);
    case ControlOrder::kStop:
      return to(view::PairGroupState::kStopped);
    case ControlOrder::kAdd:
      return control_.add(static_cast<int>(control.group), pair, t);
    case ControlOrder::kRemove:
      return control_.remove(pair, t);
    case ControlOrder::kTorquesOn:
      return torques(true);
    case ControlOrder::kTorquesOff:
      return torques(false);
  }
  return session::PairControl::Outcome::kDone;
}

void ServedScene::growPeople(double t) {
  for (std::size_t p = 0; p < people_.size(); ++p) {
    const session::HumanDriver& driver = *session_->humans()[p];
    report_.person_age[p] = driver.liveAge(t);
    driver.growUncertainty(t, session_->scene());
    if (people_[p].stale || t - people_[p].last_t <= watch_.person_age) continue;
    driver.markStale(t, session_->scene());
    people_[p].stale = true;
  }
}

double ServedScene::nextStale() const {
  double next = kInfinity;
  for (const Person& p : people_)
    if (!p.stale) next = std::min(next, p.last_t + watch_.person_age);
  for (const auto& robot : robots_) {
    // Ages at time 0 are the negative times of the last input; stale input is skipped.
    if (!robot->stale()) next = std::min(next, watch_.input_age - robot->age(0.0));
  }
  return next;
}

void ServedScene::cycle(double t) {
  scene::Scene& scene = session_->scene();
  growPeople(t);
  for (const auto& robot : robots_) {
    robot->grow(t, watch_.input_age, scene);
    robot->placeHeld(t, scene);
  }
  scene.step();
  double person_age = 0.0;
  for (const double age : report_.person_age) person_age = std::max(person_age, age);
  std::size_t first = 0;
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    const std::size_t n = robots_[m]->dof();
    const auto own = [&](std::vector<double>& all) {
      return all.empty() ? std::span<double>() : std::span(all).subspan(first, n);
    };
    robots_[m]->react(t, person_age, scene, report_.robots[m], own(report_.torque), own(report_.offset));
    first += n;
  }
  reportLinks();
  reportPairs();
  report_.not_checked = static_cast<std::uint32_t>(scene.pausedCount());
  report_.time_us = static_cast<std::uint64_t>(1e6 * t);
  t_ = t;
}

void ServedScene::capture(view::SceneSnapshot& out) {
  session_->sumEfforts();
  session_->capture(t_, out);
  control_.capture(out);
  out.movers.person_age = report_.person_age;
  out.torques_on = report_.torques_on;
  out.cycle_us = report_.cycle_us;
  for (std::size_t i = 0; i < out.joint_torques.size(); ++i) {
    out.joint_torques[i].contact = session_->jointEfforts()[i];
    out.joint_torques[i].reaction = report_.torque[i];
  }
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    const RobotReport& robot = report_.robots[m];
    view::RobotSnapshot& shown = out.robots[m];
    shown.state = robot.state;
    shown.since = robot.since;
    shown.speed_scale = robot.speed_scale;
    shown.cause = robots_[m]->cause();
  }
}

void ServedScene::reportLinks() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const scene::Object& o = session_->scene().object(links_[i]);
    report_.links[i] = o.colliding ? o.contact : Wrench{};
  }
}

Trust ServedScene::trustOf(ObjectId id) const {
  switch (session_->scene().object(id).pose_state) {
    case scene::PoseState::kFresh:
      return Trust::kFresh;
    case scene::PoseState::kInferred:
      return Trust::kInferred;
    case scene::PoseState::kStale:
    case scene::PoseState::kRejected:
      return Trust::kNone;
  }
  return Trust::kNone;
}

Trust ServedScene::trustOf(const scene::Pair& pair) const {
  return pair.paused ? Trust::kNone : std::min(trustOf(pair.a), trustOf(pair.b));
}

PairReport ServedScene::reportOf(PairId id) const {
  const scene::Pair& pair = session_->scene().pairs()[id.index()];
  PairReport out;
  out.a = static_cast<int>(pair.a.index());
  out.b = static_cast<int>(pair.b.index());
  out.trust = trustOf(pair);
  out.witness_a = pair.result.witness_a;
  out.witness_b = pair.result.witness_b;
  if (out.trust == Trust::kNone || std::isnan(pair.result.distance)) return out;
  out.distance = pair.result.distance;
  out.bound = pair.result.bound + scene::directedUncertainty(session_->scene(), id, pair.result);
  return out;
}

/// Keeps nearest_ sorted; equal ones in scene order.
void ServedScene::addNearest(PairId id, double distance) {
  const std::pair<double, PairId> entry{distance, id};
  if (nearest_.empty() || (nearest_count_ == nearest_.size() && !(entry < nearest_.back()))) return;
  if (nearest_count_ < nearest_.size()) ++nearest_count_;
  const auto end = nearest_.begin() + static_cast<std::ptrdiff_t>(nearest_count_);
  const auto place = std::upper_bound(nearest_.begin(), end - 1, entry);
  std::move_backward(place, end - 1, end);
  *place = entry;
}

void ServedScene::reportPairs() {
  const scene::Scene& scene = session_->scene();
  std::fill(separations_.begin(), separations_.end(), Separation{});
  nearest_count_ = 0;
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) {
    const double distance = scene.pairs()[i].result.distance;
    const double rank = std::isnan(distance) ? -kInfinity : distance;
    addNearest(PairId(i), rank);
    const int s = separation_of_[i];
    if (s < 0) continue;
    // Unproven pairs come first: an unknown part may be anywhere.
    const bool known = trustOf(scene.pairs()[i]) != Trust::kNone;
    Separation& least = separations_[static_cast<std::size_t>(s)];
    const double found = known ? rank : -kInfinity;
    const query::PairResult& result = scene.pairs()[i].result;
    const double doubt = result.bound + scene::directedUncertainty(scene, PairId(i), result);
    least.proven = std::min(least.proven, known ? rank - doubt : -kInfinity);
    if (!(found < least.found)) continue;
    least.found = found;
    least.pair = PairId(i);
  }
  for (std::size_t s = 0; s < separations_.size(); ++s) {
    const Separation& least = separations_[s];
    PairReport& out = report_.separation[s];
    out = least.found < kInfinity ? reportOf(least.pair) : PairReport{};
    if (out.trust != Trust::kNone) out.bound = out.distance - least.proven;
  }
  for (std::size_t i = 0; i < report_.nearest.size(); ++i)
    report_.nearest[i] = i < nearest_count_ ? reportOf(nearest_[i].second) : PairReport{};
}

}  // namespace abstand::serve
