// Points of depth images in the scene, for the window.
#pragma once

#include <QColor>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/math/transform.hpp"
#include "ui/model/depth_port.hpp"

namespace abstand::ui {

/// What a measured point belongs to. A point of which this is not sure is one of the background.
enum class CloudPart : std::uint8_t { kBackground, kPerson, kRobot };

struct CloudPoint {
  Vector3f p_W{Vector3f::Zero()};  ///< m
  CloudPart part{CloudPart::kBackground};
  JointLook look{JointLook::kUnknown};  ///< of a person's point: that of the nearest joint
};

enum class CloudColours : std::uint8_t { kParts, kConfidence };

/// Colour of a point under a scheme; by confidence, what is not of the person is grey.
QRgb colourOf(const CloudPoint& point, CloudColours colours);
/// Colour of a joint and of the points that are nearest to it.
QRgb colourOf(JointLook look);

struct CloudRequest {
  double t{0.0};                ///< s, of the session
  int person{-1};               ///< index in DepthPort::people(), whose camera is drawn; -1: all cameras
  std::vector<Transform> X_WB;  ///< poses of all objects of the outline at `t`
};

struct DepthCloud {
  int person{-1};
  std::vector<std::size_t> images;  ///< CloudPort::imagesAt() of the request
  std::vector<CloudPoint> points;
  QString problem;  ///< why points are missing; empty: none are
};

/// GUI thread only; no call waits for an image.
class CloudPort {
 public:
  virtual ~CloudPort() = default;

  /// The images whose points a request for `t` (s) gets, one for each person, in the order of people().
  virtual std::vector<std::size_t> imagesAt(double t) const = 0;
  /// The points are read elsewhere and come by take(). Only the last one asked for is sure to come.
  virtual void ask(CloudRequest request) = 0;
  /// The newest one read since the last call; false: none.
  virtual bool take(DepthCloud& out) = 0;
};

}  // namespace abstand::ui
