// Surfaces beside a person that stay where they are while the person's legs move.
#pragma once

#include <algorithm>
#include <vector>

#include "tracking/tracker/depth_fit.hpp"

namespace abstand::tracking {

/// Chairs, boxes and the like that a person touched before they were learned as background, so that their
/// pixels are assigned to the person. A surface is a thing if
/// - it stayed at one depth, and apart from the fitted body, in kApartImages images, and
/// - a knee has moved by kLegMoved since then: what moves with the knees is the person.
/// Without the second condition, legs that the fit has lost would be things if the person stands still.
///
/// The chair on which a person sits (ChairSpace) does not need the second condition, but becomes a thing only
/// for another pass over the same images: keepChair().
///
/// Only pixels with the depth of the thing are removed from the person: they then count as another surface
/// that is seen. Things that are hidden for a while are remembered; they are forgotten where the camera looks
/// past them. Allocates for the first image of a camera; does not throw otherwise. Not shared between
/// threads.
class StillThings {
 public:
  /// The person's pixels of the images without those of things, valid until the next call.
  std::span<const PersonImage> remove(std::span<const PersonImage> images);
  /// Learns from the body that was fitted to the result of remove().
  void learn(const BodyObservation& seen, const DepthFit& fit, const RigPlacement& X_WS);
  /// Makes things of the surfaces that were of the chair in kChairImages images. Only for a person whose
  /// facing direction is known: the other one has its chair elsewhere. forget() does not forget them.
  void keepChair();
  /// Makes things of the person's pixels of `all` that are not the person's in `rest`, the same images.
  /// forget() does not forget them.
  void keep(std::span<const PersonImage> all, std::span<const PersonImage> rest);
  /// The person faces the other way: what was learned of a chair is wrong.
  void forgetChair();
  /// The poses so far were wrong: what was learned with them, too.
  void forget();
  /// Number of pixels that show things in the images of the last remove().
  std::size_t removed() const { return removed_; }

  static constexpr int kApartImages = 5;
  static constexpr double kLegMoved = 0.15;  ///< m
  static constexpr int kChairImages = 15;    ///< half a second at 30 Hz
  static constexpr float kApart = 0.10f;     ///< m, DepthFit::scores() of a point that is not on the body

 private:
  /// Candidate surface of a pixel.
  struct Pixel {
    float z{0.0f};                 ///< m, mean depth; 0: none
    std::uint8_t apart{0};         ///< images apart from the body, up to kApartImages
    std::uint8_t past{0};          ///< consecutive images in which the camera looked past it
    std::uint8_t chair{0};         ///< images as a part of a chair, up to kChairImages
    bool kept{false};              ///< by keepChair() or keep()
    std::uint16_t stretch{0};      ///< of stretch_, when `apart` became kApartImages
    std::uint16_t image{0};        ///< of image_, last one counted in `apart`
    std::uint16_t chair_image{0};  ///< likewise in `chair`
  };
  struct View {
    std::size_t number{0};  ///< PersonImage::number
    std::vector<Pixel> pixels;
    std::size_t begin{0}, end{0};  ///< of the pixels that may have anything
    std::vector<std::uint8_t> is_person;
    void mayHave(std::size_t pixel) {
      begin = begin == end ? pixel : std::min(begin, pixel);
      end = std::max(end, pixel + 1);
    }
  };
  View& viewOf(const PersonImage& image);
  bool isThing(const Pixel& pixel, float z) const;
  void update(const PersonImage& image, View& view);
  /// What a point is that is not on the body.
  struct Reasons {
    bool is_apart, is_chair;
  };
  void note(const DepthCamera& camera, const Vector3d& p_C, const Reasons& of, View& view);
  void noteKnees(const RigPlacement& X_WS);
  void noteAll(const BodyObservation& seen, const SeenPoints& points, const DepthFit& fit,
               const RigPlacement& X_WS, const std::optional<ChairSpace>& chair);

  std::vector<View> views_;
  std::vector<PersonImage> images_;
  /// m, world: at the beginning of the stretch, and in the last image.
  std::array<Vector3d, 2> knees_{Vector3d::Constant(kNaN), Vector3d::Constant(kNaN)};
  std::array<Vector3d, 2> last_knees_{knees_};
  std::uint16_t stretch_{0};  ///< number of times that a knee moved by kLegMoved
  std::uint16_t image_{0};    ///< number of the last image learned from
  std::size_t removed_{0};
  std::array<float, SeenPoints::kMax> score_{};
};

}  // namespace abstand::tracking
