// Renders depth images of meshes for an ideal camera.
#pragma once

#include "core/geometry/triangle_mesh.hpp"
#include "tracking/depth/camera/depth_camera.hpp"
#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Z-buffer of the size of the camera's image. Both sides of every triangle are visible. Not shared between
/// threads.
class DepthRender {
 public:
  /// Throws UsageError for a camera with distortion, which is not rendered.
  explicit DepthRender(const DepthCamera& camera);

  void clear();
  /// `X_CB`: pose of the mesh's body in the camera's optical frame. Parts nearer than 1 cm are clipped.
  void draw(const geometry::TriangleMesh& mesh, const Transform& X_CB);
  /// The nearest surface at the centre of each pixel; 0 if there is none.
  const DepthImage& image() const { return image_; }

 private:
  void fill(const Vector3d& a, const Vector3d& b, const Vector3d& c);

  DepthCamera camera_;
  DepthImage image_;
};

}  // namespace abstand::tracking
