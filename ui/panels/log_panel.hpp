// The messages of the window, to be read again.
#pragma once

#include <QWidget>

#include "ui/model/log_book.hpp"

class QCheckBox;
class QPlainTextEdit;

namespace abstand::ui {

/// GUI thread only.
class LogPanel : public QWidget {
  Q_OBJECT

 public:
  /// The book outlives it.
  explicit LogPanel(const LogBook& book, QWidget* parent = nullptr);

  QPlainTextEdit* lines() const { return lines_; }
  QCheckBox* onlyProblems() const { return only_problems_; }

 private:
  void add(const LogEntry& entry);
  void showAll();
  void copy();

  const LogBook& book_;
  QPlainTextEdit* lines_;
  QCheckBox* only_problems_;
};

}  // namespace abstand::ui
