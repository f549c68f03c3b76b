// Numbers as the window shows them: millimetres, newtons, seconds, in the user's locale.
#pragma once

#include <QString>
#include <optional>

namespace abstand::ui {

/// Metres shown as millimetres without the unit; a dash for a value that is not finite.
QString millimetres(double metres, int decimals = 1);
/// The same with " mm".
QString millimetresWithUnit(double metres, int decimals = 1);
/// Any value with a fixed number of decimals; a dash for a value that is not finite.
QString fixed(double value, int decimals);
/// "12.340 s".
QString secondsWithUnit(double seconds);
/// A typed number with a decimal point or comma, whatever the language; no groups of digits.
std::optional<double> numberFromText(const QString& text);

}  // namespace abstand::ui
