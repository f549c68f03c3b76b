// File > Open a live depth camera.
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include "core/view/snapshot.hpp"
#include "ui/model/live_camera_request.hpp"

class QWidget;

namespace abstand::ui {

class LiveCameraDialog;

/// Somebody else starts the camera: of wanted() until succeed(), fail() or cancelled(). The dialog belongs to
/// `window`. GUI thread only.
class LiveCameraCommands : public QObject {
  Q_OBJECT

 public:
  explicit LiveCameraCommands(QWidget* window);

  /// What is shown, with its file.
  void setScene(const QString& scene, const view::SceneOutline& outline);
  /// Shows the dialog, as it was last.
  void open();
  void say(const QString& progress);
  /// The camera sends images.
  void succeed();
  void fail(const QString& problem);
  /// Null: closed.
  LiveCameraDialog* dialog() const;

 Q_SIGNALS:
  void wanted(const abstand::ui::LiveCameraRequest& request);
  void cancelled();

 private:
  QWidget* window_;
  QStringList people_;
  LiveCameraRequest last_;
  QPointer<LiveCameraDialog> dialog_;
};

}  // namespace abstand::ui
