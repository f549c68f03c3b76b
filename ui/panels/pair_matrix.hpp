// The pairs of people and robots as a matrix.
#pragma once

#include <QWidget>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_matrix_model.hpp"

class QComboBox;
class QLabel;
class QTableView;

namespace abstand::ui {

class Selection;

/// A click selects the pair, a tick asks for it to be checked or not. GUI thread only.
class PairMatrix : public QWidget {
  Q_OBJECT

 public:
  explicit PairMatrix(Selection& selection, QWidget* parent = nullptr);

  /// The outline must live until the next open().
  void open(const view::SceneOutline& outline);
  /// Nothing is refreshed while it is not in front.
  void setInFront(bool in_front) { in_front_ = in_front; }
  void refresh(const view::SceneSnapshot& snapshot);

  PairMatrixModel* model() const { return model_; }
  QTableView* table() const { return table_; }
  QComboBox* bodies() const { return bodies_; }
  QLabel* counts() const { return counts_; }

 Q_SIGNALS:
  void checkWanted(int a, int b, bool checked);

 private:
  void openModel();

  Selection& selection_;
  const view::SceneOutline* outline_;
  bool in_front_{false};
  PairMatrixModel* model_;
  QTableView* table_;
  QComboBox* bodies_;
  QLabel* counts_;
};

}  // namespace abstand::ui
