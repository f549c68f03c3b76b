#include "app/facade/scene_parts.hpp"
#include "app/scene_file/robot_links.hpp"
#include "core/base/error.hpp"
#include "core/facade/structure_impl.hpp"

namespace abstand {
namespace {

void checkMargin(double margin) {
  if (!(margin >= 0.0 && margin <= 10.0))
    throw UsageError("found a margin beyond its limits, expected 0 to 10 m");
}

}  // namespace

scene_file::SceneDescription SceneBuilder::Impl::described() const {
  scene_file::SceneDescription scene = description;
  scene.pairs.standard = scene_file::PairDefault::kBetweenGroups;
  // All objects are one group.
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    for (std::size_t k = i + 1; k < scene.objects.size(); ++k) {
      scene.pairs.include.emplace_back(scene.objects[i].name, scene.objects[k].name);
      scene.pairs.include_pos.emplace_back();
    }
  return scene;
}

SceneBuilder::SceneBuilder() : impl_(std::make_unique<Impl>()) {}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(const SceneBuilder& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
SceneBuilder& SceneBuilder::operator=(const SceneBuilder& other) {
  *impl_ = *other.impl_;
  return *this;
}

SceneBuilder& SceneBuilder::addObject(const std::string& name, const Structure& structure, const Pose& X_WB,
                                      double margin) {
  checkMargin(margin);
  scene_file::ObjectDescription object;
  object.name = name;
  object.X_WB = facade::checkedPose(X_WB);
  object.settings.margin = margin;
  if (!impl_->made.emplace(name, structure.impl().made).second)
    throw UsageError("found the name '" + name + "' a second time, expected a new one");
  impl_->description.objects.push_back(std::move(object));
  return *this;
}

SceneBuilder& SceneBuilder::addRobot(const std::string& name, const std::filesystem::path& file,
                                     const RobotOptions& options) {
  checkMargin(options.margin);
  const robot_file::Robot robot = robot_file::loadRobot(file);
  const auto dof = static_cast<std::size_t>(robot.mechanism.dof);
  if (!options.q.empty() && options.q.size() != dof)
    throw UsageError("found " + std::to_string(options.q.size()) + " joint values for '" + name +
                     "', expected " + std::to_string(dof));
  scene_file::MechanismDescription m;
  m.name = name;
  m.file = std::filesystem::absolute(file).lexically_normal();
  m.X_WB = facade::checkedPose(options.X_WB);
  m.q = options.q;
  m.settings.margin = options.margin;
  scene_file::RobotLinks links =
      scene_file::robotLinks(robot, name, robot_file::GeometryUse::kCollision, {.folders = options.packages});
  m.frames_with_geometry = scene_file::framesWithGeometry(robot, {}).size();
  auto& remarks = impl_->description.remarks;
  remarks.insert(remarks.end(), robot.warnings.begin(), robot.warnings.end());
  scene_file::takeLinks(std::move(links), m, remarks);
  impl_->description.mechanisms.push_back(std::move(m));
  return *this;
}

SceneBuilder& SceneBuilder::addPerson(const std::string& name, const PersonOptions& options) {
  checkMargin(options.margin);
  if (!options.place.allFinite() || !std::isfinite(options.yaw))
    throw UsageError("found a position that is not finite for '" + name + "', expected numbers");
  scene_file::HumanDescription human;
  human.name = name;
  human.body.height = options.height;
  human.settings.margin = options.margin;
  human.recording.file = options.recording;
  human.recording.place_xyz = options.place;
  human.recording.place_yaw = options.yaw;
  impl_->description.humans.push_back(std::move(human));
  return *this;
}

SceneBuilder& SceneBuilder::setResolution(double voxel_size, double point_spacing) {
  structure::HapticOptions options = impl_->description.defaults.haptic;
  options.voxel_size = voxel_size;
  options.point_spacing = point_spacing;
  options.validate();
  impl_->description.defaults.haptic = options;
  return *this;
}

SceneBuilder& SceneBuilder::setStiffness(double stiffness) {
  if (!(stiffness > 0.0) || !std::isfinite(stiffness))
    throw UsageError("found a stiffness that is not positive, expected more than 0 N/m^3");
  impl_->description.defaults.stiffness = stiffness;
  return *this;
}

}  // namespace abstand
