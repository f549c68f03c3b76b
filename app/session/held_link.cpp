#include "app/session/held_link.hpp"

#include "core/base/error.hpp"

namespace abstand::session {

std::optional<std::size_t> HeldLink::find(const scene_file::MechanismDescription& description,
                                          const control::ReactionDescription& reaction) {
  if (!reaction.proxy) return std::nullopt;
  for (std::size_t i = 0; i < description.links.size(); ++i)
    if (description.links[i].held) return i;
  throw UsageError("the law `proxy` for '" + description.name +
                   "': found nothing that it holds, expected one of its `links` with `held: true`");
}

HeldLink::HeldLink(MechanismDriver& driver, std::size_t link, const scene::Scene& scene,
                   std::span<const RobotPairs::Own> own, control::Reaction& reaction)
    : driver_(driver),
      reaction_(reaction),
      link_(link),
      frame_(driver.links()[link].frame),
      object_(driver.links()[link].object.value()) {
  const auto number = static_cast<int>(link);
  for (const RobotPairs::Own& pair : own)
    if (pair.link_a == number || pair.link_b == number) near_.push_back({pair.id, pair.link_a == number, {}});
  constraints_.reserve(near_.size() * (control::ContactManifold::kMax + 1));
  driver.setProxyControlled(link, true);
  reaction.hold(scene.object(object_).spec.structure->bounding_sphere, hand());
}

HeldLink::~HeldLink() { driver_.setProxyControlled(link_, false); }

Transform HeldLink::hand() const {
  const Transform X_BF =
      frame_ < 0 ? Transform::Identity() : driver_.state().X_BF[static_cast<std::size_t>(frame_)];
  return driver_.X_WB() * X_BF * driver_.links()[link_].X_FL;
}

void HeldLink::place(double t, scene::Scene& scene) {
  if (!started_) reaction_.proxy()->reset(hand());
  started_ = true;
  scene.setPose(object_, reaction_.proxy()->pose(), t);
}

const control::HeldObject& HeldLink::update(const scene::Scene& scene) {
  constraints_.clear();
  const Transform& X_WO = scene.object(object_).X_WB;
  for (Near& near : near_) {
    const scene::Pair& pair = scene.pairs()[near.id.index()];
    const Transform& X_WB = scene.object(near.held_is_a ? pair.b : pair.a).X_WB;
    near.contacts.update(pair.result, near.held_is_a, X_WO, X_WB);
    near.contacts.each(X_WO, X_WB, [&](const control::ContactConstraint& c) { constraints_.push_back(c); });
  }
  held_ = {hand(), constraints_};
  return held_;
}

void HeldLink::addEfforts(std::span<double> efforts) const {
  if (frame_ < 0) return;
  const Transform X_BW = driver_.X_WB().inverse();
  const Wrench w_B{X_BW.linear() * wrench().force, X_BW.linear() * wrench().torque};
  mechanism::addJointEfforts(driver_.mechanism(), driver_.state(), frame_, X_BW * point(), w_B, efforts);
}

}  // namespace abstand::session
