// Depth images of the recording with the fitted body, for the window.
#pragma once

#include <QImage>
#include <QPointF>
#include <QString>
#include <cstddef>
#include <vector>

namespace abstand::ui {

enum class JointLook { kTracked, kInferred, kUnknown };

/// A joint of the person in one image.
struct DepthJoint {
  QString name;
  JointLook look{JointLook::kUnknown};
  QPointF at;          ///< pixels of the image, from its upper left corner; without meaning where unknown
  double spread{0.0};  ///< m, standard deviation along the worst axis; 0: not known
};

/// One depth image as it is shown.
struct DepthPicture {
  int person{-1};
  std::size_t image{0};  ///< index in the recording
  double t{0.0};         ///< s, of the session
  QImage plain, body;    ///< without and with the fitted body; both null where `problem` says why
  bool found{false};     ///< the body was found in this image
  std::vector<DepthJoint> joints;
  QString problem;
};

/// What there is of one person.
struct DepthSummary {
  QString person, camera, reason;   ///< the camera in numbers; source of its intrinsics and its pose
  std::size_t images{0}, found{0};  ///< of the recording, and those in which the body was found
};

/// People whose recording is one of depth images. GUI thread only; no call waits for an image.
class DepthPort {
 public:
  virtual ~DepthPort() = default;

  virtual const std::vector<DepthSummary>& people() const = 0;
  /// Index of the image that a person's pose at `t` (s) comes from.
  virtual std::size_t imageAt(int person, double t) const = 0;
  /// The image is read elsewhere and comes by take(). Only the last one asked for is sure to come.
  virtual void ask(int person, std::size_t image) = 0;
  /// The newest one read since the last call; false: none.
  virtual bool take(DepthPicture& out) = 0;
};

}  // namespace abstand::ui
