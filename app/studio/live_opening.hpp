// Finds a running server, or reads recorded moments, before the scene is loaded.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <atomic>
#include <memory>
#include <thread>

#include "app/viewer/live_record.hpp"
#include "app/viewer/viewer_link.hpp"

namespace abstand::studio {

/// Moments, and where they come from.
struct LiveSource {
  std::shared_ptr<viewer::LiveRecord> record;
  std::unique_ptr<viewer::ViewerLink> link;  ///< null: of a file
  QString name;                              ///< address or file
};

/// Looks for one source at a time, without blocking; a new one takes the place of an older one. GUI thread
/// only.
class LiveOpening : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  ~LiveOpening() override;

  /// found() or failed() follows. `scene`: file that the user gave; may be empty.
  void connectTo(const QString& address, const QString& scene);
  void readFile(const QString& file, const QString& scene);
  void abandon();

 Q_SIGNALS:
  /// The scene and a moment are known. `scene`: the one given, or stated by the source.
  void found(std::shared_ptr<abstand::studio::LiveSource> source, const QString& scene);
  void failed(const QString& problem);

 private:
  void look();
  void finish();

  std::shared_ptr<LiveSource> source_;
  QString scene_;
  QTimer timer_;
  double until_{0.0};  ///< s, for an answer
  std::jthread reading_;
  std::shared_ptr<std::atomic<bool>> current_;  ///< of the read that counts
};

/// Writes what is kept, on a thread of its own.
class MomentSaving : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  /// Ignored while one is being written.
  void start(std::shared_ptr<viewer::LiveRecord> record, const QString& file);

 Q_SIGNALS:
  void done(const QString& file);
  void failed(const QString& problem);

 private:
  bool busy_{false};
  std::jthread thread_;
};

}  // namespace abstand::studio
