// Robots and objects of a served scene, as live depth cameras see them.
#pragma once

#include <map>
#include <optional>

#include "app/depth/scene_things.hpp"
#include "app/live_depth/pose_window.hpp"
#include "app/viewer/viewer_link.hpp"

namespace abstand::live_depth {

/// Renders the robots and objects of a scene where a running `abstand serve` of the same scene knows them to
/// be: in all poses of the last PoseWindow::kWindow seconds, as the nearest surface of each pixel. What the
/// server does not know, as robots whose joint values are stale, is not rendered, and said. One thread; the
/// connection has its own.
class ServedThings {
 public:
  /// `file`: of `scene`. `server`: may be absent if the scene has no mechanisms, and its objects are where it
  /// puts them. Waits for an answer up to kAnswerWithin. Throws UsageError if there is none, if it is that of
  /// another scene, or if mechanisms have no server.
  ServedThings(const std::string& file, scene_file::SceneDescription scene,
               const session::SessionOptions& options, const std::optional<serve::Address>& server);

  /// Before at(), for images that came at `now` (s, viewer::steadySeconds()).
  void update(double now);
  /// m; the image of `camera`, which is the same object in each call, valid until the next update(). Null if
  /// nothing is known. Throws UsageError for a camera with distortion.
  const tracking::DepthImage* at(const tracking::DepthCamera& camera);
  /// The same of robots that did not move in the last PoseWindow::kWindow alone, or of all objects without a
  /// server. Null: nothing is known.
  const tracking::DepthImage* atRest(const tracking::DepthCamera& camera);

  /// One sentence for each robot whose pose became unknown, or known again, since the last call, and for the
  /// server. What changes within kSaidAfter is not said.
  std::vector<std::string> news();

  static constexpr double kAnswerWithin = 5.0, kSaidAfter = 0.5;  ///< s

 private:
  /// Whether something is known at present.
  struct Knowledge {
    bool is_known{true}, is_said{true};
    double since{-kInfinity};  ///< s, of is_known
  };
  /// Of one camera.
  struct View {
    explicit View(const tracking::DepthCamera& camera) : render(camera) {}
    tracking::DepthRender render;
    bool is_current{false};
  };
  using Views = std::map<const tracking::DepthCamera*, View>;
  bool isKnown() { return !window_ || knowledge_[{}].is_known; }
  void connect(const std::string& file, const serve::Address& server);
  void note(const std::string& robot, bool is_known, double now);
  void draw(const Transform& X_CW, tracking::DepthRender& render) const;

  session::Session session_;
  depth::SceneThings things_;
  std::string server_;                          ///< its address
  std::map<std::string, Knowledge> knowledge_;  ///< of each robot; the empty name: of the server
  std::vector<std::string> news_;
  Views views_, at_rest_;
  std::shared_ptr<viewer::LiveRecord> record_;  ///< null: no server
  std::optional<PoseWindow> window_;
  std::unique_ptr<viewer::ViewerLink> link_;
};

}  // namespace abstand::live_depth
