// The pose of a depth camera, as `abstand calibrate` finds it.
#pragma once

#include <QByteArray>
#include <QMetaType>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/math/transform.hpp"

namespace abstand::ui {

/// What both the camera and the world know.
enum class CalibrationMode { kRoom, kPerson, kLinks, kChessboard, kPoints };
inline constexpr int kCalibrationModes = 5;

/// What is asked for. Each mode needs some of it.
struct CalibrationRequest {
  CalibrationMode mode{CalibrationMode::kRoom};
  QString camera;      ///< camera file with the lens, and with the first pose for kRoom and kLinks; may be
                       ///< empty where the depth recording has it
  QString clip;        ///< depth recording of the camera; for kPoints the table of points
  QString reference;   ///< kRoom, kPerson: the recording that is known in the world
  QString robot;       ///< kLinks: of the scene that is shown
  QStringList images;  ///< kChessboard
  int columns{8}, rows{5};                                            ///< squares of the board
  double square{0.03};                                                ///< m, side of one
  Vector3d board_xyz{Vector3d::Zero()}, board_rpy{Vector3d::Zero()};  ///< m, rad, of the board in the world
};

/// A number that says how good the answer is.
struct CalibrationFact {
  enum class Kind {
    kPoints,       ///< number of points, corners or joints that were used
    kImages,       ///< number of images
    kWorst,        ///< m, largest residual; of the line `where` of a table
    kWorstPixels,  ///< pixels, likewise; of the image `where`
    kShared,       ///< share of the surfaces of one camera that the other one sees
    kAgreeing,     ///< share of the common view in which both agree
    kExplained,    ///< share of the robot's surface that should be visible and was found
    kMoved,        ///< m, from the first pose
    kTurned,       ///< rad, likewise
    kClock,        ///< s, to be added to the times of the camera
    kPersonMoved   ///< m, way of the person
  };
  Kind kind;
  double value{0.0};
  QString where;
};

struct CalibrationAnswer {
  double residual{0.0};  ///< RMS: m; of a chessboard pixels
  bool in_pixels{false};
  Vector3d xyz{Vector3d::Zero()};  ///< m, of the camera in the world
  double spread{0.0};    ///< m, standard deviation of a point's position along an axis, due to the pose
  double widening{0.0};  ///< m, by which `spread` widens margins at most
  std::vector<CalibrationFact> facts;
  QStringList warnings;  ///< as the program says them
  QByteArray camera;     ///< content of the camera file
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::CalibrationRequest)
Q_DECLARE_METATYPE(abstand::ui::CalibrationAnswer)
