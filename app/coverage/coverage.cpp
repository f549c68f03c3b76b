#include "app/coverage/coverage.hpp"

#include "app/coverage/occlusion_view.hpp"
#include "app/session/times_between.hpp"
#include "core/base/error.hpp"

namespace abstand::coverage {
namespace {

constexpr double kSagitta = 2e-3;      // m, of the meshes of shapes
constexpr double kWeld = 2e-3;         // m, meshes of files are thinned; a tenth of a pixel at 3 m
constexpr std::size_t kSamples = 400;  // of each part; a share has a standard deviation below 2.5 %
constexpr std::uint64_t kSampleSeed = 1;
constexpr double kMaxRate = 1000.0;  // Hz

enum class Kind : std::uint8_t { kRobot, kThing, kPerson };

struct Occluder {
  std::size_t object;
  Kind kind;
  std::size_t person;
  geometry::TriangleMesh mesh;
};

struct Part {
  std::size_t object, person;
  std::vector<tracking::SurfaceSample> samples;
};

std::vector<Occluder> occludersOf(const session::Session& session) {
  std::vector<Occluder> occluders;
  const auto& objects = session.scene().objects();
  const auto& scene = session.description();
  for (std::size_t k = 0; k < objects.size(); ++k) {
    Occluder occluder{k, Kind::kThing, 0, {}};
    for (const auto& robot : scene.mechanisms)
      if (robot.name == objects[k].spec.group) occluder.kind = Kind::kRobot;
    for (std::size_t i = 0; i < scene.humans.size(); ++i) {
      if (scene.humans[i].name != objects[k].spec.group) continue;
      occluder.kind = Kind::kPerson;
      occluder.person = i;
    }
    occluder.mesh = geometry::weld(objects[k].spec.structure->surface->mesh(kSagitta), kWeld);
    occluders.push_back(std::move(occluder));
  }
  return occluders;
}

std::vector<Part> partsOf(const session::Session& session) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < session.humans().size(); ++i)
    for (const session::HumanDriver::Body& body : session.humans()[i]->bodies()) {
      if (body.tool) continue;
      const auto object = static_cast<std::size_t>(body.object.index());
      const geometry::Surface* surface = session.scene().objects()[object].spec.structure->surface.get();
      parts.push_back({object, i, tracking::sampleSurfaces({&surface, 1}, kSamples, kSampleSeed)});
    }
  return parts;
}

void drawAll(const session::Session& session, const std::vector<Occluder>& occluders, OcclusionView& view) {
  view.clear();
  for (const Occluder& occluder : occluders) {
    const scene::Object& object = session.scene().objects()[occluder.object];
    if (occluder.kind == Kind::kRobot) view.drawRobot(occluder.mesh, object.X_WB);
    if (occluder.kind == Kind::kThing) view.drawThing(occluder.mesh, object.X_WB);
    // A body whose place is not known hides nothing; its own parts are kUnknown.
    if (occluder.kind == Kind::kPerson && !scene::isPoseLost(object.pose_state))
      view.drawPerson(occluder.person, occluder.mesh, object.X_WB);
  }
}

void check(const session::Session& session, const CoverageOptions& options) {
  if (session.humans().empty()) throw UsageError("found a scene without a person, expected at least one");
  if (!(options.rate > 0.0 && options.rate <= kMaxRate))
    throw UsageError("found a rate of " + std::to_string(options.rate) +
                     " Hz, expected above 0, at most 1000 Hz");
  if (options.columns < 1 || options.columns > tracking::DepthCamera::kMaxPixels)
    throw UsageError("found images of " + std::to_string(options.columns) + " columns, expected 1 to " +
                     std::to_string(tracking::DepthCamera::kMaxPixels));
  if (!(options.sensor.nearest >= 0.0 && options.sensor.farthest > options.sensor.nearest))
    throw UsageError(
        "found a sensor that measures nothing, expected its nearest depth to be at least 0 and "
        "below the farthest");
}

}  // namespace

Coverage evaluateCoverage(session::Session& session, const CoverageOptions& options) {
  check(session, options);
  const std::vector<double> times =
      session::timesBetween(session.frameTimes(options.rate), options.start, options.end);
  const std::vector<Occluder> occluders = occludersOf(session);
  const std::vector<Part> parts = partsOf(session);
  OcclusionView view(options.sensor, session.humans().size(), options.columns);
  Coverage coverage;
  coverage.columns = view.columns();
  coverage.rows = view.rows();
  for (const Part& part : parts)
    coverage.parts.push_back({session.scene().objects()[part.object].spec.name, {}});
  for (const double t : times) {
    if (options.interrupted && options.interrupted()) {
      coverage.interrupted = true;
      break;
    }
    session.applyMotion(t);
    drawAll(session, occluders, view);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const scene::Object& object = session.scene().objects()[parts[i].object];
      Shares unknown{};
      unknown[static_cast<std::size_t>(Cause::kUnknown)] = 1.0f;
      coverage.parts[i].shares.push_back(scene::isPoseLost(object.pose_state)
                                             ? unknown
                                             : view.shares(parts[i].person, parts[i].samples, object.X_WB));
    }
    coverage.times.push_back(t);
    if (options.progress) options.progress(coverage.times.size(), times.size());
  }
  return coverage;
}

}  // namespace abstand::coverage
