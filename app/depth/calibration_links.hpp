// Links of one robot of a scene as moving surfaces.
#pragma once

#include <memory>

#include "app/session/session.hpp"

namespace abstand::depth {

/// Owns a session with only that robot.
class CalibrationLinks {
 public:
  /// `robot`: name of a mechanism of the scene; may be empty if there is only one. Throws UsageError if there
  /// is no such robot or it has no links, and ParseError for its files.
  CalibrationLinks(scene_file::SceneDescription scene, const std::string& robot,
                   const session::SessionOptions& options);

  const std::string& robot() const { return robot_; }
  const std::vector<const geometry::Surface*>& surfaces() const { return surfaces_; }
  /// Poses of surfaces() at time t (s) of the scene, in world.
  std::vector<Transform> at(double t);

 private:
  std::string robot_;
  std::unique_ptr<session::Session> session_;
  std::vector<const geometry::Surface*> surfaces_;
};

}  // namespace abstand::depth
