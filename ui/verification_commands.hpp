// Help > Verify the engine.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/model/verification_news.hpp"

class QWidget;

namespace abstand::ui {

class VerificationDialog;

/// Somebody else checks: of wanted() until news that ended, fail() or cancelled(). One at a time. The dialog
/// belongs to `window`. GUI thread only.
class VerificationCommands : public QObject {
  Q_OBJECT

 public:
  explicit VerificationCommands(QWidget* window);

  /// Names of the families of checks that can be asked for alone.
  void setFamilies(const QStringList& families) { families_ = families; }
  void open();
  void add(const VerificationNews& news);
  void fail(const QString& problem);
  void say(const QString& text);
  /// Null: closed.
  VerificationDialog* dialog() const;

 Q_SIGNALS:
  void wanted(const abstand::ui::VerificationRequest& request);
  void cancelled();
  void pageWanted(const QString& file);

 private:
  QWidget* window_;
  QPointer<VerificationDialog> dialog_;
  QStringList families_;
};

}  // namespace abstand::ui
