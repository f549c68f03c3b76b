// Numbers as the window shows them.
#include "ui/style/format.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <numbers>

#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {
constexpr double kMillimetres = 1e3;                    // in a metre
constexpr int kMetreDecimals = 3, kRadianDecimals = 2;  // more than of millimetres and degrees
}  // namespace

QString fixed(double value, int decimals) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  // A zero that was rounded from below has no sign.
  const double half_unit = 0.5 * std::pow(10.0, -decimals);
  return QLocale().toString(std::abs(value) < half_unit ? 0.0 : value, 'f', decimals);
}

double lengthFactor() { return Units::shown().length() == LengthUnit::kMetre ? 1.0 : kMillimetres; }

int lengthDecimals(int decimals) {
  return decimals + (Units::shown().length() == LengthUnit::kMetre ? kMetreDecimals : 0);
}

QString lengthUnit() {
  return Units::shown().length() == LengthUnit::kMetre ? QStringLiteral("m") : QStringLiteral("mm");
}

QString lengthNumber(double metres, int decimals) {
  return fixed(metres * lengthFactor(), lengthDecimals(decimals));
}

QString lengthText(double metres, int decimals) {
  return QStringLiteral("%1 %2").arg(lengthNumber(metres, decimals), lengthUnit());
}

double angleFactor() { return Units::shown().angle() == AngleUnit::kRadian ? 1.0 : 180.0 / std::numbers::pi; }

int angleDecimals(int decimals) {
  return decimals + (Units::shown().angle() == AngleUnit::kRadian ? kRadianDecimals : 0);
}

QString angleUnit() {
  return Units::shown().angle() == AngleUnit::kRadian ? QStringLiteral(" rad") : QStringLiteral("°");
}

QString angleText(double radians, int decimals) {
  return fixed(radians * angleFactor(), angleDecimals(decimals)) + angleUnit();
}

QString secondsWithUnit(double seconds) {
  return QCoreApplication::translate("format", "%1 s").arg(fixed(seconds, 3));
}

std::optional<double> numberFromText(const QString& text) {
  QLocale plain = QLocale::c();
  plain.setNumberOptions(QLocale::RejectGroupSeparator);
  bool good = false;
  const double value = plain.toDouble(text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')), &good);
  if (!good || !std::isfinite(value)) return {};
  return value;
}

}  // namespace abstand::ui
