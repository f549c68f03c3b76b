#include "tracking/tracker/kept_moment.hpp"

#include <utility>

namespace abstand::tracking {

void KeptMoment::add(const PersonImage& image, std::shared_ptr<const DepthFrame> frame) {
  images.push_back(
      {std::move(frame), image.camera, {image.is_person.begin(), image.is_person.end()}, image.number});
}

std::vector<PersonImage> KeptMoment::views() const {
  std::vector<PersonImage> views;
  for (const Image& image : images)
    views.push_back({&image.frame->image, image.camera, image.is_person, image.number});
  return views;
}

}  // namespace abstand::tracking
