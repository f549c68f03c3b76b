// Numbers as the window shows them: millimetres, newtons, seconds, in the user's locale.
#pragma once

#include <QString>

namespace abstand::ui {

/// Metres shown as millimetres without the unit; a dash for a value that is not finite.
QString millimetres(double metres, int decimals = 1);
/// The same with " mm".
QString millimetresWithUnit(double metres, int decimals = 1);
/// Any value with a fixed number of decimals; a dash for a value that is not finite.
QString fixed(double value, int decimals);
/// "12.340 s".
QString secondsWithUnit(double seconds);

}  // namespace abstand::ui
