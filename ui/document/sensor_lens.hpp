// Lens of a depth camera that a camera file describes.
#pragma once

#include <QString>

namespace abstand::ui {

/// Image size, lens and range. Numbers instead of the path of the file: a plan stays what it was computed
/// from.
struct SensorLens {
  static constexpr int kMaxPixels = 4096;  ///< along a side, as in a camera file

  QString name;                                       ///< of the file, for the user
  int width{640}, height{480};                        ///< pixels
  double fx{580.0}, fy{580.0}, cx{319.5}, cy{239.5};  ///< pixels; the centre of the first pixel is at 0
  double nearest{0.5}, farthest{8.0};                 ///< m, range of depths

  bool operator==(const SensorLens& other) const {
    return name == other.name && width == other.width && height == other.height && fx == other.fx &&
           fy == other.fy && cx == other.cx && cy == other.cy && nearest == other.nearest &&
           farthest == other.farthest;
  }
};

}  // namespace abstand::ui
