// Errors of cameras that are placed by an arm, against their stated spread.
#pragma once

#include <string>
#include <vector>

#include "tracking/depth/calibration/surface_pose.hpp"

namespace abstand::testing {

/// Where the camera is, and how many images it takes.
struct LinksCase {
  double distance{1.9};  ///< m, from the middle of the arm
  int images{1};         ///< each with another posture
  double aside{0.0};     ///< m, of the point that the camera looks at, from the middle of the arm
};

struct LinksTrial {
  bool is_taken{false};
  std::string refusal;
  double camera_error{0.0};  ///< m
  double near_error{0.0};    ///< m, largest of points 1 m from the arm along each axis
  tracking::SurfaceFit fit;
};

/// The camera's direction and the noise depend on the seed; a start 0.1 m and 10 degrees off.
LinksTrial linksTrial(const LinksCase& c, std::uint64_t seed);

}  // namespace abstand::testing
