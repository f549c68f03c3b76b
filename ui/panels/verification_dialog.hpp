// The checks of the engine on this machine: question, progress and table.
#pragma once

#include <QDialog>
#include <QStringList>

#include "ui/model/verification_news.hpp"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace abstand::ui {

/// Does not block the window; deletes itself when it is closed. Somebody else checks: of wanted() until
/// news that ended, or fail(). GUI thread only.
class VerificationDialog : public QDialog {
  Q_OBJECT

 public:
  /// `families`: names of the families of checks.
  VerificationDialog(const QStringList& families, QWidget* parent);

  void add(const VerificationNews& news);
  void fail(const QString& problem);
  /// A page was saved.
  void say(const QString& text);
  bool waiting() const { return waiting_; }
  QTableWidget* table() const { return table_; }
  QLabel* sentence() const { return sentence_; }

 Q_SIGNALS:
  void wanted(const abstand::ui::VerificationRequest& request);
  void cancelled();
  /// The page of what was checked last.
  void pageWanted(const QString& file);

 private:
  void ask();
  void askFile();
  void stopWaiting();
  void setWaiting(bool waiting);
  void addRow(const VerificationRow& row);

  QComboBox *family_, *extent_;
  QLabel* sentence_;
  QTableWidget* table_;
  QProgressBar* progress_;
  QPushButton *start_, *save_, *stop_;
  int failed_{0};
  bool waiting_{false}, complete_{false};
};

}  // namespace abstand::ui
