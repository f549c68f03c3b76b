// What was read of the people's recordings, what was guessed, and why.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/view/recording_card.hpp"

class QAction;
class QComboBox;
class QTreeWidget;

namespace abstand::ui {

/// The choice of the recording where several were opened, and a block for each recording: file, length,
/// units, vertical axis, sides, stature, parts, gaps and warnings. Guesses and warnings stand out. GUI thread
/// only.
class RecordingPanel : public QWidget {
  Q_OBJECT

 public:
  /// `options`: asks how recordings shall be read; its button stands below.
  explicit RecordingPanel(QAction* options, QWidget* parent = nullptr);

  void open(const std::vector<view::RecordingCard>& cards);
  /// Files (absolute paths) that can be shown, and the one that is; fewer than two: no choice.
  void showChoice(const QStringList& files, const QString& shown);
  QTreeWidget& tree() const { return *tree_; }
  QComboBox* choice() const { return choice_; }

 Q_SIGNALS:
  /// The user chose another file.
  void wanted(const QString& file);

 private:
  QWidget* choice_row_;
  QComboBox* choice_;
  QTreeWidget* tree_;
};

}  // namespace abstand::ui
