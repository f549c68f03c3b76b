// The way back from a changed value to that of the scene file.
#pragma once

#include <QToolButton>

namespace abstand::ui {

/// Keeps its place while it is hidden. GUI thread only.
class BackButton : public QToolButton {
  Q_OBJECT

 public:
  /// Of a field with an object name, and as the user calls it.
  BackButton(const QWidget* field, const QString& name, QWidget* parent);

  /// Visible if the value differs from that of the scene file, which the tooltip states.
  void show(bool differs, const QString& scene);
};

}  // namespace abstand::ui
