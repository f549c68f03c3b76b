// Silhouettes of a standing person, with a small and a large one for comparison.
#pragma once

#include <QPainterPath>
#include <QWidget>

#include "ui/document/body_preview.hpp"

namespace abstand::ui {

/// From the front and from the side, on a floor; to scale. GUI thread only.
class BodyView : public QWidget {
  Q_OBJECT

 public:
  explicit BodyView(QWidget* parent = nullptr);

  void show(const BodyPreview& preview);
  /// What the drawing says, line by line.
  QString text() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Outline in m, y up; `across`: index of the axis to the right.
  static QPainterPath outline(const BodyShape& shape, int across);
  int figuresHeight() const;
  void paintFigures(QPainter& painter, const QRectF& place, int across) const;

  BodyPreview preview_;
};

}  // namespace abstand::ui
