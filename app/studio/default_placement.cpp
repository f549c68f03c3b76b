#include "app/studio/default_placement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/math/roll_pitch_yaw.hpp"

namespace abstand::studio {

namespace {

constexpr double kLevel = 0.1;       // m: a lower or higher foot is a step, not another floor
constexpr double kHorizontal = 0.2;  // length of the horizontal part of a unit vector that has a heading
constexpr std::size_t kSampledFrames = 400;
constexpr double kSamePlace = 1e-6;  // m, rad: with the rounding of sums
constexpr double kCentimetre = 0.01, kDegree = kPi / 180.0;

double roundedTo(double value, double unit) { return std::round(value / unit) * unit; }

/// Unit vector in the plane z = 0; nullopt: it is about vertical.
std::optional<Vector3d> heading(const Vector3d& direction) {
  const Vector3d flat(direction.x(), direction.y(), 0.0);
  if (flat.norm() < kHorizontal) return {};
  return flat.normalized();
}

/// The corners of the boxes of objects, m, world.
std::vector<Vector3d> cornersOf(const scene::Scene& scene, const std::vector<ObjectId>& objects) {
  std::vector<Vector3d> corners;
  for (const ObjectId id : objects) {
    const scene::Object& object = scene.object(id);
    const geometry::Bounds box = object.spec.structure->surface->bounds();
    for (int k = 0; k < 8; ++k) {
      const Vector3d p_B((k & 1 ? box.upper : box.lower).x(), (k & 2 ? box.upper : box.lower).y(),
                         (k & 4 ? box.upper : box.lower).z());
      corners.push_back(object.X_WB * p_B);
    }
  }
  return corners;
}

double lowest(const std::vector<Vector3d>& corners) {
  double z = kInfinity;
  for (const Vector3d& p : corners) z = std::min(z, p.z());
  return z;
}

Vector3d turned(const Vector3d& v, double yaw) { return Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * v; }

}  // namespace

std::vector<DefaultPlacement> placeRobotsBeside(session::Session& session,
                                                const std::set<std::string>& placed) {
  std::vector<DefaultPlacement> found;
  double edge = -kInfinity;  // m, the largest y of the robots before
  for (std::size_t m = 0; m < session.mechanisms().size(); ++m) {
    const auto& description = session.description().mechanisms[m];
    const auto boxOf = [&] {
      std::vector<ObjectId> links;
      for (const auto& link : session.mechanisms()[m]->links())
        if (link.object) links.push_back(*link.object);
      std::pair<double, double> y{kInfinity, -kInfinity};
      for (const Vector3d& p : cornersOf(session.scene(), links))
        y = {std::min(y.first, p.y()), std::max(y.second, p.y())};
      return y;
    };
    session.applyMotion(session.frameTimes().front());
    auto [low, high] = boxOf();
    if (low > high) continue;
    if (m > 0 && placed.count(description.name) == 0 && low < edge + kRobotGap) {
      Transform X_WB = session.mechanisms()[m]->X_WB();
      const double shift = std::ceil((edge + kRobotGap - low) / kCentimetre) * kCentimetre;
      X_WB.translation().y() += shift;
      session.placeRobot(m, X_WB);
      high += shift;
      found.push_back({description.name,
                       session.description().mechanisms.front().name,
                       {X_WB.translation(), neatRollPitchYaw(X_WB.linear())}});
    }
    edge = std::max(edge, high);
  }
  return found;
}

bool isSame(const ui::Placement& a, const ui::Placement& b) {
  return (a.xyz - b.xyz).norm() < kSamePlace && (a.rpy - b.rpy).norm() < kSamePlace;
}

std::optional<DefaultPlacement> defaultPlacement(session::Session& session) {
  const auto& humans = session.humans();
  const auto moved = std::find_if(humans.begin(), humans.end(), [](const auto& h) { return h->recording(); });
  std::vector<ObjectId> links, parts;
  for (const auto& robot : session.mechanisms())
    for (const auto& link : robot->links())
      if (link.object) links.push_back(*link.object);
  if (moved == humans.end() || links.empty()) return {};
  const std::vector<double> times = session.frameTimes();
  session.applyMotion(times.front());
  for (const session::HumanDriver::Body& body : (*moved)->bodies()) parts.push_back(body.object);
  const scene::Scene& scene = session.scene();
  const std::vector<Vector3d> robots = cornersOf(scene, links), person = cornersOf(scene, parts);

  const Transform& X_WB = session.mechanisms().front()->X_WB();
  const Vector3d front = heading(X_WB.linear().col(0)).value_or(Vector3d::UnitX());
  double foremost = -kInfinity;
  for (const Vector3d& p : robots) foremost = std::max(foremost, front.dot(p - X_WB.translation()));

  const Transform torso = scene.object(*(*moved)->object(humanmodel::BodyPart::kTorso)).X_WB;
  const Vector3d faces = heading(torso.linear().col(0)).value_or(-front);
  const double turn = roundedTo(std::atan2(faces.cross(-front).z(), faces.dot(-front)), kDegree);
  const Vector3d centre(torso.translation().x(), torso.translation().y(), 0.0);
  double nearest = kInfinity;
  const std::size_t step_size = (times.size() + kSampledFrames - 1) / kSampledFrames;
  for (std::size_t i = 0; i < times.size(); i += step_size) {
    session.applyMotion(times[i]);
    for (const Vector3d& p : cornersOf(scene, parts))
      nearest = std::min(nearest, front.dot(turned(p - centre, turn)));
  }

  const auto& human = session.description().humans[static_cast<std::size_t>(moved - humans.begin())];
  DefaultPlacement found{human.name, session.description().mechanisms.front().name, {}};
  const Vector3d base(X_WB.translation().x(), X_WB.translation().y(), 0.0);
  const Vector3d stand = base + (foremost + kPersonGap - nearest) * front;
  found.placement.xyz = stand + turned(human.recording.place_xyz - centre, turn);
  const double step = lowest(robots) - lowest(person);
  if (std::abs(step) > kLevel) found.placement.xyz.z() += step;
  for (double& x : found.placement.xyz) x = roundedTo(x, kCentimetre);
  found.placement.rpy.z() = human.recording.place_yaw + turn;
  return found;
}

}  // namespace abstand::studio
