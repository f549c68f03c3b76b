// A tour of the window, step by step.
#pragma once

#include <QDialog>
#include <vector>

class QDockWidget;
class QLabel;
class QPushButton;

namespace abstand::ui {

/// Raises the dock of each step and says in two sentences what it is for; the window stays usable. GUI thread
/// only.
class Tour : public QDialog {
  Q_OBJECT

 public:
  struct Step {
    QDockWidget* dock;  ///< null: the 3D view
    QString title, text;
  };

  Tour(std::vector<Step> steps, QWidget* parent);

  int step() const { return step_; }
  QPushButton* next() const { return next_; }
  QPushButton* back() const { return back_; }

 private:
  void goTo(int step);

  std::vector<Step> steps_;
  int step_{0};
  QLabel *title_, *text_, *count_;
  QPushButton *back_, *next_;
};

}  // namespace abstand::ui
