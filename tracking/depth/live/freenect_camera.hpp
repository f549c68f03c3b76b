// Live Kinect v1 through libfreenect.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace abstand::tracking {

/// Name of the first camera, used instead of a recording's path, and in errors.
inline constexpr const char* kKinectSource = "live:kinect";

/// One of the connected Kinects.
struct KinectChoice {
  int place{1};        ///< in the order of the driver, from 1; it may change when cameras are plugged in
  std::string serial;  ///< if not empty, it decides
  bool operator==(const KinectChoice&) const = default;
};
/// Of a name: `live:kinect`, `live:kinect:N` with N from 1 to 9, or `live:kinect:SERIAL`. Throws UsageError.
KinectChoice kinectOf(const std::string& name);

/// libfreenect is loaded when a camera is opened, so that a program without cameras does not need it: the
/// library of Debian's libfreenect0.5, or what the loader finds under that name (fakenect). A build without
/// its header has no camera and reports that.
///
/// Values are millimetres from the device's calibration (0: none) if the library provides it, otherwise
/// 11-bit disparities (2047: none), as from fakenect.
///
/// One thread at a time; images are delivered on the thread that calls serve().
class FreenectCamera {
 public:
  /// 640 x 480 values, row by row from the top, valid during the call. Must not throw.
  using OnImage = std::function<void(const std::uint16_t* numbers)>;

  /// Opens the Kinect of that name (kinectOf). Throws UsageError, and ParseError with one sentence: no
  /// library, no such camera, or no permission.
  FreenectCamera(const std::string& name, OnImage on_image);
  ~FreenectCamera();
  FreenectCamera(const FreenectCamera&) = delete;
  FreenectCamera& operator=(const FreenectCamera&) = delete;

  bool isRaw() const;
  /// Delivers images from the camera; waits at most 0.1 s (fakenect: until the next image of its recording).
  /// False if the camera is disconnected.
  bool serve();
  /// Last error message of the library; empty: none.
  std::string lastError() const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace abstand::tracking
