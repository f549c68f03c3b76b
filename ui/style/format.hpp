// Numbers as the window shows them: lengths, angles, seconds, in the user's locale.
#pragma once

#include <QString>
#include <optional>

namespace abstand::ui {

/// A length in the shown unit without the unit; a dash for a value that is not finite. `decimals`: of
/// millimetres.
QString lengthNumber(double metres, int decimals = 1);
/// The same with " mm" or " m".
QString lengthText(double metres, int decimals = 1);
/// "mm" or "m"; how many of them a metre has; and how many decimals are shown instead of `decimals` of
/// millimetres.
QString lengthUnit();
double lengthFactor();
int lengthDecimals(int decimals);
/// "12.3°" or "0.215 rad"; `decimals`: of degrees.
QString angleText(double radians, int decimals = 1);
/// "°" or " rad", as a suffix; how many of them a radian has; and how many decimals are shown.
QString angleUnit();
double angleFactor();
int angleDecimals(int decimals);
/// Any value with a fixed number of decimals; a dash for a value that is not finite.
QString fixed(double value, int decimals);
/// "12.340 s".
QString secondsWithUnit(double seconds);
/// A typed number with a decimal point or comma, whatever the language; no groups of digits.
std::optional<double> numberFromText(const QString& text);

}  // namespace abstand::ui
