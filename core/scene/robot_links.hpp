// The links that a robot file gives to a scene.
#pragma once

#include <string>
#include <vector>

#include "core/mechanism/mesh_reference.hpp"
#include "core/scene/scene_description.hpp"

namespace abstand {

struct RobotLinks {
  std::vector<LinkDescription> links;  ///< in the order of the frames
  std::vector<std::string> remarks;
};

/// A link named MECHANISM/FRAME for every frame that has geometry. Each geometry is a body of its own, so
/// that shapes stay exact: the second one of a frame is MECHANISM/FRAME/2, and so on. Where a frame has no
/// geometry of the `wanted` use, the other is taken: a body that is drawn is there. Visual meshes that are
/// not found are left out, or replaced by the frame's collision geometry, with a remark; collision meshes
/// that are not found are a ParseError that lists them all.
RobotLinks robotLinks(const Robot& robot, const std::string& mechanism, GeometryUse wanted,
                      const PackagePaths& packages);

}  // namespace abstand
