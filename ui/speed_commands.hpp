// Margins > Propose speeds.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/model/speed_proposal.hpp"

class QWidget;

namespace abstand::ui {

class SpeedDialog;

/// Somebody else computes speeds: of wanted() until done(), fail() or cancelled(). One at a time. The dialog
/// belongs to `window`. GUI thread only.
class SpeedCommands : public QObject {
  Q_OBJECT

 public:
  explicit SpeedCommands(QWidget* window);

  /// Shows the dialog. Speeds are for a person beside a robot that moves.
  void open();
  /// What was shown is no longer there: the dialog closes.
  void close();
  void done(const SpeedProposal& proposal);
  void fail(const QString& problem);
  /// Null: closed.
  SpeedDialog* dialog() const;

 Q_SIGNALS:
  void wanted(const abstand::ui::SpeedRequest& request);
  void cancelled();
  void picked(double t);  ///< s

 private:
  QWidget* window_;
  QPointer<SpeedDialog> dialog_;
};

}  // namespace abstand::ui
