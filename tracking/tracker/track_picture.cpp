// Grey for measured depth, colours for the body.
#include "tracking/tracker/track_picture.hpp"

#include <algorithm>
#include <cmath>

#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::tracking {
namespace {

constexpr double kSagitta = 2e-3;                 // m, of the shapes' meshes
constexpr float kBehind = 0.10f;                  // m
constexpr double kBrightAt = 1.0, kDarkAt = 5.0;  // m
using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kTrunk{120, 190, 120}, kLeft{240, 160, 60}, kRight{80, 150, 240};
constexpr Colour kNothing{12, 14, 20};

Colour greyOf(float z) {
  if (!(z > 0.0f)) return kNothing;
  const double share = std::clamp((kDarkAt - static_cast<double>(z)) / (kDarkAt - kBrightAt), 0.0, 1.0);
  const auto level = static_cast<std::uint8_t>(45.0 + 190.0 * share);
  return {level, level, level};
}

/// Brightness from the slope of the drawn surface, by the depth difference to the next pixel.
double shade(const DepthImage& drawn, const DepthCamera& camera, int u, int v) {
  const float z = drawn.at(u, v);
  const float right = u + 1 < drawn.width && drawn.at(u + 1, v) > 0.0f ? drawn.at(u + 1, v) : z;
  const float below = v + 1 < drawn.height && drawn.at(u, v + 1) > 0.0f ? drawn.at(u, v + 1) : z;
  const double pixel = static_cast<double>(z) / camera.fx;
  const double du = static_cast<double>(right - z) / pixel, dv = static_cast<double>(below - z) / pixel;
  return std::clamp((1.0 - 0.25 * du + 0.45 * dv) / std::sqrt(1.0 + du * du + dv * dv), 0.25, 1.2);
}

}  // namespace

void drawBody(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
              const RigPlacement& X_WS, int left, ColourImage& picture) {
  const int w = image.width;
  const Transform X_CW = camera.X_WC.inverse();
  DepthImage nearest(w, image.height);
  DepthRender render(camera);
  for (std::size_t s = 0; s < kRigSegments; ++s) {
    const RigPart& part = rig.parts[s];
    Transform X_CP = X_CW * X_WS[s];
    X_CP.translate(part.p_shape);
    render.clear();
    render.draw(geometry::tessellate(part.shape, kSagitta), X_CP);
    const int side = sideOf(segmentAt(s));
    const Colour& colour = side > 0 ? kLeft : side < 0 ? kRight : kTrunk;
    const DepthImage& drawn = render.image();
    for (int v = 0; v < image.height; ++v) {
      for (int u = 0; u < w; ++u) {
        const float z = drawn.at(u, v), measured = image.at(u, v);
        if (!(z > 0.0f) || (measured > 0.0f && z > measured + kBehind)) continue;
        if (nearest.at(u, v) > 0.0f && nearest.at(u, v) < z) continue;
        nearest.at(u, v) = z;
        const double bright = shade(drawn, camera, u, v);
        Colour& pixel = picture.at(u + left, v);
        for (std::size_t k = 0; k < 3; ++k)
          pixel[k] = static_cast<std::uint8_t>(std::min(255.0, bright * static_cast<double>(colour[k])));
      }
    }
  }
}

void drawDepth(const DepthImage& image, int left, ColourImage& picture) {
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) picture.at(u + left, v) = greyOf(image.at(u, v));
}

ColourImage pictureOf(const DepthImage& image, const DepthCamera& camera, const BodyRig& rig,
                      const TrackedBody& body) {
  const int w = image.width;
  ColourImage picture(2 * w, image.height);
  for (const int left : {0, w}) drawDepth(image, left, picture);
  if (body.found) drawBody(image, camera, rig, body.X_WS, w, picture);
  return picture;
}

}  // namespace abstand::tracking
