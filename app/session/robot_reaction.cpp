#include "app/session/robot_reaction.hpp"

#include <algorithm>
#include <utility>

namespace abstand::session {

RobotReaction::RobotReaction(MechanismDriver& driver, const scene_file::MechanismDescription& description,
                             const control::ReactionDescription& reaction, const scene::Scene& scene,
                             const std::vector<bool>& people)
    : driver_(driver),
      reaction_(reaction, driver.dof(), scene.pairs().size(), mechanism::dofLimits(driver.mechanism())),
      pairs_(driver, scene, people, reaction),
      efforts_(static_cast<std::size_t>(driver.dof()), 0.0) {
  if (reaction.braking) braking_.emplace(driver, scene, pairs_.own(), *reaction.braking);
  if (const auto link = HeldLink::find(description, reaction))
    held_.emplace(driver, *link, scene, pairs_.own(), reaction_);
}

void RobotReaction::exchangeLaws(control::Reaction& next, const scene::Scene& scene) {
  const std::optional<control::BrakingLawOptions>& braking = next.description().braking;
  if (!braking)
    braking_.reset();
  else if (braking_)
    braking_->setOptions(*braking);
  else
    braking_.emplace(driver_, scene, pairs_.own(), *braking);
  pairs_.setReaction(next.description());
  reaction_.exchangeLaws(next);
}

void RobotReaction::placeHeld(double t, scene::Scene& scene) {
  if (held_) held_->place(t, scene);
}

std::span<const control::ReactionPair> RobotReaction::gather(const Cycle& cycle, const scene::Scene& scene) {
  input_ = {};
  input_.t = cycle.t;
  input_.dt = cycle.dt;
  input_.q = cycle.q;
  input_.qd = cycle.qd;
  input_.planned = cycle.planned;
  input_.pairs = pairs_.gather(scene, cycle.planned.empty() ? cycle.qd : cycle.planned);
  input_.person_age = cycle.person_age;
  input_.input_age = std::max(cycle.input_age, pairs_.oldest(scene, cycle.t));
  driver_.efforts(scene, efforts_);
  if (held_) {
    held_->addEfforts(efforts_);
    input_.held = &held_->update(scene);
  }
  if (const auto push = std::exchange(push_, std::nullopt)) {
    const Transform X_BW = driver_.X_WB().inverse();
    mechanism::addJointEfforts(driver_.mechanism(), driver_.state(), push->frame, X_BW * push->p_W,
                               {X_BW.linear() * push->f_W, Vector3d::Zero()}, efforts_);
  }
  input_.efforts = efforts_;
  cause_ = braking_ ? braking_->check(scene, cycle.q, cycle.qd) : std::nullopt;
  if (cause_) input_.causes = {&*cause_, 1};
  return input_.pairs;
}

control::ReactionOutput RobotReaction::update(const Eigen::Ref<const Eigen::MatrixXd>& M) noexcept {
  input_.reset = std::exchange(reset_, false);
  return reaction_.update(input_, M);
}

}  // namespace abstand::session
