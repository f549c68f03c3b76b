// What a planned depth camera would not see, for the window.
#pragma once

#include <QMetaType>
#include <QString>
#include <array>
#include <vector>

namespace abstand::ui {

/// Why a part is not seen, in the order of coverage::Cause; the first one: it is seen.
enum class HiddenBy { kSeen, kUnknown, kOutOfImage, kOutOfRange, kRobot, kThing, kSelf, kOtherPerson };
inline constexpr int kHiddenByCount = 8;

/// A kind of depth camera to choose.
struct SensorKind {
  QString name, title;  ///< as SensorPlan::sensor; for the user
  /// Slopes (x / z, y / z) of the edges of the image in the optical frame.
  double left{-0.55}, right{0.55}, top{-0.41}, bottom{0.41};
  double nearest{0.5}, farthest{8.0};  ///< m, range of depths
};

struct CoverageSpan {
  double from{0.0}, to{0.0};  ///< s
  HiddenBy cause{HiddenBy::kUnknown};
};

struct CoveragePart {
  QString name;
  std::array<double, kHiddenByCount> times{};    ///< shares of the times, by main cause
  std::array<double, kHiddenByCount> surface{};  ///< mean shares of the surface
  std::vector<CoverageSpan> spans;               ///< hidden, in order of time
  int longest{-1};                               ///< index of a span; -1: always seen
};

struct CoverageReport {
  double from{0.0}, to{0.0};  ///< s, of the recording
  int columns{0}, rows{0};    ///< of the images in which occluders were drawn
  std::vector<CoveragePart> parts;
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::CoverageReport)
