#include "abstand/scene.hpp"

#include <cmath>

#include "app/depth/open_session.hpp"
#include "app/facade/scene_parts.hpp"
#include "core/base/error.hpp"
#include "core/facade/structure_impl.hpp"
#include "humanmodel/facade/skeleton_frame.hpp"

namespace abstand {
namespace {

session::SessionOptions sessionOptions(const SceneOptions& options) {
  session::SessionOptions o;
  o.threads = options.threads;
  o.cache = options.cache;
  if (options.cold) o.remember = false;
  o.far_tolerance = options.far_tolerance;
  return o;
}

ObjectId objectId(std::size_t i) { return ObjectId(static_cast<std::uint32_t>(i)); }

}  // namespace

struct Scene::Impl {
  std::unique_ptr<session::Session> session;

  scene::Scene& scene() { return session->scene(); }
  const scene::Object& object(std::size_t i) { return scene().objects().at(i); }
  const scene::Pair& pair(std::size_t i) { return scene().pairs().at(i); }
  session::MechanismDriver& robot(std::size_t i) { return *session->mechanisms().at(i); }

  /// This robot's part of a list for all joint values.
  std::span<const double> of(std::size_t i, std::span<const double> all) {
    std::size_t first = 0;
    for (std::size_t k = 0; k < i; ++k) first += static_cast<std::size_t>(robot(k).dof());
    return all.subspan(first, static_cast<std::size_t>(robot(i).dof()));
  }
};

Scene::Scene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Scene Scene::load(const std::filesystem::path& file, const SceneOptions& options) {
  return Scene(std::unique_ptr<Impl>(
      new Impl{depth::openSession(scene_file::loadScene(file), sessionOptions(options))}));
}

Scene::Scene(const SceneBuilder& builder, const SceneOptions& options) {
  session::SessionOptions o = sessionOptions(options);
  o.made = builder.impl().made;
  impl_.reset(new Impl{depth::openSession(builder.impl().described(), o)});
}

std::size_t Scene::objects() const { return impl_->scene().objectCount(); }
const std::string& Scene::objectName(std::size_t object) const { return impl_->object(object).spec.name; }
std::optional<std::size_t> Scene::findObject(const std::string& name) const {
  ObjectId id(0);
  if (!impl_->scene().find(name, &id)) return std::nullopt;
  return id.index();
}
std::size_t Scene::pairs() const { return impl_->scene().pairs().size(); }
std::pair<std::size_t, std::size_t> Scene::pairObjects(std::size_t pair) const {
  const scene::Pair& p = impl_->pair(pair);
  return {p.a.index(), p.b.index()};
}
std::size_t Scene::robots() const { return impl_->session->mechanisms().size(); }
std::size_t Scene::people() const { return impl_->session->humans().size(); }
int Scene::dof(std::size_t robot) const { return impl_->robot(robot).dof(); }
std::vector<double> Scene::frameTimes() const { return impl_->session->frameTimes(); }
const std::vector<std::string>& Scene::remarks() const { return impl_->session->remarks(); }

void Scene::step(double t) { impl_->session->step(t); }
void Scene::startCold() { impl_->scene().startCold(); }

bool Scene::moveObject(std::size_t object, const Pose& X_WB, double t) {
  impl_->object(object);
  return impl_->scene().setPose(objectId(object), Transform(X_WB), t);
}

void Scene::moveRobot(std::size_t robot, std::span<const double> q, double t) {
  session::MechanismDriver& driver = impl_->robot(robot);
  if (q.size() != static_cast<std::size_t>(driver.dof()))
    throw UsageError("found " + std::to_string(q.size()) + " joint values, expected " +
                     std::to_string(driver.dof()));
  for (const double value : q)
    if (!std::isfinite(value)) throw UsageError("found a joint value that is not finite");
  driver.moveTo(q, t, impl_->scene());
}

void Scene::movePerson(std::size_t person, const Skeleton& skeleton) {
  impl_->session->humans().at(person)->follow(facade::frameOf(skeleton), impl_->scene());
}

void Scene::query(double t) {
  for (const auto& human : impl_->session->humans()) human->growUncertainty(t, impl_->scene());
  impl_->scene().step();
  impl_->session->sumEfforts();
}

PairResult Scene::result(std::size_t pair) const { return facade::resultOf(impl_->pair(pair).result); }
double Scene::uncertainty(std::size_t pair) const {
  impl_->pair(pair);
  return impl_->scene().pairUncertainty(PairId(static_cast<std::uint32_t>(pair)));
}
std::optional<std::size_t> Scene::nearest() const {
  const auto pair = impl_->scene().nearest();
  if (!pair) return std::nullopt;
  return pair->index();
}
std::vector<std::size_t> Scene::touching() const {
  std::vector<std::size_t> pairs;
  for (const PairId id : impl_->scene().touching()) pairs.push_back(id.index());
  return pairs;
}
Pose Scene::pose(std::size_t object) const { return Pose(impl_->object(object).X_WB); }
PoseState Scene::poseState(std::size_t object) const {
  return static_cast<PoseState>(impl_->object(object).pose_state);
}
Vector3d Scene::force(std::size_t object) const { return impl_->object(object).contact.force; }
Vector3d Scene::torque(std::size_t object) const { return impl_->object(object).contact.torque; }
std::vector<double> Scene::jointEfforts(std::size_t robot) const {
  impl_->robot(robot);
  const auto efforts = impl_->of(robot, impl_->session->jointEfforts());
  return {efforts.begin(), efforts.end()};
}
std::vector<double> Scene::jointValues(std::size_t robot) const { return impl_->robot(robot).q(); }

}  // namespace abstand
