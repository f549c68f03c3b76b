// Checks the engine on a thread beside the window.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>

#include "core/base/retained_threads.hpp"
#include "ui/model/verification_news.hpp"

namespace abstand::studio {

/// One run at a time, on one thread with low priority, so that the window and its loop keep their pace.
/// start() and cancel() wait for nobody; destruction waits until what was cancelled has noticed it, some
/// seconds at most. GUI thread only.
class VerificationJob : public QObject {
  Q_OBJECT

 public:
  /// Names of the families of checks.
  static QStringList families();

  VerificationJob();
  ~VerificationJob() override;

  void start(const ui::VerificationRequest& request);
  /// No news follow.
  void cancel();
  /// The results of the last complete run as page. Throws UsageError, also without such a run.
  void savePage(const QString& file) const;

 Q_SIGNALS:
  void news(const abstand::ui::VerificationNews& news);
  void failed(const QString& problem);

 private:
  struct Run;
  void poll();

  std::shared_ptr<Run> run_;  // null: cancelled, or never started
  RetainedThreads threads_;
  QTimer poll_;
};

}  // namespace abstand::studio
