// The connection with another program in words.
#pragma once

#include <QString>

#include "ui/model/live_status.hpp"

namespace abstand::ui {

/// "connected, 60 moments/s, newest 12 ms old", "stale: nothing received for 0.8 s".
QString liveText(const LiveStatus& status);
/// What it means, in lines.
QString liveLines(const LiveStatus& status);
/// What is shown is not known to hold now: an alarm.
bool isStale(const LiveStatus& status);

}  // namespace abstand::ui
