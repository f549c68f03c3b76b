// Links of a scene from a robot file.
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

/// A link MECHANISM/FRAME for every frame with geometry. Each geometry is a body of its own, so that shapes
/// stay exact: the second one of a frame is MECHANISM/FRAME/2, and so on. If a frame has no geometry of the
/// `wanted` use, the other one is used, as a visible body exists. Missing visual meshes are replaced by the
/// frame's collision geometry, with a remark, or the frame is added to `missing`; missing collision meshes
/// are a ParseError that lists them all. Frames in `bodiless` get no body and are never missing.
RobotLinks robotLinks(const robot_file::Robot& robot, const std::string& mechanism,
                      robot_file::GeometryUse wanted, const robot_file::PackagePaths& packages,
                      const std::vector<std::string>& bodiless = {});

/// Names (0: the base) of the frames with geometry in the robot file, without `bodiless`.
std::vector<std::string> framesWithGeometry(const robot_file::Robot& robot,
                                            const std::vector<std::string>& bodiless);

/// "14 of 16 links of kuka have no body: a, b, ... (found no file ...); ...", or empty if none is missing.
std::string missingBodiesText(const MechanismDescription& mechanism);

/// Moves the links to their mechanism, and adds texts to `remarks`.
void takeLinks(RobotLinks links, MechanismDescription& mechanism, std::vector<std::string>& remarks);

}  // namespace abstand::scene_file
