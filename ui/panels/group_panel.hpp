// Groups of pairs: run, pause and stop them, and take single pairs out and back in.
#pragma once

#include <QWidget>

#include "core/view/snapshot.hpp"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace abstand::ui {

/// A row for each group, and under it a row for each of its pairs; pairs of no group stand under "In no
/// group". Buttons act on the selected rows. What is not running is stale, and says so. GUI thread only.
class GroupPanel : public QWidget {
  Q_OBJECT

 public:
  explicit GroupPanel(QWidget* parent = nullptr);

  void open(const view::SceneOutline& outline);
  void refresh(const view::SceneSnapshot& snapshot);
  QTreeWidget* tree() const { return tree_; }

 Q_SIGNALS:
  void stateWanted(int group, abstand::view::PairGroupState state);
  void addWanted(int group, int pair);
  void removeWanted(int pair);

 private:
  void fill(const view::SceneSnapshot& snapshot);
  void order(view::PairGroupState state);
  void removeSelected();
  void enableButtons();

  QLabel* head_;
  QTreeWidget* tree_;
  QPushButton *run_, *pause_, *stop_, *remove_, *add_;
  std::vector<QString> groups_, pairs_;
  std::vector<int> shown_group_;  ///< of each pair, as the tree has it
};

}  // namespace abstand::ui
