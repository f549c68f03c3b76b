// Permitted speeds of the robots' program: question, wait and table.
#pragma once

#include <QDialog>

#include "ui/model/speed_proposal.hpp"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace abstand::ui {

/// Does not block the window; deletes itself when it is closed. Somebody else computes: of wanted() until
/// show() or fail(). GUI thread only.
class SpeedDialog : public QDialog {
  Q_OBJECT

 public:
  explicit SpeedDialog(QWidget* parent);

  void show(const SpeedProposal& proposal);
  void fail(const QString& problem);
  bool waiting() const { return waiting_; }
  QTableWidget* table() const { return table_; }
  QLabel* sentence() const { return sentence_; }

 Q_SIGNALS:
  void wanted(const abstand::ui::SpeedRequest& request);
  void cancelled();
  /// The moment that limits a segment, s.
  void picked(double t);

 private:
  void ask(const QString& folder);
  void askFolder();
  void stopWaiting();
  void setWaiting(bool waiting);

  QComboBox* rule_;
  QDoubleSpinBox* segment_;
  QLabel* sentence_;
  QTableWidget* table_;
  QProgressBar* busy_;
  QPushButton *compute_, *save_, *stop_;
  SpeedProposal shown_;
  bool waiting_{false};
};

}  // namespace abstand::ui
