// Permitted speeds of the robots' program, as `abstand tune` gives them.
#pragma once

#include <QMetaType>
#include <QString>
#include <vector>

namespace abstand::ui {

/// What is asked for.
struct SpeedRequest {
  QString rule{QStringLiteral("both")};  ///< "both", "separation" or "contact"
  double segment{1.0};                   ///< s, length of the segments that get one speed each
  QString folder;                        ///< for motion files at these speeds, proven by replay; empty: none
};

/// A segment of the program.
struct SpeedRow {
  double t0{0.0}, t1{0.0};                     ///< s
  double scale{1.0};                           ///< share of the recorded speed; 0: the robot has to stand
  double by_separation{1.0}, by_contact{1.0};  ///< by each criterion alone
  bool limited{false};                         ///< the rest says by what
  double t{0.0};                               ///< s, the moment that limits it
  QString part;                                ///< of the person
  bool by_contact_limit{false};                ///< else by the protective distance
};

struct SpeedProposal {
  std::vector<SpeedRow> rows;
  double recorded{0.0};        ///< s, the program as recorded
  double permitted{0.0};       ///< s, at these speeds; infinite: it has to stand somewhere
  std::vector<QString> files;  ///< motions that were written, one a robot
  QString not_written;         ///< why there are none although they were asked for; empty: they are there
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::SpeedRequest)
Q_DECLARE_METATYPE(abstand::ui::SpeedProposal)
