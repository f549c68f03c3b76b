// Says how an unknown recording is read, and shows the skeleton that comes of it.
#pragma once

#include <QDialog>
#include <thread>

#include "ui/model/import_probe.hpp"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QSlider;
class QTableWidget;

namespace abstand::ui {

class GhostView;

/// Every change reads the file again on a thread of its own; the newest wish wins. GUI thread only.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  ImportDialog(const QString& file, ImportReader reader, QWidget* parent);
  ~ImportDialog() override;

  const ImportWish& wish() const { return wish_; }
  const ImportFound& found() const { return found_; }
  /// The user has said which joint is which.
  bool hasOwnJoints() const { return !wish_.joints.isEmpty(); }
  /// The file has not been read as wished yet.
  bool reading() const { return busy_; }
  GhostView* ghost() const { return ghost_; }

 private:
  QComboBox* choice(const char* name, const QStringList& values);
  void read();
  void take(const ImportFound& found);
  void showJoints();
  void takeJoint(int row, const QString& name);
  QString summary() const;

  QString file_;
  ImportReader reader_;
  ImportWish wish_, reading_;
  ImportFound found_;
  bool busy_{false};
  QComboBox *units_, *up_, *mirror_;
  QTableWidget* joints_;
  GhostView* ghost_;
  QSlider* time_;
  QLabel* summary_;
  QDialogButtonBox* buttons_;
  std::jthread thread_;  // last: joined before the others are destroyed
};

}  // namespace abstand::ui
