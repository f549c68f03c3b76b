#include "app/session/mechanism_driver.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/robot_file/robot.hpp"

namespace abstand::session {

MechanismDriver::MechanismDriver(const scene_file::MechanismDescription& description)
    : mechanism_(robot_file::loadRobot(description.file).mechanism),
      X_WB_(description.X_WB),
      limits_(mechanism::dofLimits(mechanism_)),
      home_(description.q) {
  const auto dof = static_cast<std::size_t>(mechanism_.dof);
  if (home_.empty()) home_.assign(dof, 0.0);
  if (home_.size() != dof)
    throw ParseError(description.pos, "found " + std::to_string(home_.size()) + " values in q of '" +
                                          description.name + "', expected " + std::to_string(dof) +
                                          ", one a degree of freedom");
  q_ = hand_ = home_;
  if (!description.motion.empty()) motion_ = mechanism::loadMotion(description.motion, mechanism_.dof);
  for (const auto& link : description.links) {
    const int frame = mechanism_.indexOf(link.frame);
    if (frame < 0 && link.frame != "0")
      throw ParseError(link.pos, "found frame '" + link.frame + "' of link '" + link.name +
                                     "', expected a frame of " + description.file.string());
    links_.push_back({frame, link.X_FL, std::nullopt});
  }
  mechanism::forward(mechanism_, q_, state_);
}

/// The frame whose joint moves `frame`; -1: none.
int MechanismDriver::rigidBody(int frame) const {
  while (frame >= 0 && mechanism_.frames[static_cast<std::size_t>(frame)].dof < 0)
    frame = mechanism_.frames[static_cast<std::size_t>(frame)].parent;
  return frame;
}

std::vector<std::pair<std::size_t, std::size_t>> MechanismDriver::adjacentLinks() const {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto carriesLink = [&](int frame) {
    return std::any_of(links_.begin(), links_.end(), [&](const Link& l) { return l.frame == frame; });
  };
  for (std::size_t i = 0; i < links_.size(); ++i) {
    // The nearest frame towards the base that carries a link.
    int up = links_[i].frame;
    while (up >= 0) {
      up = mechanism_.frames[static_cast<std::size_t>(up)].parent;
      if (carriesLink(up)) break;
    }
    for (std::size_t j = 0; j < links_.size(); ++j) {
      if (i == j) continue;
      const bool same_body = i < j && rigidBody(links_[i].frame) == rigidBody(links_[j].frame);
      if (same_body || (links_[i].frame >= 0 && links_[j].frame == up && links_[j].frame != links_[i].frame))
        pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

void MechanismDriver::apply(double t, scene::Scene& scene) {
  if (by_hand_)
    std::copy(hand_.begin(), hand_.end(), q_.begin());
  else if (motion_)
    motion_->at(t, q_);
  else
    std::copy(home_.begin(), home_.end(), q_.begin());
  place(t, scene);
}

bool MechanismDriver::poseByHand(int joint, double value) noexcept {
  if (joint < 0 || joint >= dof() || !std::isfinite(value)) return false;
  if (!by_hand_) std::copy(q_.begin(), q_.end(), hand_.begin());
  by_hand_ = true;
  const auto i = static_cast<std::size_t>(joint);
  hand_[i] = std::clamp(value, limits_[i].lower, std::max(limits_[i].lower, limits_[i].upper));
  return true;
}

void MechanismDriver::moveTo(std::span<const double> q, double t, scene::Scene& scene) {
  ABSTAND_CHECK(q.size() == q_.size());
  std::copy(q.begin(), q.end(), q_.begin());
  place(t, scene);
}

void MechanismDriver::markStale(double t, scene::Scene& scene) const {
  for (const Link& link : links_)
    if (link.object)
      scene.setPose(*link.object, scene.object(*link.object).X_WB, t, scene::PoseState::kStale);
}

void MechanismDriver::place(double t, scene::Scene& scene) {
  mechanism::forward(mechanism_, q_, state_);
  for (const Link& link : links_) {
    if (!link.object || link.loose) continue;
    const Transform X_WF = link.frame < 0 ? X_WB_ : X_WB_ * state_.X_BF[static_cast<std::size_t>(link.frame)];
    scene.setPose(*link.object, X_WF * link.X_FL, t);
  }
}

void MechanismDriver::efforts(const scene::Scene& scene, std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  const Transform X_BW = X_WB_.inverse();
  for (const Link& link : links_) {
    if (!link.object || link.frame < 0 || link.loose) continue;
    const scene::Object& object = scene.object(*link.object);
    if (!object.colliding) continue;
    const Wrench w_B{X_BW.linear() * object.contact.force, X_BW.linear() * object.contact.torque};
    mechanism::addJointEfforts(mechanism_, state_, link.frame, X_BW * object.p_WCom(), w_B, out);
  }
}

void MechanismDriver::axes(std::span<mechanism::JointAxis> out) const {
  if (state_.X_BF.size() != mechanism_.frames.size()) return;  // not posed so far
  mechanism::jointAxes(mechanism_, state_, out);
  for (mechanism::JointAxis& axis : out) {
    axis.p = X_WB_ * axis.p;
    axis.direction = X_WB_.linear() * axis.direction;
  }
}

}  // namespace abstand::session
