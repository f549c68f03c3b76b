// From options to a body.
#include "humanmodel/human_model.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "humanmodel/anthropometry.hpp"
#include "humanmodel/rest_pose.hpp"
#include "humanmodel/segment_inertia.hpp"

namespace abstand::humanmodel {
namespace {

void checkRange(double value, double low, double high, const std::string& what, const char* unit) {
  if (!(value >= low && value <= high))
    throw UsageError(what + " is " + formatDouble(value) + " " + unit + ", expected " + formatDouble(low) +
                     " to " + formatDouble(high));
}

double bodyMass(const HumanOptions& options) {
  const double square = options.height * options.height;
  if (!options.mass) return meanBodyMassIndex(options.sex) * square;
  checkRange(*options.mass, 10.0, 300.0, "the person's mass", "kg");
  // The leanest and heaviest people on record lie well inside.
  checkRange(*options.mass / square, 8.0, 100.0,
             "the body mass index of " + formatDouble(*options.mass) + " kg at " +
                 formatDouble(options.height) + " m",
             "kg/m^2");
  return *options.mass;
}

}  // namespace

HumanModel makeHuman(const HumanOptions& options) {
  checkRange(options.height, 0.5, 2.5, "the person's height", "m");
  HumanModel model;
  model.options = options;
  model.height = options.height;
  model.mass = bodyMass(options);

  BuiltBody body;
  body.plan = options.preset == HumanPreset::kThesis
                  ? thesisPlan(model.height)
                  : anthropometricPlan(model.height, model.mass, options.sex);
  model.parts.reserve(kBodyPartCount);
  for (std::size_t i = 0; i < kBodyPartCount; ++i) {
    const auto part = static_cast<BodyPart>(i);
    const Segment& usual = body.plan[kindOf(part)];
    const auto wish = options.overrides.find(part);
    body.segments[i] =
        wish == options.overrides.end() ? usual : overridden(usual, wish->second, partName(part));
    model.parts.push_back(makePart(body, part));
  }
  assignInertia(model.mass, options.sex, model.parts);
  model.rest = restPose(body, model.parts);
  return model;
}

}  // namespace abstand::humanmodel
