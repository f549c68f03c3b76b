#include "ui/style/clock_text.hpp"

#include <QDateTime>
#include <QLocale>
#include <cmath>

namespace abstand::ui {

namespace {

constexpr double kMilliseconds = 1e3;  // per second

QDateTime momentOf(double utc) {
  return QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(std::floor(kMilliseconds * utc + 0.5)));
}

}  // namespace

QString clockText(double utc) { return momentOf(utc).toString(QStringLiteral("HH:mm:ss.zzz")); }

QString dateText(double utc) {
  const QDateTime moment = momentOf(utc);
  return QLocale().toString(moment.date(), QLocale::LongFormat) + QLatin1Char(' ') + clockText(utc);
}

}  // namespace abstand::ui
