// A depth frame as libfreenect's `record` dumps it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tracking/depth/camera/depth_image.hpp"

namespace abstand::tracking {

/// Pixels of a Kinect v1's depth, as its drivers hand them over.
inline constexpr int kKinectWidth = 640, kKinectHeight = 480;

/// What the numbers of a dump are. `record` writes the driver's buffer as it is, so the low byte comes first,
/// against the rules of PGM; other programs write the high byte first.
struct FreenectUnits {
  bool is_raw{true};  ///< 11 bits of disparity, 2047: none; else millimetres, 0: none
  bool is_low_first{true};
  std::string reason;
};

struct FreenectImage {
  DepthImage image;
  FreenectUnits units;
};

/// m. 1 / (3.3309495161 - 0.0030711016 raw), the line that ROS's kinect_node had fitted (OpenKinect wiki,
/// "Imaging Information"; within 2 cm up to 2.5 m, 10 cm at 4 m); 0 for 2047 and where the line has no depth
/// below 10 m.
float freenectDepth(int raw);
/// The disparity whose freenectDepth() is nearest in its own steps to `z` (m); 2047 where there is none. The
/// line has depths from 0.3 to 10 m.
int freenectRaw(float z);

/// A frame as `record` dumps it: a PGM of disparities, the low byte first.
std::string freenectDump(const DepthImage& image);

/// A PGM of type P5 with two bytes a pixel. Units are found in the image where they are not given: numbers up
/// to 2047 of which not fewer are 2047 than 0 are disparities. Throws ParseError.
FreenectImage parseFreenectDepth(std::string_view bytes, const std::string& file,
                                 const std::optional<FreenectUnits>& units = {});

}  // namespace abstand::tracking
