// Numbers for, and of, programs beside the window.
#pragma once

#include <QJsonObject>
#include <QString>
#include <string>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::studio {

/// As an argument: the digits that read back to the same double.
inline QString argumentOf(double value) { return QString::fromStdString(formatDouble(value)); }

/// `program`: for the message, e.g. "abstand tune". Throws UsageError where there is no number.
inline double numberIn(const QJsonObject& json, const char* key, const char* program) {
  const QJsonValue value = json.value(QLatin1String(key));
  if (!value.isDouble())
    throw UsageError(std::string("found no number `") + key + "` in the answer of " + program +
                     ", expected one");
  return value.toDouble();
}

}  // namespace abstand::studio
