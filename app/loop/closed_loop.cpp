#include "app/loop/closed_loop.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/mechanism/link_inertia.hpp"
#include "core/query/penalty_force.hpp"

namespace abstand::loop {

ClosedLoop::ClosedLoop(session::Session& session, double t, const Reactions& reactions)
    : session_(session), start_(t), t_(t) {
  const scene::Scene& scene = session.scene();
  const std::vector<bool> people = session::partsOfPeople(scene, session.humans());
  bodies_.resize(scene.objectCount());
  pushed_.resize(scene.objectCount());
  for (std::size_t m = 0; m < session.mechanisms().size(); ++m) {
    scene_file::MechanismDescription description = session.description().mechanisms[m];
    if (m < reactions.size() && reactions[m]) description.reaction = reactions[m];
    session::MechanismDriver& driver = *session.mechanisms()[m];
    still_.emplace_back(static_cast<std::size_t>(driver.dof()), 0.0);
    auto& robot = robots_.emplace_back();
    if (!description.reaction) continue;
    robot = std::make_unique<ReactingRobot>(driver, description, scene, people, world_, t);
    if (robot->positioned()) continue;
    for (const auto& link : driver.links()) {
      if (!link.object || link.frame < 0 || link.loose) continue;
      bodies_[link.object->index()] = {robot->number(), link.frame};
      pushed_[link.object->index()] = true;
    }
  }
  addThings();
}

void ClosedLoop::addThings() {
  scene::Scene& scene = session_.scene();
  for (const scene_file::ObjectDescription& d : session_.description().objects) {
    ObjectId id(0);
    const scene::Object* const object = scene.find(d.name, &id);
    if (!d.mass || session_.posed(id)) continue;
    const geometry::MassProperties& solid = object->spec.structure->mass_properties;
    if (!(solid.volume > 0.0))
      throw ParseError(d.pos, "found a `mass` for '" + d.name + "', whose mesh encloses no volume",
                       "a thing that moves needs a solid");
    const mechanism::LinkInertia body =
        mechanism::inertiaOfSolid(solid, *d.mass / solid.volume, Transform::Identity());
    const int number = world_.addFreeBody(body, d.X_WB);
    things_.push_back({id, number});
    bodies_[id.index()] = {-1, number};
    pushed_[id.index()] = true;
  }
}

void ClosedLoop::push(PairId id) {
  scene::Scene& scene = session_.scene();
  const scene::Pair& pair = scene.pairs()[id.index()];
  const std::size_t a = pair.a.index(), b = pair.b.index();
  if (!(pair.result.distance < 0.0) || !(pushed_[a] || pushed_[b])) return;
  const scene::Object &object_a = scene.object(pair.a), &object_b = scene.object(pair.b);
  const query::PairResult& r = pair.result;
  query::PenaltyForce bare{r.force_a, r.torque_a, r.torque_b, r.contacts, r.depth};
  if (pair.options.margin > 0.0) {
    query::PairOptions options = pair.options;
    options.margin = 0.0;
    bare = query::penaltyForce({*object_a.spec.structure, object_a.X_WB},
                               {*object_b.spec.structure, object_b.X_WB}, options, scratch_);
  }
  if (bare.contacts == 0) return;
  physics::Contact contact{
      bare.force_a, bare.torque_a, object_a.p_WCom(), 0.5 * (r.witness_a + r.witness_b), {}};
  // Bodies outside of the physics have the velocity of their poses.
  const auto carry = [&](const scene::Object& o, double sign) {
    contact.carried.linear +=
        sign * (o.velocity.linear + o.velocity.angular.cross(Vector3d(contact.near - o.p_WCom())));
    contact.carried.angular += sign * o.velocity.angular;
  };
  if (!pushed_[a]) carry(object_a, 1.0);
  if (!pushed_[b]) carry(object_b, -1.0);
  world_.applyContact(bodies_[a], bodies_[b], contact, contact_, kStep);
}

void ClosedLoop::move() {
  scene::Scene& scene = session_.scene();
  for (const auto& human : session_.humans()) human->interpolate(t_, scene);
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    if (robots_[m] && !byHand(m))
      robots_[m]->place(t_, scene);
    else
      session_.mechanisms()[m]->apply(t_, scene);
  }
  for (const Thing& thing : things_) scene.setPose(thing.object, world_.pose({-1, thing.number}), t_);
  session_.applyPoses(t_);
}

