// A small picture of the moment under the pointer.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/document/camera_view.hpp"

namespace abstand::ui {

class RecordingReview;
class Viewport;

/// Draws the bodies at a moment that the analysis has kept, as the camera stands; draws anew only for another
/// moment or camera. GUI thread only.
class TimePreview {
  Q_DECLARE_TR_FUNCTIONS(TimePreview)

 public:
  static constexpr int kWidth = 260;  ///< px

  /// Both outlive it.
  TimePreview(const RecordingReview& review, Viewport& viewport) : review_(review), viewport_(viewport) {}

  /// Rich text: the picture nearest to `t` (s), above `text`; `text` alone where there is none.
  QString tip(double t, const QString& text);

 private:
  const RecordingReview& review_;
  Viewport& viewport_;
  QString picture_;  ///< the last one, as an element of rich text
  double t_{0.0};    ///< s, of the last one
  long opened_{-1};
  CameraView camera_;
};

}  // namespace abstand::ui
