// Things that stand beside people, as chairs and boxes.
#pragma once

#include "tracking/depth/people/floor_plane.hpp"
#include "tracking/depth/people/plan_view.hpp"
#include "tracking/depth/people/surface_pieces.hpp"

namespace abstand::tracking {

/// Surface of a thing in a pixel.
struct ThingPixel {
  float z{0.0f};           ///< m, mean depth
  std::uint8_t images{0};  ///< in which it was seen as a part of a thing; 0: there is none
  std::uint8_t past{0};    ///< consecutive images in which the camera looked past it
};

/// Finds things among the pixels of a person. A piece of surface (SurfacePieces) other than that of the trunk
/// is a thing, because no limb is like that, if it begins below the height of a seat and
/// - nothing adjoins it or hides a part of it: nothing can connect it to the person;
/// - it is broader than kBroad, and ends at the top by itself: what is above it is farther away (legs go on
///   above, behind what hides them);
/// - somebody stands, and it stands on the floor, and ends at the top in front of all else or is higher than
///   a leg (a post). What covers the end of a thing, as a box on a post, belongs to it.
/// Things that touch the piece of the trunk in each image, or are beside somebody lower than 1 m, are not
/// found.
///
/// What was found in kImages images is remembered, also while an arm touches it, and forgotten where the
/// camera looks past it. Not shared between threads. Only the constructor allocates; nothing throws.
class ThingsBeside {
 public:
  explicit ThingsBeside(const DepthCamera& camera);
  /// Before find(): of a finder that has seen the same images. Ignored if it is of another size.
  void expect(std::span<const ThingPixel> things);
  const std::vector<ThingPixel>& things() const { return things_; }

  /// The next image: forgets what is no longer there.
  void look(const DepthImage& image);
  /// Whether a depth `z` (m) is that of a remembered thing.
  bool has(std::size_t pixel, float z) const;
  /// Sets the labels of things to 0 among the pixels of one person, whose trunk is at `place` (m, plan view);
  /// `cell_of`: plan view cell of each pixel, -1: none.
  void find(const DepthImage& image, const FloorPlane& floor, std::span<const int> cell_of,
            const PlanView::Place& place, std::uint8_t label, std::span<std::uint8_t> labels);

  static constexpr int kImages = 5;
  static constexpr double kBroad = 0.32;  ///< m; two legs beside each other have up to 0.3

 private:
  /// m above the floor.
  struct Extent {
    double low, high;
  };
  Extent extentOf(const SurfacePiece& piece, const DepthImage& image, const FloorPlane& floor) const;
  void markThings(const DepthImage& image);
  const SurfacePiece* trunkOf(const DepthImage& image, std::span<const int> cell_of,
                              const PlanView::Place& place) const;
  bool isThing(const SurfacePiece& piece, const DepthImage& image, const Extent& extent, bool stands,
               const SurfacePieces::Outlines& outlines);
  void take(const SurfacePiece& piece, const DepthImage& image, std::span<std::uint8_t> labels);
  void note(std::size_t pixel, float z);
  bool isAt(std::size_t pixel, float z) const;

  DepthCamera camera_;
  SurfacePieces pieces_;
  std::vector<ThingPixel> things_;
  bool noted_{false};                   ///< whether things_ may have any
  std::vector<std::uint8_t> is_thing_;  ///< of each pixel of an image
};

}  // namespace abstand::tracking
