// The plot of a margin curve with its handle.
#include "ui/panels/curve_area.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/panels/margin_curve.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kLeft = 46.0, kRight = 40.0, kTop = 18.0, kBottom = 18.0;  // px
constexpr double kKnob = 5.0;                                               // px, radius

struct CurveLine {
  QString name;
  QColor colour;
  Qt::PenStyle style;
};

}  // namespace

CurveArea::CurveArea(MarginCurve& curve) : QWidget(&curve), curve_(curve) {
  setAccessibleName(tr("Share of time stopped, false and missed stops against the margin"));
  setToolTip(tr("Drag the handle to move the margin, as its slider does"));
}

QRectF CurveArea::plot() const { return QRectF(rect()).adjusted(kLeft, kTop, -kRight, -kBottom); }

double CurveArea::xOf(double metres) const {
  return plot().left() + std::min(metres / MarginCurve::kRightEnd, 1.0) * plot().width();
}

double CurveArea::metresAt(int x) const {
  const double share = std::clamp((x - plot().left()) / std::max(1.0, plot().width()), 0.0, 1.0);
  return std::round(1e3 * share * MarginCurve::kRightEnd) * 1e-3;
}

QPoint CurveArea::handle() const {
  return {static_cast<int>(std::lround(xOf(curve_.present()))), static_cast<int>(plot().top())};
}

void CurveArea::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = plot();
  const QColor text = palette().color(QPalette::Text);
  painter.fillRect(box, palette().color(QPalette::Base));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(box);
  if (curve_.part_ < 0) return;

  long most = 1;
  double share = 0.01;
  for (const MarginCurve::Point& point : curve_.points()) {
    most = std::max({most, point.outcome.false_stops, point.outcome.missed_stops});
    share = std::max(share, point.outcome.stoppedShare());
  }
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(small);
  painter.setPen(text);
  const double below = box.bottom() + 2.0;
  for (int mm = 0; mm <= 300; mm += 50)
    painter.drawText(QRectF(xOf(1e-3 * mm) - 30.0, below, 60.0, kBottom - 2.0),
                     Qt::AlignHCenter | Qt::AlignTop,
                     mm == 300 ? lengthText(1e-3 * mm, 0) : lengthNumber(1e-3 * mm, 0));
  const auto scale = [&](const QString& top, const QString& bottom, double left, Qt::Alignment side) {
    const double width = (left < box.left() ? kLeft : kRight) - 8.0;
    painter.drawText(QRectF(left, box.top() - 6.0, width, 14.0), side | Qt::AlignVCenter, top);
    painter.drawText(QRectF(left, box.bottom() - 9.0, width, 14.0), side | Qt::AlignVCenter, bottom);
  };
  scale(tr("%1 %").arg(fixed(100.0 * share, share < 0.1 ? 1 : 0)), tr("0 %"), 4.0, Qt::AlignRight);
  scale(QString::number(most), QStringLiteral("0"), box.right() + 4.0, Qt::AlignLeft);

  const CurveLine lines[] = {{tr("time stopped (left)"), QColor(kBlue), Qt::SolidLine},
                             {tr("false stops (right)"), QColor(kAmber), Qt::DashLine},
                             {tr("missed stops (right)"), QColor(kVermillion), Qt::DotLine}};
  double legend = box.left();
  for (int i = 0; i < 3; ++i) {
    const double room =
        std::min(legend + 16.0 + painter.fontMetrics().horizontalAdvance(lines[i].name) + 18.0,
                 static_cast<double>(width()));
    painter.setPen(QPen(lines[i].colour, 2.0, lines[i].style));
    painter.drawLine(QPointF(legend, 8.0), QPointF(legend + 14.0, 8.0));
    painter.setPen(text);
    painter.drawText(QRectF(legend + 18.0, 1.0, room - legend, 14.0), Qt::AlignVCenter, lines[i].name);
    legend = room + 6.0;
    QPolygonF line;
    for (const MarginCurve::Point& point : curve_.points()) {
      const double value = i == 0 ? point.outcome.stoppedShare() / share
                           : i == 1
                               ? static_cast<double>(point.outcome.false_stops) / static_cast<double>(most)
                               : static_cast<double>(point.outcome.missed_stops) / static_cast<double>(most);
      line << QPointF(xOf(point.margin), box.bottom() - value * box.height());
    }
    painter.setPen(QPen(lines[i].colour, 2.0, lines[i].style));
    painter.drawPolyline(line);
  }
  painter.setPen(QPen(text, 1.4));
  painter.drawLine(QPointF(handle()), QPointF(handle().x(), box.bottom()));
  painter.setBrush(QColor(kAccent));
  painter.drawEllipse(QPointF(handle()), kKnob, kKnob);
}

void CurveArea::drag(int x) {
  if (curve_.part_ >= 0) Q_EMIT curve_.dragged(curve_.object(), metresAt(x));
}

void CurveArea::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || curve_.part_ < 0) return;
  held_ = true;
  drag(event->x());
}

void CurveArea::mouseMoveEvent(QMouseEvent* event) {
  if (held_) drag(event->x());
}

void CurveArea::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(held_, false)) return;
  Q_EMIT curve_.released();
}

}  // namespace abstand::ui
