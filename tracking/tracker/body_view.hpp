// One camera's view of a person on a coarse grid: points with normals, and free space.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// State of a grid cell. unknown: nothing was measured, or someone or something else is there. person: the
/// person. empty: free space, the camera sees past the person.
enum class CellState : std::uint8_t { kUnknown, kPerson, kEmpty };

/// Points of a person as a structure of arrays, world, m.
struct SeenPoints {
  static constexpr std::size_t kMax = 4096;
  std::size_t count{0};
  alignas(64) std::array<float, kMax> x, y, z;     ///< on the surface
  alignas(64) std::array<float, kMax> nx, ny, nz;  ///< unit, towards the camera's side of the surface
  std::array<std::uint8_t, kMax> view;             ///< index of the view that the point is from
  /// m, added to the distance of arms; not 0 for points of which markStanding() knows that they are no arm.
  alignas(64) std::array<float, kMax> no_arm;

  Vector3d point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vector3d normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
  /// m, the highest z; 0 if no point is above that.
  double top() const;
  /// Appends point `i` of other points; ignored if there is no room.
  void append(const SeenPoints& from, std::size_t i);
};

/// Image of one camera, and the pixels of one person in it.
struct PersonImage {
  const DepthImage* image;
  const DepthCamera* camera;
  std::span<const std::uint8_t> is_person;  ///< for every pixel: 1 is the person
  std::size_t number{0};                    ///< of the camera, the same in all images
};

/// One person in one image. update() allocates nothing after the first image of a size.
class BodyView {
 public:
  /// Sets the grid's step in pixels such that the person has at most `max_cells` cells. Pixels without depth
  /// (0) are unknown, except if the image contains only the person, because the background was removed: then
  /// they are empty.
  void update(const PersonImage& person, std::size_t max_cells);

  /// Appends the points of the view, marked with `index`, at most kMaxPoints of them.
  void appendPoints(std::uint8_t index, SeenPoints& points) const;

  const Vector3d& eye() const { return p_WE_; }  ///< position of the camera, world
  const Transform& X_CW() const { return X_CW_; }

  /// Observation at the projection of a world point (camera's frame p_CX, z > 0).
  struct Probe {
    CellState state{CellState::kUnknown};
    double z{0.0};  ///< m, measured depth there; 0: none
    /// m, in the image plane at the point's depth, camera's frame: vector to the nearest cell of the person.
    /// Only for an empty cell.
    Vector3d to_person{Vector3d::Zero()};
  };
  Probe at(const Vector3d& p_CX) const;
  /// Projection of a point, in pixels of the image; nullopt: not in the image.
  std::optional<Eigen::Vector2d> pixelOf(const Vector3d& p_CX) const;

  static constexpr std::size_t kMaxPoints = 2048;

 private:
  void coarsen(const DepthImage& image, std::span<const std::uint8_t> is_person);
  void propagateOffsets();
  std::size_t cell(int u, int v) const { return static_cast<std::size_t>(v * width_ + u); }

  int step_{1}, width_{0}, height_{0};            ///< pixels for each cell; size in cells
  double fx_{1.0}, fy_{1.0}, cx_{0.0}, cy_{0.0};  ///< intrinsics of the grid
  Transform X_WC_, X_CW_;
  Vector3d p_WE_{Vector3d::Zero()};
  std::vector<CellState> state_;
  std::vector<float> z_;
  std::vector<std::array<std::int16_t, 2>>
      offset_to_person_;  ///< offset in cells to the nearest cell of the person
};

}  // namespace abstand::tracking
