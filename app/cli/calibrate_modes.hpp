// Modes of abstand calibrate: ways to find the pose of a camera.
#pragma once

#include "app/cli/command_line.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::cli {

struct CalibrateArguments {
  std::filesystem::path input;  ///< points, or a scene
  std::filesystem::path camera, out;
  std::vector<std::filesystem::path> images;  ///< of a chessboard
  std::string squares, square;
  std::vector<std::string> boards;  ///< "X,Y,Z[,R,P,Y]" each
  bool intrinsics{false};
  std::filesystem::path links;   ///< a depth recording
  std::filesystem::path person;  ///< a recording of the person in world
  std::filesystem::path room;    ///< a depth recording of the same room by a camera with known pose
  std::string robot;
  robot_file::PackagePaths packages;
  std::uint64_t seed{1};
};

/// From points known both in the camera frame and in the world. Each of these writes --out, prints, and
/// throws ParseError and UsageError.
int calibrateByPoints(const CommandLine& line, const CalibrateArguments& args);
/// From images of a chessboard.
int calibrateByBoard(const CommandLine& line, const CalibrateArguments& args);
/// From depth images of a robot's links.
int calibrateByLinks(const CommandLine& line, const CalibrateArguments& args);
/// From depth images of a person who is known in the world.
int calibrateByPerson(const CommandLine& line, const CalibrateArguments& args);
/// From depth images of the room that a camera with known pose sees, too.
int calibrateByRoom(const CommandLine& line, const CalibrateArguments& args);

/// Writes the camera of --camera, or without it that of the recording, with its new pose and spread (m) to
/// --out, if requested. Throws ParseError.
void writePlaced(const CalibrateArguments& args, const tracking::DepthCamera& recorded, const Transform& X_WC,
                 double spread);
/// One line for people; `spread`: m.
std::string placedText(const Transform& X_WC, double spread);
/// The twelve numbers of `T_WC` in JSON.
std::vector<double> rowsOf(const Transform& X_WC);

}  // namespace abstand::cli
