// Depth images of meshes: what an ideal camera would see.
#pragma once

#include "core/geometry/triangle_mesh.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// A z-buffer of the size of the camera's image. Both sides of every triangle are seen. Not shared between
/// threads.
class DepthRender {
 public:
  /// Throws UsageError for a camera with a distortion, as images are rendered without one.
  explicit DepthRender(const DepthCamera& camera);

  void clear();
  /// `X_CB`: the mesh's body in the camera's optical frame. Parts nearer than 1 cm are cut off.
  void draw(const geometry::TriangleMesh& mesh, const Transform& X_CB);
  /// The nearest surface at the centre of each pixel; 0 where there is none.
  const DepthImage& image() const { return image_; }

 private:
  void fill(const Vector3d& a, const Vector3d& b, const Vector3d& c);

  DepthCamera camera_;
  DepthImage image_;
};

}  // namespace abstand::tracking
