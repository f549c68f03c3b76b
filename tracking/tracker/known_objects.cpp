#include "tracking/tracker/known_objects.hpp"

#include <cmath>

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

bool KnownPixels::show() const {
  const std::size_t all = there + through;
  return all >= kFewestPixels && static_cast<double>(there) >= kShown * static_cast<double>(all);
}

KnownPixels compareWithKnown(DepthStream& stream, const KnownThings& known) {
  KnownPixels pixels;
  DepthFrame frame;
  const std::size_t count = stream.times().size(), compared = std::min(count, kComparedImages);
  for (std::size_t i = 0; i < compared; ++i) {
    stream.seek(i * count / compared);
    if (!stream.next(frame)) break;
    const DepthImage* image = known(frame.t, stream.camera());
    if (image && image->z.size() == frame.image.z.size()) pixels.add(frame.image, *image);
  }
  stream.seek(0);
  return pixels;
}

}  // namespace abstand::tracking
