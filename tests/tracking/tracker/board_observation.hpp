// Observation of a person who is flat and across the camera, for tests whose images are made by hand.
#pragma once

#include <memory>

#include "tracking/tracker/body_observation.hpp"

namespace abstand::tracking {

/// The pixels (u, v) for which `is_person` holds are the person, at the depth `z` (m); the others see
/// `behind` (m).
template <class IsPerson>
std::unique_ptr<BodyObservation> boardSeen(const DepthCamera& camera, float z, float behind,
                                           const IsPerson& is_person) {
  DepthImage image(camera.width, camera.height);
  std::vector<std::uint8_t> mask(image.z.size(), 0);
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const bool is_here = is_person(u, v);
      mask[static_cast<std::size_t>(v * image.width + u)] = is_here;
      image.at(u, v) = is_here ? z : behind;
    }
  const PersonImage person{&image, &camera, mask};
  auto seen = std::make_unique<BodyObservation>();
  seen->update({&person, 1});
  return seen;
}

}  // namespace abstand::tracking