/// For a robot that is posed by hand: things that meet it meet a body at rest.
void ClosedLoop::standStill(std::size_t mechanism) {
  const ReactingRobot& robot = *robots_[mechanism];
  if (robot.positioned()) return;
  const session::MechanismDriver& driver = *session_.mechanisms()[mechanism];
  world_.mechanism(robot.number()).setState(driver.q(), still_[mechanism]);
}

void ClosedLoop::exchangeLaws(std::size_t mechanism, control::Reaction& next) {
  robots_.at(mechanism)->exchangeLaws(next, session_.scene());
}

void ClosedLoop::setPoke(const std::optional<Poke>& poke) {
  poked_.reset();
  if (!poke) return;
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    if (!robots_[m]) continue;
    for (const session::MechanismDriver::Link& link : session_.mechanisms()[m]->links())
      if (link.object == poke->object && link.frame >= 0 && !link.loose) poked_ = {*poke, m, link.frame};
  }
}

std::optional<Vector3d> ClosedLoop::pokedPoint() const {
  if (!poked_ || byHand(poked_->mechanism)) return std::nullopt;
  return session_.scene().object(poked_->poke.object).X_WB * poked_->poke.p_B;
}

void ClosedLoop::react(double age) {
  session_.sumEfforts();
  double person_age = 0.0;
  for (const auto& human : session_.humans()) person_age = std::max(person_age, human->recordedAge());
  const scene::Scene& scene = session_.scene();
  if (const auto p_W = pokedPoint())
    robots_[poked_->mechanism]->push({poked_->frame, *p_W, poked_->poke.force(*p_W)});
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    if (!robots_[m]) continue;
    if (byHand(m))
      standStill(m);
    else
      robots_[m]->react({t_, kStep, person_age, age}, scene);
  }
  for (const PairId id : scene.touching()) push(id);
  world_.step(kStep);
  for (std::size_t m = 0; m < robots_.size(); ++m)
    if (robots_[m] && !byHand(m)) robots_[m]->follow();
  // Computed from the start to avoid accumulated rounding.
  t_ = start_ + kStep * static_cast<double>(++cycles_);
}

void ClosedLoop::step() {
  move();
  session_.scene().step();
  react();
}

void ClosedLoop::refresh() {
  move();
  session_.scene().step();
  session_.sumEfforts();
}

void ClosedLoop::resetStops() {
  for (const auto& robot : robots_)
    if (robot) robot->reset();
}

void ClosedLoop::setTorques(bool on) {
  for (const auto& robot : robots_)
    if (robot) robot->setTorques(on);
}

void ClosedLoop::capture(view::SceneSnapshot& out) const {
  out.loop_start = start_;
  out.movers.poke = {};
  if (const auto p_W = pokedPoint())
    out.movers.poke = {static_cast<int>(poked_->poke.object.index()), *p_W, poked_->poke.force(*p_W)};
  std::size_t n = 0;
  for (const auto& robot : robots_) n += robot ? 1 : 0;
  out.robots.resize(n);
  n = 0;
  for (std::size_t m = 0; m < robots_.size(); ++m) {
    const ReactingRobot* const robot = robots_[m].get();
    if (!robot) continue;
    const safety::StopMachine& stops = robot->stops();
    view::RobotSnapshot& r = out.robots[n++];
    const bool by_hand = byHand(m);
    r.state = by_hand ? safety::StopState::kRunning : stops.state();
    r.cause = by_hand ? safety::StopCause() : stops.cause();
    r.since = stops.since();
    r.speed_scale = by_hand ? 1.0 : robot->speedScale();
    r.refused_resets = stops.refusedResets();
    r.refusal = stops.lastRefusal();
    r.log = stops.log();
    r.breach_count = robot->limits().copyBreaches(r.breaches);
  }
}

}  // namespace abstand::loop
