// Things that touch the outline of a person who stands.
#pragma once

#include <functional>
#include <vector>

#include "tracking/tracker/body_follower.hpp"

namespace abstand::tracking {

/// Separates chairs, boxes and the like from the legs of a person who stands so close to them that their
/// surfaces adjoin in the image, as seen from behind a chair. Such a person is not found, or a leg is laid
/// into the thing. A surface belongs to a thing if it has kept its depth in kStillImages images, is lower
/// than kHighest of the stature, and is apart from a body that stands and then explains the image much
/// better. What somebody carries is not still. Allocates for the first image of a camera, and while it
/// searches; does not throw otherwise. One thread.
class TouchingThings {
 public:
  /// The images of the next moment: notes for how long each pixel has kept its depth.
  void see(std::span<const PersonImage> images);
  /// Searches the person's pixels of the last see() for one who stands among things. `trial`: has tracked
  /// nothing; its body is the person, if found. `cost` (m^2): of the body that was fitted to all pixels,
  /// infinite without one. Returns whether things were separated. A search takes as long as about twenty
  /// images; there is none without still surfaces beside the trunk.
  bool search(double t, std::span<const PersonImage> images, double cost, BodyFollower& trial);
  /// Whether the last search() was more than a look at the surfaces.
  bool searched() const { return is_searched_; }
  /// After search(), the person's pixels without those of things, valid until the next call.
  std::span<const PersonImage> rest() const { return rest_; }

  static constexpr std::int32_t kStillImages = 15;  ///< half a second at 30 Hz
  static constexpr double kHighest = 0.6;           ///< times the stature; backs of chairs have 0.9 to 1.0 m

 private:
  /// By pixel, in arrays that a compiler can process several pixels at a time with.
  struct View {
    std::size_t number{0};             ///< PersonImage::number
    std::vector<float> z;              ///< m, mean depth
    std::vector<std::int32_t> images;  ///< that have it, up to kStillImages
    std::vector<std::int32_t> away;    ///< consecutive ones with another depth
    std::vector<std::uint8_t> is_person;
  };
  static bool isStill(const View& view, std::size_t i, const PersonImage& image);
  View& viewOf(const PersonImage& image);
  std::size_t setAside(std::span<const PersonImage> images, double below,
                       const std::function<bool(const Vector3d&)>& is_thing);

  std::vector<View> views_;
  std::vector<PersonImage> rest_;
  bool is_searched_{false};
};

}  // namespace abstand::tracking
