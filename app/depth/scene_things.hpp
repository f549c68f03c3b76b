// Renders the bodies of a scene for a depth camera.
#pragma once

#include "app/session/session.hpp"
#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::depth {

/// A scene of the robots and objects alone, without pairs.
scene_file::SceneDescription withoutPeople(scene_file::SceneDescription scene);

/// Renders a scene's bodies at their current poses. The session must outlive this object.
class SceneThings {
 public:
  SceneThings(const session::Session& session, bool with_people);
  /// `X_CW`: world in the camera's optical frame.
  void draw(const Transform& X_CW, tracking::DepthRender& render) const;
  /// The links alone.
  void drawRobots(const Transform& X_CW, tracking::DepthRender& render) const;

  std::size_t size() const { return meshes_.size(); }
  const scene::Object& object(std::size_t k) const { return scene_.objects()[meshes_[k].first]; }
  /// Whether it is a link of a mechanism.
  bool isRobot(std::size_t k) const { return is_robot_[k]; }
  /// One of them, at another pose: `X_CB`, body in the camera's optical frame.
  void drawAt(std::size_t k, const Transform& X_CB, tracking::DepthRender& render) const {
    render.draw(meshes_[k].second, X_CB);
  }

 private:
  const scene::Scene& scene_;
  std::vector<std::pair<std::size_t, geometry::TriangleMesh>> meshes_;  ///< with the index of their object
  std::vector<bool> is_robot_;
};

/// Depth images of a scene's robots and objects only, at any time. Owns the session.
class RobotView {
 public:
  /// People and pairs are removed. Throws ParseError and UsageError.
  explicit RobotView(scene_file::SceneDescription scene, const session::SessionOptions& options);
  /// Image at scene time t (s); valid until the next call. The camera may be another one in each call. Throws
  /// UsageError for a `camera` with distortion.
  const tracking::DepthImage& at(double t, const tracking::DepthCamera& camera);
  /// The same without objects; null: the scene has no mechanisms.
  const tracking::DepthImage* robotsAt(double t, const tracking::DepthCamera& camera);

 private:
  session::Session session_;
  SceneThings things_;
  std::optional<tracking::DepthRender> render_, robots_;
};

}  // namespace abstand::depth
