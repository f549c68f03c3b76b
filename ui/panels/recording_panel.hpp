// What was read of the people's recordings, what was guessed, and why.
#pragma once

#include <QWidget>
#include <vector>

#include "core/view/recording_card.hpp"

class QAction;
class QTreeWidget;

namespace abstand::ui {

/// A block for each recording: file, length, units, vertical axis, sides, stature, parts, gaps and warnings.
/// Guesses and warnings stand out. GUI thread only.
class RecordingPanel : public QWidget {
  Q_OBJECT

 public:
  /// `options`: asks how recordings shall be read; its button stands below.
  explicit RecordingPanel(QAction* options, QWidget* parent = nullptr);

  void open(const std::vector<view::RecordingCard>& cards);
  QTreeWidget& tree() const { return *tree_; }

 private:
  QTreeWidget* tree_;
};

}  // namespace abstand::ui
