// Copies of the images of a person.
#pragma once

#include <memory>
#include <vector>

#include "tracking/depth/formats/depth_stream.hpp"
#include "tracking/tracker/body_view.hpp"

namespace abstand::tracking {

/// What the cameras saw of a person at one moment.
struct KeptMoment {
  struct Image {
    std::shared_ptr<const DepthFrame> frame;  ///< that of other people at this moment, too
    const DepthCamera* camera;
    std::vector<std::uint8_t> is_person;
    std::size_t number;  ///< of the camera
  };
  std::size_t number{0};    ///< of the moment
  double t{0.0}, lag{0.0};  ///< s; lag: of images that are fitted together, 0 of a single one
  std::vector<Image> images{};

  /// Adds an image, of which `frame` is a copy.
  void add(const PersonImage& image, std::shared_ptr<const DepthFrame> frame);
  /// Valid as long as this.
  std::vector<PersonImage> views() const;
};

}  // namespace abstand::tracking
