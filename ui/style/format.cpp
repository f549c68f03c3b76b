// Numbers as the window shows them.
#include "ui/style/format.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace abstand::ui {

QString fixed(double value, int decimals) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  // A zero that was rounded from below has no sign.
  const double half_unit = 0.5 * std::pow(10.0, -decimals);
  return QLocale().toString(std::abs(value) < half_unit ? 0.0 : value, 'f', decimals);
}

QString millimetres(double metres, int decimals) { return fixed(metres * 1e3, decimals); }

QString millimetresWithUnit(double metres, int decimals) {
  return QCoreApplication::translate("format", "%1 mm").arg(millimetres(metres, decimals));
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
