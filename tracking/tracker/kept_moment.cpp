#include "tracking/tracker/kept_moment.hpp"

namespace abstand::tracking {

void KeptMoment::add(const PersonImage& image, double frame_t) {
  images.push_back({{frame_t, *image.image},
                    image.camera,
                    {image.is_person.begin(), image.is_person.end()},
                    image.number});
}

std::vector<PersonImage> KeptMoment::views() const {
  std::vector<PersonImage> views;
  for (const Image& image : images)
    views.push_back({&image.frame.image, image.camera, image.is_person, image.number});
  return views;
}

}  // namespace abstand::tracking
