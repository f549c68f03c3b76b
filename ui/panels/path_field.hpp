// A field for the path of a file or a folder.
#pragma once

#include <QStringList>
#include <QWidget>

class QLineEdit;

namespace abstand::ui {

/// GUI thread only.
class PathField : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { kFile, kFiles, kRecording };  ///< kRecording: a file or a folder

  /// `name`: of the field, and with `_file` and `_folder` of the dialogs. `filter`: as QFileDialog.
  PathField(Kind kind, const QString& name, const QString& filter, QWidget* parent);

  QString path() const;
  /// Those of kFiles.
  QStringList paths() const;
  QLineEdit* field() const { return field_; }

 Q_SIGNALS:
  void changed();

 private:
  void choose(bool folder);

  Kind kind_;
  QString filter_;
  QLineEdit* field_;
};

}  // namespace abstand::ui
