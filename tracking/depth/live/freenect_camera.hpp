// A Kinect v1 that looks now, through libfreenect.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace abstand::tracking {

/// The name of the camera, where a recording could stand, and in errors.
inline constexpr const char* kKinectSource = "live:kinect";

/// libfreenect is loaded when a camera is opened, so that a program without cameras needs none: the library
/// of Debian's libfreenect0.5, or what the loader finds under that name (fakenect). A build without its
/// header has no camera, and says so.
///
/// The numbers are millimetres by the device's own calibration (0: none) where the library knows it, else
/// disparities of 11 bits (2047: none), as fakenect plays them.
///
/// One thread at a time; the images come on the thread that calls serve().
class FreenectCamera {
 public:
  /// 640 x 480 numbers, row by row from the top, as long as the call lasts. Must not throw.
  using OnImage = std::function<void(const std::uint16_t* numbers)>;

  /// The first Kinect. Throws ParseError, in one true sentence: no library, no camera, no right to open it.
  explicit FreenectCamera(OnImage on_image);
  ~FreenectCamera();
  FreenectCamera(const FreenectCamera&) = delete;
  FreenectCamera& operator=(const FreenectCamera&) = delete;

  bool isRaw() const;
  /// Hands over what the camera sends; waits for a tenth of a second at most (fakenect: until the next image
  /// of its recording). False when the camera is gone.
  bool serve();
  /// The last error that the library told of; empty: none.
  std::string lastError() const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace abstand::tracking
