// The bodies of a scene as a depth camera sees them.
#pragma once

#include "app/session/session.hpp"
#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::depth {

/// Draws a scene's bodies where they are. The session must outlive this.
class SceneThings {
 public:
  SceneThings(const session::Session& session, bool with_people);
  /// `X_CW`: world in the camera's optical frame.
  void draw(const Transform& X_CW, tracking::DepthRender& render) const;

 private:
  const scene::Scene& scene_;
  std::vector<std::pair<std::size_t, geometry::TriangleMesh>> meshes_;  ///< with the number of their object
};

/// What a camera would see of a scene's robots and objects alone, at any time. Owns the session.
class RobotView {
 public:
  /// People and pairs are left out. Throws ParseError and UsageError.
  explicit RobotView(scene_file::SceneDescription scene, const session::SessionOptions& options);
  /// At time t (s) of the scene; there until the next call. A `camera` with a distortion is a UsageError.
  const tracking::DepthImage& at(double t, const tracking::DepthCamera& camera);

 private:
  session::Session session_;
  SceneThings things_;
  std::optional<tracking::DepthRender> render_;
};

}  // namespace abstand::depth
