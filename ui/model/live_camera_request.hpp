// A live depth camera that shall be shown in a scene.
#pragma once

#include <QMetaType>
#include <QString>

namespace abstand::ui {

struct LiveCameraRequest {
  QString scene;       ///< file
  QString camera;      ///< camera file with the pose
  QString person;      ///< of the scene, whom the camera sees
  double height{0.0};  ///< m, of the person; 0: measured in the first images
  bool still{false};   ///< robots stand still where their motion begins; false: nobody knows where they are
  QString second{};    ///< camera file of a second camera; empty: one camera
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::LiveCameraRequest)
