// The dialog in which commands get other keys.
#pragma once

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace abstand::ui {

class Actions;

/// Lists every command with its keys. A key that another command has is named before it is taken from there.
/// Changes hold at once and are kept in the settings. GUI thread only; deletes itself when it is closed.
class KeyEditor : public QDialog {
  Q_OBJECT

 public:
  KeyEditor(const Actions& actions, QWidget* parent);

 private:
  void build();
  void list(const QString& words);
  /// Of the row that is chosen; null: none.
  QAction* chosen() const;
  void showChosen();
  void showClash();
  void assign();
  void giveDefault();
  void giveAllDefaults();
  /// Gives the keys to the action alone, and keeps that.
  void give(QAction* action, const QList<QKeySequence>& keys);
  void showKeys();

  const Actions& actions_;
  QLineEdit* field_;
  QTreeWidget* list_;
  QKeySequenceEdit* keys_;
  QLabel* said_;
  QPushButton *assign_, *default_, *all_;
};

}  // namespace abstand::ui
