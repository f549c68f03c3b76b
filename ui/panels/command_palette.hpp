// Finds a command by words.
#pragma once

#include <QDialog>
#include <vector>

class QAction;
class QLineEdit;
class QListWidget;

namespace abstand::ui {

class Actions;

/// Lists the commands whose group, text and tip contain all words of the field. Enter or a click runs one;
/// what cannot be done now is grey. Deletes itself when it is closed. GUI thread only.
class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  /// The actions outlive it.
  CommandPalette(const Actions& actions, QWidget* parent);

  QLineEdit* field() const { return field_; }
  QListWidget* list() const { return list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Command {
    QAction* action;
    QString text;   ///< "File › Report…  Ctrl+Alt+R"
    QString words;  ///< what is searched
  };
  void listThoseWith(const QString& words);
  void run();

  std::vector<Command> commands_;
  QLineEdit* field_;
  QListWidget* list_;
};

}  // namespace abstand::ui
