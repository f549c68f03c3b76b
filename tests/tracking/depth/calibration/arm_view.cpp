#include "tests/tracking/depth/calibration/arm_view.hpp"

#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"

namespace abstand::testing {

PlainArm::PlainArm() {
  surfaces.push_back(geometry::makeSurface(geometry::Cylinder{0.09, 0.6}));
  surfaces.push_back(geometry::makeSurface(geometry::Capsule{0.06, 0.4}));
  surfaces.push_back(geometry::makeSurface(geometry::Cuboid{{0.09, 0.09, 0.4}}));
  for (const auto& s : surfaces) bodies.push_back(s.get());
}

std::vector<Transform> PlainArm::at(double bend) {
  const Transform upper = fromXyzRpy({0.0, 0.2, 0.95}, {-0.9, 0.0, 0.0});
  const Transform elbow = upper * fromXyzRpy({0.0, 0.0, 0.24}, {bend, 0.5, 0.0});
  return {movedTo({0.0, 0.0, 0.5}), upper, elbow * movedTo({0.0, 0.0, 0.22})};
}

tracking::DepthCamera smallKinect(const Vector3d& eye, const Vector3d& target) {
  tracking::DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 290.0;
  camera.cx = 159.5;
  camera.cy = 119.5;
  camera.X_WC = tracking::lookingAt(eye, target);
  return camera;
}

tracking::SurfaceView armSeen(const tracking::DepthCamera& camera,
                              const std::vector<const geometry::Surface*>& bodies,
                              const std::vector<Transform>& X_WB, std::uint64_t seed) {
  tracking::DepthRender render(camera);
  const Transform X_CW = camera.X_WC.inverse();
  for (std::size_t b = 0; b < bodies.size(); ++b) render.draw(bodies[b]->mesh(5e-4), X_CW * X_WB[b]);
  const auto draw = [&](const geometry::Shape& shape, const Vector3d& p) {
    render.draw(geometry::tessellate(shape, 1e-3), X_CW * movedTo(p));
  };
  draw(geometry::Cuboid{{8.0, 8.0, 0.02}}, {0.0, 0.0, -0.01});
  draw(geometry::Cuboid{{0.02, 8.0, 4.0}}, {-1.2, 0.0, 2.0});
  draw(geometry::Cuboid{{0.8, 0.6, 0.04}}, {0.1, -0.6, 0.7});
  draw(geometry::Sphere{0.1}, {0.5, 0.35, 0.55});
  return {tracking::seenByKinect(render.image(), camera, tracking::kinectNoiseIn(camera), seed, 0), X_WB};
}

}  // namespace abstand::testing
