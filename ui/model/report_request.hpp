// A report that the user wants.
#pragma once

#include <QMetaType>
#include <QString>
#include <string>

namespace abstand::ui {

/// Options of `abstand tune --report`; its defaults.
struct ReportRequest {
  QString file;               ///< absolute path of the HTML page
  std::string margin_set;     ///< the present margins, as a file of margins says them
  double limit{0.0};          ///< m, clearance that a moving robot must keep
  double reaction_time{0.1};  ///< s, from the frame that breaks a margin until the robot slows down
  double deceleration{5.0};   ///< rad/s^2 or m/s^2, of every joint on its path
  double restart_time{0.0};   ///< s, from the end of an intrusion until the robot goes on
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::ReportRequest)
