#include "app/tune/approach.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/allowed_speed.hpp"
#include "humanmodel/held_tool.hpp"

namespace abstand::tune {
namespace {

// m: nearer points define no direction.
constexpr double kNoDirection = 1e-9;

}  // namespace

ApproachJudge::ApproachJudge(const session::Session& session,
                             std::shared_ptr<const contact::ContactLimits> limits,
                             std::vector<std::string> clamped)
    : session_(session), limits_(std::move(limits)), clamped_(std::move(clamped)) {
  for (const auto& human : session.humans())
    for (const session::HumanDriver::Body& body : human->bodies()) {
      const geometry::Bounds bounds = session.scene().object(body.object).spec.structure->surface->bounds();
      radius_of_[body.object.index()] =
          std::min(humanmodel::bareRadius(human->model().part(body.part)), 0.5 * bounds.extent().minCoeff());
    }
  std::size_t first = 0;
  for (const auto& m : session.mechanisms()) {
    const auto dof = static_cast<std::size_t>(m->dof());
    robots_.push_back({session::RobotMass(m->mechanism()), first, dof});
    first += dof;
    for (const auto& link : m->links())
      if (link.object) frame_of_[link.object->index()] = link.frame;
  }
}

ClosingMotion ApproachJudge::motion(const WindowFrame& frame, const WatchedPair& pair, std::size_t i) {
  ClosingMotion motion;
  motion.p_W = frame.on_link[i];
  const Vector3d between = frame.on_part[i] - frame.on_link[i];
  const double length = between.norm();
  // For overlapping bodies the order of the nearest points is reversed.
  if (length > kNoDirection) motion.n_W = between / (frame.distance[i] < 0.0 ? -length : length);
  if (!frame.motion.empty()) {
    motion.robot_speed = frame.motion[pair.link].velocityAt(frame.on_link[i]).dot(motion.n_W);
    motion.person_speed = -frame.motion[pair.part].velocityAt(frame.on_part[i]).dot(motion.n_W);
  }
  return motion;
}

void ApproachJudge::complete(const WindowFrame& frame, const WatchedPair& pair, ClosingMotion& motion) {
  const Transform X_LW = frame.X_WB[pair.link].inverse();
  motion.p_L = X_LW * motion.p_W;
  motion.n_L = X_LW.linear() * motion.n_W;
  Robot& robot = robots_[pair.robot];
  const std::span<const double> q(frame.q.data() + robot.first, robot.dof);
  const Transform X_BW = session_.mechanisms()[pair.robot]->X_WB().inverse();
  motion.robot_mass = std::max(
      robot.mass.halfMoving(),
      robot.mass.effective(q, frame_of_.at(pair.link), X_BW * motion.p_W, X_BW.linear() * motion.n_W));
}

ContactShare ApproachJudge::contact(const ClosingMotion& motion, double t, const WatchedPair& pair,
                                    const std::string& part) {
  ContactShare share;
  share.t = t;
  share.closing = motion.closing();
  share.kind = kindOf(part);
  share.robot_mass = motion.robot_mass;
  if (!limits_ || !(share.closing > 0.0)) return share;
  const contact::ContactMotion moves{
      motion.closing(), {motion.robot_mass, contact::RobotMassSource::kPosture}, share.kind};
  const contact::RegionContact worst = contact::worstContact(regionsOf(part), moves);
  if (!worst.region) return share;
  share.region = worst.region->name;
  share.excluded = worst.contact.excluded;
  share.force = worst.contact.force;
  share.energy = worst.contact.energy;
  share.share = worst.contact.share;
  if (share.excluded || !(worst.contact.indentation > 0.0)) return share;
  const contact::ContactArea area = areaAt(motion, pair, worst.contact.indentation);
  const contact::PredictedPressure pressure =
      contact::predictPressure(*worst.region, worst.contact, area, share.kind);
  share.pressure = pressure.peak;
  share.pressure_share = pressure.share;
  return share;
}

contact::ContactArea ApproachJudge::areaAt(const ClosingMotion& motion, const WatchedPair& pair,
                                           double indentation) {
  const structure::HapticStructure& link = *session_.scene().objects()[pair.link].spec.structure;
  const double radius = radius_of_.at(pair.part);
  if (last_.link != &link || last_.radius != radius || last_.p_L != motion.p_L || last_.n_L != motion.n_L)
    last_ = {&link, motion.p_L, motion.n_L, radius, {}};
  for (const auto& [at, area] : last_.areas)
    if (at == indentation) return area;
  auto& surface = surfaces_[&link];
  if (!surface) surface = std::make_unique<contact::ContactSurface>(*link.surface);
  const contact::ContactArea area =
      contact::contactArea(*surface, {motion.p_L, motion.n_L, indentation, radius});
  last_.areas.emplace_back(indentation, area);
  return area;
}

const std::vector<const contact::RegionLimits*>& ApproachJudge::regionsOf(const std::string& part) {
  const auto [at, fresh] = regions_.try_emplace(part);
  if (fresh && limits_) at->second = limits_->regionsOf(part);
  return at->second;
}

bool ApproachJudge::excluded(const std::string& part) {
  const auto& regions = regionsOf(part);
  return regions.empty() ||
         std::any_of(regions.begin(), regions.end(), [](const auto* r) { return r->excluded(); });
}

contact::ContactKind ApproachJudge::kindOf(const std::string& part) const {
  return std::find(clamped_.begin(), clamped_.end(), part) == clamped_.end()
             ? contact::ContactKind::kTransient
             : contact::ContactKind::kQuasiStatic;
}

double ApproachJudge::contactShare(const WatchedPair& pair, const std::string& part,
                                   const ClosingMotion& motion, double wanted) {
  if (excluded(part)) return 0.0;
  const double wanted_closing = wanted * motion.robot_speed + motion.person_speed;
  if (!(wanted_closing > 0.0)) return wanted;
  const contact::AllowedSpeed allowed = contact::allowedSpeed(
      regionsOf(part), {{motion.robot_mass, contact::RobotMassSource::kPosture}, kindOf(part)},
      wanted_closing, [&](double indentation) { return areaAt(motion, pair, indentation); });
  if (allowed.speed >= wanted_closing) return wanted;
  return std::min(wanted, contact::speedShare(allowed.speed, motion.robot_speed, motion.person_speed));
}

}  // namespace abstand::tune
