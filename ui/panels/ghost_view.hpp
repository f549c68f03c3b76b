// A stick figure from the front and from the side.
#pragma once

#include <QWidget>

#include "ui/model/import_probe.hpp"

namespace abstand::ui {

/// Left limbs are blue, right ones orange; a grid has cells of half a metre. GUI thread only.
class GhostView : public QWidget {
  Q_OBJECT

 public:
  explicit GhostView(QWidget* parent = nullptr);

  /// What is shown stays until the next call.
  void setFound(const ImportFound& found);
  /// Number of the frame that is shown.
  void setFrame(int frame);
  /// Bones of the frame that can be drawn.
  int bones() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bone {
    int from, to;
  };
  void paintFigure(QPainter& painter, const QRect& place, int across, const QString& title) const;
  bool known(const Bone& bone) const;

  ImportFound found_;
  std::vector<Bone> bones_;  ///< indices of found_.canonical
  int frame_{0};
};

}  // namespace abstand::ui
