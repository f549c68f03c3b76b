// The motion of a depth camera between two images of static surfaces.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::tracking {

/// Depths on a grid of pixels, every `step` pixels from the middle of the first such square on, row by row.
struct PixelGrid {
  PixelGrid(const DepthCamera& camera, int spacing)
      : columns{camera.width / spacing}, rows{camera.height / spacing}, step{spacing} {}
  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  /// Of columns or rows.
  int pixelOf(int k) const { return k * step + step / 2; }
  /// Left, middle or right: 0 to kThirds - 1.
  std::size_t thirdOf(int column) const { return static_cast<std::size_t>(column * kThirds / columns); }
  std::size_t thirdOfCell(std::size_t cell) const {
    return thirdOf(static_cast<int>(cell % static_cast<std::size_t>(columns)));
  }

  static constexpr int kThirds = 3;
  int columns, rows, step;
};

/// How a camera moved between two images.
struct CameraMotion {
  Transform X_BN{Transform::Identity()};  ///< the camera now in the camera before
  double displacement{0.0};               ///< m, RMS of the points seen, by X_BN
};

/// Finds the rigid motion of a camera that explains changed depths best: distances of the points now to the
/// planes before, along the rays, with projective association (Blais and Levine, IEEE PAMI 17, 1995) and
/// Geman-McClure weights whose scale decreases (graduated non-convexity, Blake and Zisserman 1987), so that
/// neither the unchanged middle of an image nor what moved by itself decides. Where the surfaces do not
/// determine a motion, as along a wall, it is 0. One thread; estimate() neither throws nor allocates.
class CameraMotionFit {
 public:
  CameraMotionFit(const DepthCamera& camera, const PixelGrid& grid);

  /// Depths (m) on the grid; 0: none, or of nothing static. None if too few are in both, if they have hardly
  /// changed in the left or in the right third, or if no motion explains what has changed in both.
  std::optional<CameraMotion> estimate(std::span<const float> before, std::span<const float> now);

  static constexpr double kMinCells = 40.0;  ///< of each side
  /// Mean of the changes, squares in units of stepAt(), at most 1 each, that is no noise.
  static constexpr double kChanged = 0.1;
  static constexpr double kExplained = 0.04;  ///< of them, on each side; of noise, 0.01
  static constexpr double kWorse = 0.25;  ///< at most, what a motion changes, as a share of what it explains

  /// m, depth step of a Kinect and more, the scale of a change at depth z (m).
  static double stepAt(double z) { return 0.015 + 0.003 * z * z; }

 private:
  struct Plane {
    Vector3d p, n;
    bool is_known{false};
  };
  /// Sums of changes in one third that the motion explains, and that it causes.
  struct Third {
    double gained{0.0}, lost{0.0};
    std::size_t cells{0};
    bool isExplained() const {
      return gained >= kExplained * static_cast<double>(cells) && lost <= kWorse * gained;
    }
  };
  struct Change {
    std::array<Third, PixelGrid::kThirds> thirds;
    double squares{0.0};  ///< m^2, sum of the displacements
    std::size_t cells{0};
  };
  void findPlanes(std::span<const float> before);
  /// Where a point now was seen before; null: none.
  const Plane* planeAt(const Vector3d& p_B) const;
  void improve(std::span<const float> now, double scale, Transform& X_BN) const;
  Change changeBy(const Transform& X_BN, std::span<const float> now) const;
  static double changeFrom(const Plane& plane, const Vector3d& p_B);
  bool haveChanged(std::span<const float> now) const;

  DepthCamera camera_;
  PixelGrid grid_;
  std::vector<Vector3d> rays_;  // through the cells, with z = 1
  std::vector<Plane> planes_;
};

}  // namespace abstand::tracking
