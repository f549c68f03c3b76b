// Surfaces in a depth image that nothing connects.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"
#include "tracking/depth/people/plan_view.hpp"

namespace abstand::tracking {

/// Pixels of one label that are connected by neighbours of nearly the same depth.
struct SurfacePiece {
  std::size_t begin{0}, end{0};  ///< in SurfacePieces::pixels()
  double area{0.0};              ///< m^2, visible
  std::size_t size() const { return end - begin; }
};

/// What lies around a piece, in sides of its pixels.
struct PieceOutline {
  int free{0};     ///< a farther surface of no piece, or of a thing
  int beside{0};   ///< a farther surface of another piece
  int hidden{0};   ///< a nearer surface: the piece may go on behind it
  int behind{0};   ///< likewise, of a thing
  int unknown{0};  ///< nothing measured, or the border of the image
  int all() const { return free + beside + hidden + behind + unknown; }
};

/// Divides pixels into pieces. Neighbours in the image, up to two unmeasured pixels apart, are connected if
/// their depths differ by less than stepAt(). Not shared between threads. Only the constructor allocates.
class SurfacePieces {
 public:
  explicit SurfacePieces(const DepthCamera& camera);
  /// Of all pixels with `label`, valid until the next call.
  void divide(const DepthImage& image, std::span<const std::uint8_t> labels, std::uint8_t label);
  /// Only the piece of this pixel; empty if the pixel has another label.
  SurfacePiece pieceAt(std::size_t pixel, const DepthImage& image, std::span<const std::uint8_t> labels,
                       std::uint8_t label);

  const std::vector<SurfacePiece>& pieces() const { return pieces_; }
  std::span<const std::uint32_t> pixels(const SurfacePiece& piece) const {
    return std::span(pixels_).subspan(piece.begin, piece.size());
  }
  /// `above`: of the upper sides of its pixels; `end`: of its highest kEnd in the image.
  struct Outlines {
    PieceOutline whole, above, end;
    int covers{-1};  ///< index of the piece that hides most of the end; -1: none
  };
  static constexpr double kEnd = 0.10;  ///< m
  /// `is_thing`: of all pixels, 1 for those that belong to things.
  Outlines outlines(const SurfacePiece& piece, const DepthImage& image,
                    std::span<const std::uint8_t> is_thing);
  /// m^2 of a piece within `radius` (m) of a place in plan view; `cell_of`: cell of each pixel, -1: none.
  double areaWithin(const SurfacePiece& piece, const DepthImage& image, std::span<const int> cell_of,
                    const PlanView::Place& place, double radius) const;
  /// m, side of the largest square in the image that the piece fills, at the depth of the piece.
  double breadth(const SurfacePiece& piece, const DepthImage& image);

  static constexpr int kBridge = 3;  ///< pixels to the next measured one, of neighbours
  /// m, between neighbours of one surface: slopes, and the noise of a Kinect.
  static float stepAt(float z) { return 0.05f + 0.003f * z * z; }

 private:
  void clear();
  double areaOf(float z) const { return static_cast<double>(z * z) / (camera_.fx * camera_.fy); }
  void grow(std::size_t seed, const DepthImage& image, std::span<const std::uint8_t> labels,
            std::uint8_t label);

  DepthCamera camera_;
  std::vector<int> piece_of_;  ///< index in pieces_, of each pixel; -1: none
  std::vector<std::uint32_t> pixels_;
  std::vector<SurfacePiece> pieces_;
  std::vector<int> covered_;         ///< pixels of an end that each piece hides
  std::vector<std::uint16_t> side_;  ///< pixels, of the largest square that ends at a pixel
};

}  // namespace abstand::tracking
