// The plot of a margin curve with its handle.
#pragma once

#include <QWidget>

namespace abstand::ui {

class MarginCurve;

/// Left axis: share of time stopped; right axis: false and missed stops. GUI thread only.
class CurveArea : public QWidget {
  Q_OBJECT

 public:
  /// Belongs to the curve.
  explicit CurveArea(MarginCurve& curve);

  double xOf(double metres) const;
  double metresAt(int x) const;
  /// Middle of the handle.
  QPoint handle() const;
  QSize minimumSizeHint() const override { return {240, 60}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  QRectF plot() const;
  void drag(int x);

  MarginCurve& curve_;
  bool held_{false};
};

}  // namespace abstand::ui
