// The links that a robot file gives to a scene.
#pragma once

#include <string>
#include <vector>

#include "app/scene_file/scene_description.hpp"
#include "core/robot_file/mesh_reference.hpp"

namespace abstand::scene_file {

struct RobotLinks {
  std::vector<LinkDescription> links;  ///< in the order of the frames
  std::vector<BodilessLink> missing;   ///< in the order of the frames
  std::vector<std::string> remarks;
};

/// A link named MECHANISM/FRAME for every frame that has geometry. Each geometry is a body of its own, so
/// that shapes stay exact: the second one of a frame is MECHANISM/FRAME/2, and so on. Where a frame has no
/// geometry of the `wanted` use, the other is taken: a body that is drawn is there. Visual meshes that are
/// not found are replaced by the frame's collision geometry, with a remark, or leave their frame among the
/// `missing`; collision meshes that are not found are a ParseError that lists them all. The frames named in
/// `bodiless` get no body and are never missing.
RobotLinks robotLinks(const robot_file::Robot& robot, const std::string& mechanism,
                      robot_file::GeometryUse wanted, const robot_file::PackagePaths& packages,
                      const std::vector<std::string>& bodiless = {});

/// The frames that have geometry in the robot file, by name (0: the base), without `bodiless`.
std::vector<std::string> framesWithGeometry(const robot_file::Robot& robot,
                                            const std::vector<std::string>& bodiless);

/// "14 of 16 links of kuka have no body: a, b, ... (found no file ...); ...", or empty where none is missing.
std::string missingBodiesText(const MechanismDescription& mechanism);

/// Gives the links to their mechanism, and what is to say of them to `remarks`.
void takeLinks(RobotLinks links, MechanismDescription& mechanism, std::vector<std::string>& remarks);

}  // namespace abstand::scene_file
