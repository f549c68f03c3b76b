// Builds a body from options.
#include "humanmodel/human_model.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/population.hpp"
#include "humanmodel/rest_pose.hpp"
#include "humanmodel/segment_inertia.hpp"

namespace abstand::humanmodel {
namespace {

void checkRange(double value, double low, double high, const std::string& what, const char* unit) {
  if (!(value >= low && value <= high))
    throw UsageError(what + " is " + formatDouble(value) + " " + unit + ", expected " + formatDouble(low) +
                     " to " + formatDouble(high));
}

void checkPercentile(const HumanOptions& options) {
  if (!options.percentile) return;
  checkRange(*options.percentile, 1.0, 99.0, "the person's percentile", "%");
  if (options.preset == HumanPreset::kThesis)
    throw UsageError(
        "the preset thesis is given with a percentile, which its table does not have, expected "
        "the preset anthropometric");
}

double statureOf(const HumanOptions& options) {
  const double usual =
      options.percentile ? statureOfPercentile(*options.percentile, options.sex) : kUsualStature;
  const double height = options.height.value_or(usual);
  checkRange(height, 0.5, 2.5, "the person's height", "m");
  return height;
}

/// kg, if none is given. The body mass index is taken as independent of stature, mass is not: a percentile
/// keeps its body mass index at another stature.
double usualMass(const HumanOptions& options, double height) {
  if (!options.percentile) return meanBodyMassIndex(options.sex) * (height * height);
  const double share = height / statureOfPercentile(*options.percentile, options.sex);
  return massOfPercentile(*options.percentile, options.sex) * (share * share);
}

double bodyMass(const HumanOptions& options, double height) {
  if (!options.mass) return usualMass(options, height);
  const double mass = *options.mass;
  checkRange(mass, 10.0, 300.0, "the person's mass", "kg");
  // Includes the leanest and heaviest people on record.
  checkRange(mass / (height * height), 8.0, 100.0,
             "the body mass index of " + formatDouble(mass) + " kg at " + formatDouble(height) + " m",
             "kg/m^2");
  return mass;
}

/// Sizes, mass and joints are those of the body; only the shapes change.
void putOn(const Clothing& clothing, std::vector<HumanPart>& parts) {
  for (HumanPart& part : parts) part.bare = part.shape;
  for (const auto& [part, thickness] : clothing) {
    checkRange(thickness, 0.0, kMaxClothing, "the clothing of " + std::string(partName(part)), "m");
    HumanPart& clothed = parts[index(part)];
    clothed.shape = widened(clothed.bare, thickness);
  }
}

}  // namespace

HumanModel makeHuman(const HumanOptions& options) {
  checkPercentile(options);
  HumanModel model;
  model.options = options;
  model.height = statureOf(options);
  model.mass = bodyMass(options, model.height);

  BuiltBody body;
  body.plan = options.preset == HumanPreset::kThesis
                  ? thesisPlan(model.height)
                  : anthropometricPlan(model.height, options.mass, options.sex, options.percentile);
  model.parts.reserve(kBodyPartCount);
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    const Segment& usual = body.plan[kindOf(part)];
    const auto requested = options.overrides.find(part);
    body.segments[i] =
        requested == options.overrides.end() ? usual : overridden(usual, requested->second, partName(part));
    model.parts.push_back(makePart(body, part));
  }
  assignInertia(model.mass, options.sex, model.parts);
  model.rest = restPose(body, model.parts);
  putOn(options.clothing, model.parts);
  return model;
}

}  // namespace abstand::humanmodel
