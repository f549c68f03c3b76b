#include "ui/panels/depth_view.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "ui/model/depth_cloud.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr double kMarkRadius = 3.5, kReach = 9.0;  // px
constexpr QRgb kDark = 0xff10141a;

}  // namespace

QRgb DepthView::colourOf(JointLook look) { return ui::colourOf(look); }

QString jointText(const DepthJoint& joint) {
  if (joint.look == JointLook::kUnknown) return tr("%1: not known").arg(joint.name);
  const QString state = joint.look == JointLook::kTracked ? tr("tracked") : tr("inferred");
  const QString spread =
      joint.spread > 0.0 ? tr("± %1").arg(lengthText(joint.spread, 0)) : tr("uncertainty not known");
  return tr("%1: %2, %3").arg(joint.name, state, spread);
}

DepthView::DepthView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Depth image"));
  setMouseTracking(true);
}

void DepthView::show(const DepthPicture& picture) {
  picture_ = picture;
  message_ = picture.problem;
  update();
}

void DepthView::showMessage(const QString& text) {
  picture_ = {};
  message_ = text;
  update();
}

void DepthView::setBodyShown(bool shown) {
  body_ = shown;
  update();
}

QRectF DepthView::place() const {
  if (image().isNull()) return {};
  const QSizeF size = QSizeF(image().size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  QRectF place(QPointF(), size);
  place.moveCenter(QRectF(rect()).center());
  return place;
}

QPointF DepthView::onScreen(const DepthJoint& joint) const {
  const QRectF at = place();
  return at.topLeft() + joint.at * (at.width() / std::max(1, image().width()));
}

const DepthJoint* DepthView::jointAt(const QPointF& at) const {
  const DepthJoint* nearest = nullptr;
  double least = kReach;
  for (const DepthJoint& joint : picture_.joints) {
    if (joint.look == JointLook::kUnknown || image().isNull()) continue;
    const QPointF away = onScreen(joint) - at;
    const double distance = std::hypot(away.x(), away.y());
    if (distance > least) continue;
    least = distance;
    nearest = &joint;
  }
  return nearest;
}

void DepthView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (image().isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  painter.fillRect(place(), QColor(kDark));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place(), image());
  if (!body_) return;
  painter.setRenderHint(QPainter::Antialiasing);
  for (const DepthJoint& joint : picture_.joints) {
    if (joint.look == JointLook::kUnknown) continue;
    const QPointF at = onScreen(joint);
    const QColor colour(colourOf(joint.look));
    const bool filled = joint.look == JointLook::kTracked;
    painter.setPen(QPen(QColor(kDark), filled ? 1.2 : 4.0));
    painter.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
    if (filled) continue;
    painter.setPen(QPen(colour, 1.8));
    painter.drawEllipse(at, kMarkRadius, kMarkRadius);
  }
}

bool DepthView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const DepthJoint* joint = jointAt(help->pos());
    QToolTip::showText(help->globalPos(), joint ? jointText(*joint) : QString(), this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace abstand::ui
