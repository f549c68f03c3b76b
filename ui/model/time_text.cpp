// Times that somebody types.
#include "ui/model/time_text.hpp"

#include <QRegularExpression>

#include "ui/model/playback.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

std::optional<double> timeFromText(const QString& text, const Playback& playback) {
  static const QRegularExpression kFrame(QStringLiteral("^(?:f(?:rame)?|b(?:ild)?)\\s*(\\d{1,9})$"),
                                         QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression kMinutes(QStringLiteral("^(\\d{1,6}):([0-5]?\\d(?:[.,]\\d+)?)$"));
  static const QRegularExpression kSeconds(QStringLiteral("^(-?\\d+(?:[.,]\\d+)?)\\s*s?$"));
  const QString trimmed = text.trimmed();
  if (const auto frame = kFrame.match(trimmed); frame.hasMatch())
    return playback.start() + (frame.captured(1).toDouble() - 1.0) * playback.framePeriod();
  if (const auto minutes = kMinutes.match(trimmed); minutes.hasMatch()) {
    const auto seconds = numberFromText(minutes.captured(2));
    if (!seconds) return {};
    return 60.0 * minutes.captured(1).toDouble() + *seconds;
  }
  const auto seconds = kSeconds.match(trimmed);
  return seconds.hasMatch() ? numberFromText(seconds.captured(1)) : std::nullopt;
}

}  // namespace abstand::ui
