// The measured points of a depth recording in the 3D view.
#pragma once

#include <QObject>
#include <optional>

#include "core/view/snapshot.hpp"
#include "ui/model/depth_cloud.hpp"

class QTimer;

namespace abstand::ui {

class Actions;
class DepthPanel;
class Viewport;

/// Asks for the points of the moment and shows them. Points of another image than that of the moment are
/// shown only while the clock runs. GUI thread only.
class CloudCommands : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    const Actions& actions;
    const DepthPanel& panel;  ///< whose person is chosen there
    Viewport& viewport;
    const view::SceneSnapshot& moment;
  };

  /// All outlive it.
  CloudCommands(const Sources& sources, QObject* parent);

  /// Null: no recording has depth images.
  void open(CloudPort* port);
  /// Follows the moment.
  void refresh();
  /// The points shown are those of the moment.
  bool isOfMoment() const;
  const DepthCloud& cloud() const { return cloud_; }

 Q_SIGNALS:
  void said(const QString& text);

 private:
  void poll();
  void show();
  void sayChoice();
  int person() const;
  bool hasCloudOf(const DepthCloud& cloud) const;

  Sources my_;
  CloudPort* port_{nullptr};
  QTimer* timer_;  ///< runs while points are awaited
  DepthCloud cloud_;
  bool shown_{false};
  std::optional<DepthCloud> wanted_;  ///< without points
  QString problem_;                   ///< said last
};

}  // namespace abstand::ui
