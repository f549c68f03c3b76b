// People of a depth clip: recorded joints, and skin bodies.
#include "app/depth/clip_people.hpp"

#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/math/quantile.hpp"
#include "tracking/recording/derived_joints.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::depth {
namespace {

using enum humanmodel::Joint;

/// m; structures without distance queries are built as fast as possible: coarse, and with so many points that
/// the quadrature correction is skipped.
constexpr double kCoarse = 0.01, kManyPoints = 0.006;  // m

/// z of the lowest skin point in each of some frames.
std::vector<double> lowestSkin(const tracking::Recording& recording, double stature) {
  const tracking::SkinBody skin(stature, {});
  std::vector<double> lowest;
  for (const std::size_t i : tracking::sampleIndices(recording.frames.size())) {
    geometry::Bounds all;
    for (const tracking::SkinPart& part : skin.wrap(recording.frames[i]))
      for (const Vector3d& p : part.mesh.vertices) all.add(p);
    if (std::isfinite(all.lower.z())) lowest.push_back(all.lower.z());
  }
  return lowest;
}

}  // namespace

ClipPeople::ClipPeople(const session::Session& session) {
  for (std::size_t i = 0; i < session.humans().size(); ++i) {
    const scene_file::RecordingDescription& d = session.description().humans[i].recording;
    people_.push_back({session.humans()[i].get(), fromXyzRpy(d.place_xyz, Vector3d(0, 0, d.place_yaw))});
  }
}

humanmodel::SkeletonFrame ClipPeople::at(std::size_t person, double t) const {
  const auto& [driver, X_WR] = people_[person];
  humanmodel::SkeletonFrame frame = driver->recording() ? driver->recording()->at(t) : driver->model().rest;
  frame.t = t;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (frame.has(static_cast<humanmodel::Joint>(j))) frame.p[j] = X_WR * frame.p[j];
  return frame;
}

double ClipPeople::stature(std::size_t person) const {
  const session::HumanDriver& driver = *people_[person].driver;
  const double height = driver.model().height;
  return driver.recording() ? tracking::statureOfLegs(driver.recording()->frames).value_or(height) : height;
}

scene_file::SceneDescription sceneOf(const std::filesystem::path& file, std::optional<double> height) {
  scene_file::HumanDescription human;
  human.name = "person";
  human.pos = {file.string()};
  human.recording.file = file;
  tracking::Recording recording = tracking::openRecording(file);
  const std::optional<double> legs = tracking::statureOfLegs(recording.frames);
  human.body.height = height.value_or(legs.value_or(humanmodel::kUsualStature));
  if (height && legs) {
    tracking::RecordingOptions options;
    options.units = human.recording.options.units = formatDouble(recording.report.scale * *height / *legs);
    recording = tracking::openRecording(file, options);
  }
  for (const humanmodel::SkeletonFrame& f : recording.frames) {
    if (!f.has(kHipLeft) || !f.has(kHipRight)) continue;
    const Vector3d left = f[kHipLeft] - f[kHipRight];
    const Vector3d middle = 0.5 * (f[kHipLeft] + f[kHipRight]);
    // Forward is left rotated by -90 degrees about z.
    human.recording.place_yaw = -std::atan2(-left.x(), left.y());
    human.recording.place_xyz = -(Eigen::AngleAxisd(human.recording.place_yaw, Vector3d::UnitZ()) *
                                  Vector3d(middle.x(), middle.y(), 0.0));
    break;
  }
  const std::vector<double> lowest = lowestSkin(recording, *human.body.height);
  if (!lowest.empty()) human.recording.place_xyz.z() = -nearestQuantile(lowest, 0.1);

  scene_file::SceneDescription scene;
  scene.file = file;
  scene.defaults.haptic.voxel_size = kCoarse;
  scene.defaults.haptic.point_spacing = kManyPoints;
  scene.defaults.haptic.outer_layers = 1;
  scene.pairs.standard = scene_file::PairDefault::kNone;
  scene.humans.push_back(std::move(human));
  return scene;
}

}  // namespace abstand::depth
