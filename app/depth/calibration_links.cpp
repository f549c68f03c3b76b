// Links of one robot of a scene as moving surfaces.
#include "app/depth/calibration_links.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::depth {
namespace {

std::string nameOf(const scene_file::SceneDescription& scene, const std::string& robot) {
  std::vector<std::string> names;
  for (const scene_file::MechanismDescription& m : scene.mechanisms) names.push_back(m.name);
  if (names.empty())
    throw UsageError("--robot: found a scene without a mechanism, expected one with a robot");
  if (robot.empty() && names.size() == 1) return names.front();
  if (std::find(names.begin(), names.end(), robot) != names.end()) return robot;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  throw UsageError("--robot: found " + (robot.empty() ? "none" : "'" + robot + "'") +
                   ", expected one of the scene's mechanisms: " + list);
}

/// The scene with only this robot and without pairs, as no distances are needed.
scene_file::SceneDescription alone(scene_file::SceneDescription scene, const std::string& robot) {
  std::erase_if(scene.mechanisms, [&](const scene_file::MechanismDescription& m) { return m.name != robot; });
  scene.mechanisms.front().reaction.reset();
  scene.humans.clear();
  scene.objects.clear();
  scene.pairs = {};
  scene.pairs.standard = scene_file::PairDefault::kNone;
  scene.threads = {};
  return scene;
}

}  // namespace

CalibrationLinks::CalibrationLinks(scene_file::SceneDescription scene, const std::string& robot,
                                   const session::SessionOptions& options)
    : robot_(nameOf(scene, robot)),
      session_(std::make_unique<session::Session>(alone(std::move(scene), robot_), options)) {
  for (const scene::Object& object : session_->scene().objects())
    surfaces_.push_back(object.spec.structure->surface.get());
  if (surfaces_.empty())
    throw UsageError("--robot: found no links of '" + robot_ + "', expected some with shapes or meshes");
}

std::vector<Transform> CalibrationLinks::at(double t) {
  session_->applyMotion(t);
  std::vector<Transform> X_WB;
  for (const scene::Object& object : session_->scene().objects()) X_WB.push_back(object.X_WB);
  return X_WB;
}

}  // namespace abstand::depth
