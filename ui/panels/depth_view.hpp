// A depth image with the joints of the fitted body.
#pragma once

#include <QWidget>

#include "ui/model/depth_port.hpp"

namespace abstand::ui {

/// Marks of a joint: filled disc where it was seen, ring where it is inferred; joints that are not known have
/// no place. GUI thread only.
class DepthView : public QWidget {
  Q_OBJECT

 public:
  explicit DepthView(QWidget* parent = nullptr);

  void show(const DepthPicture& picture);
  /// Instead of a picture.
  void showMessage(const QString& text);
  void setBodyShown(bool shown);
  /// Where the image stands, logical pixels; empty without one.
  QRectF place() const;
  /// Where a joint of the picture is drawn.
  QPointF onScreen(const DepthJoint& joint) const;
  /// The joint under a point; null: none.
  const DepthJoint* jointAt(const QPointF& at) const;
  const DepthPicture& picture() const { return picture_; }
  const QString& message() const { return message_; }
  static QRgb colourOf(JointLook look);

  QSize sizeHint() const override { return {320, 240}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  const QImage& image() const { return body_ ? picture_.body : picture_.plain; }

  DepthPicture picture_;
  QString message_;
  bool body_{true};
};

/// "wrist_left: inferred, ± 34 mm".
QString jointText(const DepthJoint& joint);

}  // namespace abstand::ui
