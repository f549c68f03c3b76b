// Times by the clock.
#pragma once

#include <QString>

namespace abstand::ui {

/// Local time of day, "14:03:07.250". `utc`: s since 1970.
QString clockText(double utc);
/// With the date, in the order and language of the window.
QString dateText(double utc);

}  // namespace abstand::ui
