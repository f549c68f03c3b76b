#include "app/studio/body_previews.hpp"

#include "app/studio/scene_of_work.hpp"
#include "core/base/error.hpp"

namespace abstand::studio {

namespace {

/// In the rest pose, where each part has the axes of the world.
ui::BodyShape shapeOf(const humanmodel::HumanModel& model) {
  ui::BodyShape shape;
  shape.stature = model.height;
  shape.mass = model.mass;
  for (const humanmodel::HumanPart& part : model.parts) {
    const Vector3d centre = model.rest[part.proximal] - part.p_proximal;
    if (const auto* ellipsoid = std::get_if<geometry::Ellipsoid>(&part.shape))
      shape.patches.push_back({centre, ellipsoid->semi_axes, false});
    else if (const auto* cuboid = std::get_if<geometry::Cuboid>(&part.shape))
      shape.patches.push_back({centre, 0.5 * cuboid->size, true});
  }
  return shape;
}

ui::BodyShape shapeOfPercentile(double percentile, humanmodel::Sex sex) {
  humanmodel::HumanOptions options;
  options.percentile = percentile;
  options.sex = sex;
  return shapeOf(humanmodel::makeHuman(options));
}

}  // namespace

ui::BodyPreview bodyPreview(const humanmodel::HumanOptions& in_scene, const ui::PersonOptions& changed) {
  ui::BodyPreview preview;
  humanmodel::HumanOptions options = in_scene;
  applyPerson(changed, options);
  try {
    preview.person = shapeOf(humanmodel::makeHuman(options));
  } catch (const UsageError& e) {
    preview.problem = QString::fromUtf8(e.what());
  }
  static const ui::BodyShape smallest = shapeOfPercentile(5.0, humanmodel::Sex::kFemale);
  static const ui::BodyShape largest = shapeOfPercentile(95.0, humanmodel::Sex::kMale);
  preview.smallest = smallest;
  preview.largest = largest;
  return preview;
}

}  // namespace abstand::studio
