// What the window has said since the program started.
#pragma once

#include <QDateTime>
#include <QObject>
#include <deque>

namespace abstand::ui {

enum class LogLevel { kNote, kProblem };

struct LogEntry {
  QDateTime at;  ///< wall time
  LogLevel level{LogLevel::kNote};
  QString text;  ///< one line
};

/// The newest entries, in order. GUI thread only.
class LogBook : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMaxEntries = 5000;

  using QObject::QObject;

  /// Line breaks become blanks. The same text as the last entry is not repeated within a second.
  void add(LogLevel level, const QString& text);
  const std::deque<LogEntry>& entries() const { return entries_; }

 Q_SIGNALS:
  void added(const abstand::ui::LogEntry& entry);

 private:
  std::deque<LogEntry> entries_;
};

/// "12:34:56.789  text"; a problem has a mark before its text.
QString logLine(const LogEntry& entry);

}  // namespace abstand::ui
