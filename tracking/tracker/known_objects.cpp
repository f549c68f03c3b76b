#include "tracking/tracker/known_objects.hpp"

#include <cmath>
#include <cstdio>
#include <memory>

namespace abstand::tracking {
namespace {

constexpr std::size_t kFewestPixels = 200;
constexpr double kShown = 0.6;  // share

/// m; as PeopleFinder cuts known objects out, and a Kinect's steps.
float nearTo(float z) { return 0.06f + 0.006f * z * z; }

}  // namespace

void KnownPixels::add(const DepthImage& image, const DepthImage& known) {
  for (std::size_t i = 0; i < image.z.size(); ++i) {
    const float expected = known.z[i], z = image.z[i];
    if (expected <= 0.0f || z <= 0.0f) continue;
    there += std::abs(z - expected) < nearTo(expected);
    through += z - expected >= nearTo(expected);
  }
}

double KnownPixels::share() const {
  const std::size_t all = there + through;
  return all > 0 ? static_cast<double>(there) / static_cast<double>(all) : kNaN;
}

bool KnownPixels::show() const { return there + through >= kFewestPixels && share() >= kShown; }

ObjectsInImages compareWithKnown(DepthStream& stream, const KnownObjects& objects) {
  ObjectsInImages in_images;
  DepthFrame frame;
  const std::size_t count = stream.times().size(), compared = std::min(count, kComparedImages);
  for (std::size_t i = 0; i < compared; ++i) {
    stream.seek(i * count / compared);
    if (!stream.next(frame)) break;
    const DepthImage* all = objects.known(frame.t, stream.camera());
    if (!all || all->z.size() != frame.image.z.size()) continue;
    in_images.pixels.add(frame.image, *all);
    const DepthImage* robots = objects.robots ? objects.robots(frame.t, stream.camera()) : nullptr;
    in_images.displaced.add(frame.image, robots ? *robots : *all, stream.camera());
  }
  stream.seek(0);
  return in_images;
}

KnownThings withBand(KnownThings known, double band) {
  if (!(band > 0.0)) return known;
  return [known = std::move(known), banded = std::make_shared<BandedThings>(), band](
             double t, const DepthCamera& camera) -> const DepthImage* {
    const DepthImage* things = known(t, camera);
    return things ? &banded->around(*things, camera, band) : nullptr;
  };
}

std::string bandReason(const DisplacedThings& displaced) {
  if (!(displaced.band() > 0.0)) return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "up to %.0f mm from where the scene has them, so distances to them are as uncertain; what is "
                "within %.0f mm of them belongs to nobody",
                1e3 * displaced.displacement(), 1e3 * displaced.band());
  return text;
}

}  // namespace abstand::tracking
