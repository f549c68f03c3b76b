// Tells when files have been written anew.
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QMap>
#include <QObject>
#include <QPair>
#include <QSet>
#include <QStringList>
#include <QTimer>

namespace abstand::studio {

/// An editor replaces a file, or writes it in pieces: a change counts once the file has rested for kSettleMs.
/// GUI thread only.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  static constexpr int kSettleMs = 400;

  explicit FileWatch(QObject* parent = nullptr);

  /// Instead of those before. Of a folder, the camera and the list of a depth clip are watched; files that do
  /// not exist are not.
  void watch(const QStringList& paths);

 Q_SIGNALS:
  /// Their content may be another one.
  void changed(const QStringList& files);

 private:
  using Stamp = QPair<QDateTime, qint64>;  // time of the last change, size
  static Stamp stampOf(const QString& file);
  void add(const QString& file);
  void settle();

  QFileSystemWatcher watcher_;
  QMap<QString, Stamp> known_;  // as it was watched
  QMap<QString, Stamp> waits_;  // as it was when it last changed
  QTimer timer_;
};

}  // namespace abstand::studio
