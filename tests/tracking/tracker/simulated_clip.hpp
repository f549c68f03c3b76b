// Depth recordings made in memory: a body of skin that moves as somebody did, seen by a Kinect.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "tracking/depth/formats/depth_stream.hpp"
#include "tracking/depth/simulator/skin_body.hpp"
#include "tracking/recording/recording.hpp"

namespace abstand::testing {

/// A box in one hand or in both: corners (m) in the frame of the grip. Its origin is the end of the hand, or
/// the middle between both ends; x from the wrist to the end of the hand, y to the left of the person; for
/// both hands, y from the right one to the left one.
struct HeldBox {
  enum class Grip : std::uint8_t { kLeft, kRight, kBoth } grip;
  Vector3d low, high;
  /// World.
  std::array<Vector3d, 8> corners(const humanmodel::SkeletonFrame& frame) const;
};

/// Where a clip comes from and how it is seen. Lengths in m; world: the floor is z = 0, the person stands
/// over the origin in the clip's first frame and faces +x.
struct ClipPlan {
  std::filesystem::path recording;
  double start{0.0}, end{3.0};  ///< s
  Vector3d eye{2.8, 0.0, 1.2}, look{0.0, 0.0, 0.9};
  double turn{0.0};  ///< rad/s, that the whole person turns about its first place
  double clothing{0.0};
  std::uint64_t body_seed{0};
  bool room{false};  ///< a floor, and a wall
  double wall{1.5};  ///< m, of the wall behind `look`
  int width{320};
  double push_at{kInfinity}, push{0.0};  ///< s, rad: from then on the camera looks down by that much more
  double push_aside{0.0};                ///< rad, and to the right
  std::vector<HeldBox> held{};
};

struct SimulatedClip {
  std::unique_ptr<tracking::DepthStream> stream;  ///< 30 Hz, the camera's pose known
  std::vector<humanmodel::SkeletonFrame> truth;   ///< joints as recorded, world, one for each image
  std::shared_ptr<const tracking::SkinBody> skin;
};

SimulatedClip simulate(const ClipPlan& plan);

/// Of scenes of any kind, the one with this name. Throws std::out_of_range if there is none.
template <typename Scene>
Scene sceneNamed(const std::vector<Scene>& scenes, const std::string& name) {
  for (const Scene& scene : scenes)
    if (scene.name == name) return scene;
  throw std::out_of_range("no scene " + name);
}

/// One of the cameras around the origin, every 45 degrees; 0 is ahead of the person, 90 to the left.
struct SideView {
  std::string suffix;  ///< of the name of a clip: "_from_45"
  Vector3d eye;        ///< m
};
/// Cameras `distance` and `height` (m) from the origin.
std::vector<SideView> eightSides(double distance = 2.8, double height = 1.2);

/// A box that stands or swings in the way: corners, m, world.
struct FurnitureBox {
  Vector3d low, high;
  Vector3d swing{Vector3d::Zero()};      ///< m, amplitude: the box is off by it times sin(2 pi t / kSwing)
  static constexpr double kSwing = 2.0;  ///< s
};
/// Depth of the boxes alone at `t` (s), as of a robot whose joints are known.
tracking::DepthImage depthOf(std::span<const FurnitureBox> boxes, double t,
                             const tracking::DepthCamera& camera);
/// Of `plan` the camera, the room and the body; `truth` is shown as it is.
SimulatedClip simulate(const ClipPlan& plan, std::vector<humanmodel::SkeletonFrame> truth,
                       std::vector<FurnitureBox> furniture);

/// Distances (m) of joints that both have, without spine and thorax, which every recording has elsewhere.
struct JointErrors {
  std::vector<double> raw;  ///< sorted
  std::vector<double>
      aligned;               ///< sorted; each joint's mean offset, in axes that turn with the hips, taken off
  double longest_swap{0.0};  ///< s for which the body would fit better with left and right exchanged
  std::size_t lost{0};       ///< images without the body
  /// Raw errors of joints that were tracked, and of those that were inferred, against the covariance that is
  /// stated.
  struct Stated {
    std::vector<double> error;
    /// m, of the same joints: size of the stated ellipsoid in the direction of the error, and its largest
    /// semi-axis, which is the pose uncertainty.
    std::vector<double> reach, largest;
    std::vector<std::size_t> joint;  ///< of each
    void add(const Stated& other);
    double within() const;  ///< share of the errors that are no larger than the reach; 1 without joints
    /// Likewise, of a reach that is larger by a term (m) for each joint.
    double withinPlus(const std::array<double, humanmodel::kJointCount>& term) const;
    double medianRatio() const;  ///< median of reach / error; NaN without joints
    double withinLargest() const;
    double medianRatioOfLargest() const;
  };
  Stated tracked, inferred;
  /// m, mean of tracked minus true position in axes that turn with the hips, z up; zero without a value.
  std::array<Vector3d, humanmodel::kJointCount> offset;

  static double mean(const std::vector<double>& errors);
  static double quantile(const std::vector<double>& errors, double share);
};
JointErrors compare(const std::vector<humanmodel::SkeletonFrame>& tracked,
                    const std::vector<humanmodel::SkeletonFrame>& truth);

}  // namespace abstand::testing
