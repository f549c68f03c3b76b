// The table of pairs with its filter.
#pragma once

#include <QWidget>

#include "ui/model/pair_table_model.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

namespace abstand::ui {

class Selection;

/// Sorted by distance at first, and of people and robots where there are such pairs. Shows only the pairs of
/// chosen objects; choosing a row chooses both. GUI thread only.
class PairPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PairPanel(Selection& selection, QWidget* parent = nullptr);

  void open(const view::SceneOutline& outline);
  /// Rows keep their places until sortAgain().
  void refresh(const view::SceneSnapshot& snapshot);
  void sortAgain() { filter_->sortAgain(); }
  PairTableModel* model() const { return model_; }
  long shownStep() const { return model_->shownStep(); }
  QTableView* table() const { return table_; }
  QLineEdit* filterBox() const { return filter_box_; }
  QComboBox* classBox() const { return class_box_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void chooseCurrent();
  void followSelection();
  void showClass();
  void showCount();

  Selection& selection_;
  PairTableModel* model_;
  PairFilter* filter_;
  QLineEdit* filter_box_;
  QComboBox* class_box_;
  QToolButton* all_;
  QLabel* count_;
  QTableView* table_;
  bool choosing_{false};
  int wanted_{static_cast<int>(PairClass::kPersonRobot)};  // class chosen by the user; outlives the scene
};

}  // namespace abstand::ui
