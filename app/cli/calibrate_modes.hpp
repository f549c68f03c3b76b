// The ways in which abstand calibrate finds where a camera stands.
#pragma once

#include "app/cli/command_line.hpp"
#include "tracking/depth/camera/depth_camera.hpp"

namespace abstand::cli {

struct CalibrateArguments {
  std::filesystem::path input;  ///< points, or a scene
  std::filesystem::path camera, out;
  std::vector<std::filesystem::path> images;  ///< of a chessboard
  std::string squares, square;
  std::vector<std::string> boards;  ///< X,Y,Z[,R,P,Y] each
  bool intrinsics{false};
  std::filesystem::path links;  ///< a depth recording
  std::string robot;
  robot_file::PackagePaths packages;
  std::uint64_t seed{1};
};

/// By points that are known both to the camera and in the world. Each writes --out and prints, and throws
/// ParseError and UsageError.
int calibrateByPoints(const CommandLine& line, const CalibrateArguments& args);
/// By pictures of a chessboard.
int calibrateByBoard(const CommandLine& line, const CalibrateArguments& args);
/// By depth images of a robot's links.
int calibrateByLinks(const CommandLine& line, const CalibrateArguments& args);

/// The twelve numbers of `T_WC` in JSON.
std::vector<double> rowsOf(const Transform& X_WC);

}  // namespace abstand::cli
