// What one depth image shows of one person, on a coarse grid: points with normals, and where nobody is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// What is known of a cell of the grid. unknown: nothing was measured, or somebody or something else is
/// there. person: the person. empty: the camera looks past the person.
enum class CellState : std::uint8_t { kUnknown, kPerson, kEmpty };

/// Points of a person in structure of arrays, world, m.
struct SeenPoints {
  static constexpr std::size_t kMax = 2048;
  std::size_t count{0};
  alignas(64) std::array<float, kMax> x, y, z;     ///< on the surface
  alignas(64) std::array<float, kMax> nx, ny, nz;  ///< unit, towards the camera's side of the surface

  Vector3d point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vector3d normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
};

/// One person in one image. Memory is taken once; look() allocates nothing after the first image of a size.
class BodyObservation {
 public:
  /// `cells`: the most cells of the person that the grid is made for; its step is as many pixels as needed.
  explicit BodyObservation(std::size_t cells = 1200) : max_cells_{cells} {}

  /// `is_person`: of every pixel of `image`. Of the pixels that hold nothing (0) nothing is known, except
  /// where the image holds nothing but the person: then its background was taken away, and they are empty.
  void look(const DepthImage& image, const DepthCamera& camera, std::span<const std::uint8_t> is_person);

  const SeenPoints& points() const { return points_; }
  const Vector3d& eye() const { return p_WE_; }  ///< the camera, world
  const Transform& X_CW() const { return X_CW_; }

  /// Where a point of the world (camera's frame p_CX, z > 0) falls.
  struct Look {
    CellState state{CellState::kUnknown};
    double z{0.0};  ///< m, what was measured there; 0: nothing
    /// m in the image plane at the point's depth, in the camera's frame: the way to the nearest cell of the
    /// person. Of an empty cell only.
    Vector3d to_person{Vector3d::Zero()};
  };
  Look at(const Vector3d& p_CX) const;

 private:
  void coarsen(const DepthImage& image, std::span<const std::uint8_t> is_person);
  void spreadPerson();
  void collectPoints();
  std::size_t cell(int u, int v) const { return static_cast<std::size_t>(v * width_ + u); }

  std::size_t max_cells_;
  int step_{1}, width_{0}, height_{0};            ///< pixels a cell; cells
  double fx_{1.0}, fy_{1.0}, cx_{0.0}, cy_{0.0};  ///< of the grid
  Transform X_WC_, X_CW_;
  Vector3d p_WE_{Vector3d::Zero()};
  std::vector<CellState> state_;
  std::vector<float> z_;
  std::vector<std::array<std::int16_t, 2>> way_;  ///< cells to the nearest cell of the person
  SeenPoints points_;
};

}  // namespace abstand::tracking
