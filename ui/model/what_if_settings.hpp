// What the outcome of margins is judged with.
#pragma once

#include <QMetaType>

#include "core/config/number_rule.hpp"

namespace abstand::ui {

/// Part of the document. The options of `abstand tune` of the same names, with its defaults.
struct WhatIfSettings {
  double limit{0.0};          ///< m, clearance that a moving robot must keep; 0: no contact
  double reaction_time{0.1};  ///< s, from the frame that breaks a margin until the robot slows down
  double deceleration{5.0};   ///< rad/s^2 or m/s^2, of every joint on its path
  double restart_time{0.0};   ///< s, from the end of an intrusion until the robot goes on
  double calibration_error{
      0.0};             ///< m, between the frames of recording and robots; part of every uncertainty
  double latency{0.0};  ///< s, age of a person's pose when it arrives; part of every uncertainty

  template <class Self, class Visit>
  static void eachNumber(Self& o, Visit visit) {
    visit("limit", o.limit, config::NumberRule{0.0, 10.0, "m"});
    visit("reaction_time", o.reaction_time, config::NumberRule{0.0, 10.0, "s"});
    visit("deceleration", o.deceleration, config::NumberRule{1e-3, 1e6, "rad/s^2 or m/s^2"});
    visit("restart_time", o.restart_time, config::NumberRule{0.0, 1e3, "s"});
    visit("calibration_error", o.calibration_error, config::NumberRule{0.0, 10.0, "m"});
    visit("latency", o.latency, config::NumberRule{0.0, 10.0, "s"});
  }
  /// The distances of the recording are the same with both: only their judgement differs.
  bool sameAnalysis(const WhatIfSettings& other) const {
    WhatIfSettings mine = *this;
    mine.restart_time = other.restart_time;
    return mine == other;
  }
  bool operator==(const WhatIfSettings&) const = default;
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::WhatIfSettings)
