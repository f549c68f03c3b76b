// What the window has said since the program started.
#include "ui/model/log_book.hpp"

namespace abstand::ui {

namespace {
constexpr qint64 kRepeatedMs = 1000;
}

void LogBook::add(LogLevel level, const QString& text) {
  LogEntry entry{QDateTime::currentDateTime(), level, text.simplified()};
  if (entry.text.isEmpty()) return;
  if (!entries_.empty() && entries_.back().text == entry.text && entries_.back().level == level &&
      entries_.back().at.msecsTo(entry.at) < kRepeatedMs)
    return;
  entries_.push_back(entry);
  if (entries_.size() > kMaxEntries) entries_.pop_front();
  Q_EMIT added(entry);
}

QString logLine(const LogEntry& entry) {
  return QStringLiteral("%1  %2%3")
      .arg(entry.at.toString(QStringLiteral("hh:mm:ss.zzz")),
           entry.level == LogLevel::kProblem ? QStringLiteral("⚠ ") : QString(), entry.text);
}

}  // namespace abstand::ui
