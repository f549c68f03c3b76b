#include "app/session/robot_pairs.hpp"

#include <algorithm>

#include "app/session/human_driver.hpp"
#include "core/control/pair_direction.hpp"
#include "core/scene/directed_uncertainty.hpp"

namespace abstand::session {

std::vector<bool> partsOfPeople(const scene::Scene& scene,
                                const std::vector<std::unique_ptr<HumanDriver>>& humans) {
  std::vector<bool> people(scene.objectCount());
  for (const auto& human : humans)
    for (const HumanDriver::Body& body : human->bodies()) people[body.object.index()] = true;
  return people;
}

RobotPairs::RobotPairs(const MechanismDriver& driver, const scene::Scene& scene,
                       const std::vector<bool>& people, const control::ReactionDescription& reaction)
    : driver_(driver) {
  setReaction(reaction);
  std::vector<int> link_of(scene.objectCount(), -1);
  for (std::size_t i = 0; i < driver.links().size(); ++i)
    if (driver.links()[i].object) link_of[driver.links()[i].object->index()] = static_cast<int>(i);
  for (std::uint32_t i = 0; i < scene.pairs().size(); ++i) {
    const auto a = scene.pairs()[i].a.index(), b = scene.pairs()[i].b.index();
    if (link_of[a] >= 0 || link_of[b] >= 0)
      own_.push_back({PairId(i), link_of[a], link_of[b], people[a] || people[b]});
  }
  pairs_.resize(own_.size());
  rows_.resize(own_.size() * static_cast<std::size_t>(driver.dof()));
  twists_.resize(driver.links().size());
  J_.resize(6, driver.dof());
}

void RobotPairs::setReaction(const control::ReactionDescription& reaction) noexcept {
  reach_ = reaction.repulsion ? reaction.repulsion->range : -kInfinity;
  people_rows_ = reaction.speed.has_value();
}

void RobotPairs::moveLinks(std::span<const double> rates) {
  const Matrix3d& R_WB = driver_.X_WB().linear();
  const Eigen::Map<const Eigen::VectorXd> qd(rates.data(), static_cast<Eigen::Index>(rates.size()));
  for (std::size_t i = 0; i < twists_.size(); ++i) {
    const int frame = driver_.links()[i].frame;
    twists_[i] = Twist{};
    if (frame < 0) continue;
    mechanism::jacobian(driver_.mechanism(), driver_.state(), frame, J_);
    twists_[i] = {R_WB * (J_.topRows<3>().lazyProduct(qd)), R_WB * (J_.bottomRows<3>().lazyProduct(qd))};
  }
}

double RobotPairs::otherRate(const scene::Object& other, const Vector3d& p_W, const Vector3d& n_W,
                             double sign) const {
  const Vector3d v = other.velocity.linear + other.velocity.angular.cross(Vector3d(p_W - other.p_WCom()));
  return sign * n_W.dot(v);
}

double RobotPairs::spread(const Own& own, const scene::Scene& scene, const Vector3d& n_W) const {
  const scene::Pair& pair = scene.pairs()[own.id.index()];
  const bool is_a = own.link_a >= 0;
  const auto link = static_cast<std::size_t>(is_a ? own.link_a : own.link_b);
  const int frame = driver_.links()[link].frame;
  if (frame < 0) return 0.0;
  const scene::Object& body = scene.object(is_a ? pair.a : pair.b);
  const Vector3d towards = is_a ? Vector3d(-n_W) : n_W;
  const Vector3d p_W = is_a ? pair.result.witness_a : pair.result.witness_b;
  const Vector3d o_W = driver_.X_WB() * driver_.state().X_BF[static_cast<std::size_t>(frame)].translation();
  Twist at_p = twists_[link];
  at_p.linear += at_p.angular.cross(Vector3d(p_W - o_W));
  geometry::EnclosingSphere sphere = body.spec.structure->bounding_sphere;
  sphere.centre = body.X_WB * sphere.centre;
  return control::fastestAlong(towards, at_p, p_W, sphere) - towards.dot(at_p.linear);
}

double RobotPairs::oldest(const scene::Scene& scene, double t) const {
  double age = 0.0;
  for (const Own& own : own_) age = std::max(age, scene.ageOf(own.id, t));
  return age;
}

std::span<const control::ReactionPair> RobotPairs::gather(const scene::Scene& scene,
                                                          std::span<const double> planned) {
  const Transform X_BW = driver_.X_WB().inverse();
  const auto n = static_cast<std::size_t>(driver_.dof());
  if (people_rows_) moveLinks(planned);
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const Own& own = own_[i];
    const scene::Pair& pair = scene.pairs()[own.id.index()];
    const query::PairResult& r = pair.result;
    control::ReactionPair& out = pairs_[i];
    out = {.pair = static_cast<int>(own.id.index()),
           .distance = r.distance - r.bound,
           .uncertainty = scene::directedUncertainty(scene, own.id, r),
           .row = {},
           .person = own.person};
    // A stale pair has no valid distance, direction or rate.
    if (pair.paused) out.distance = out.other_rate = kNaN;
    const bool wanted = !(out.distance >= reach_) || (own.person && people_rows_);
    if (!wanted) continue;
    const std::span<double> row = std::span(rows_).subspan(i * n, n);
    std::fill(row.begin(), row.end(), 0.0);
    out.row = row;
    if (pair.paused) continue;
    const Vector3d n_W = control::partingDirection(r);
    if (!(n_W.squaredNorm() > 0.0)) continue;  // no direction, hence no dependence on the joints
    const Vector3d n_B = X_BW.linear() * n_W;
    const auto frameOf = [&](int link) { return driver_.links()[static_cast<std::size_t>(link)].frame; };
    if (own.link_a >= 0)
      control::addDistanceRow(driver_.mechanism(), driver_.state(),
                              {frameOf(own.link_a), X_BW * r.witness_a, n_B}, 1.0, row);
    if (own.link_b >= 0)
      control::addDistanceRow(driver_.mechanism(), driver_.state(),
                              {frameOf(own.link_b), X_BW * r.witness_b, n_B}, -1.0, row);
    if (own.link_b < 0) out.other_rate = otherRate(scene.object(pair.b), r.witness_b, n_W, -1.0);
    if (own.link_a < 0) out.other_rate = otherRate(scene.object(pair.a), r.witness_a, n_W, 1.0);
    if (own.person && people_rows_) out.spread = spread(own, scene, n_W);
  }
  return pairs_;
}

}  // namespace abstand::session
