// Reads the points of depth images, on a thread of its own.
#pragma once

#include "app/studio/depth_pictures.hpp"
#include "app/studio/latest_request.hpp"
#include "core/view/snapshot.hpp"
#include "ui/model/depth_cloud.hpp"

namespace abstand::studio {

/// At most so many points are taken from one image, evenly spaced.
inline constexpr long kMaxCloudPoints = 25000;
/// m: a point is the person's or the robot's up to this distance of its surface. Pose errors of the fit and
/// noise of a Kinect at 4 m are both below.
inline constexpr double kCloudReach = 0.08;

/// Every n-th column and row of an image, such that there are at most kMaxCloudPoints pixels.
int cloudStride(int width, int height);

/// The points of one image in the scene. A point of both person and robot is of the one that is nearer.
/// `people`: those of this recording, at least one. `robots`: in the frames of their bodies, with poses in
/// the scene.
std::vector<ui::CloudPoint> cloudOf(
    const std::vector<const DepthPerson*>& people, std::size_t image, const tracking::DepthImage& depth,
    const std::vector<std::pair<const geometry::TriangleMesh*, Transform>>& robots);

/// Reads what was asked for last. People of one recording share its points.
class DepthClouds final : public ui::CloudPort {
 public:
  /// `outline`: its objects and meshes do not change, and outlive this.
  DepthClouds(std::vector<DepthPerson> people, const view::SceneOutline& outline);

  std::vector<std::size_t> imagesAt(double t) const override;
  void ask(ui::CloudRequest request) override { reader_.ask(std::move(request)); }
  bool take(ui::DepthCloud& out) override { return reader_.take(out); }

 private:
  ui::DepthCloud read(const ui::CloudRequest& request);

  const std::vector<DepthPerson> people_;
  std::vector<std::pair<std::size_t, const geometry::TriangleMesh*>> robots_;  // object, its mesh
  std::vector<std::unique_ptr<tracking::DepthStream>> streams_;                // of the thread of reader_
  LatestRequest<ui::CloudRequest, ui::DepthCloud> reader_;                     // last member: uses the others
};

}  // namespace abstand::studio
