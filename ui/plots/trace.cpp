// What a strip chart draws on its canvas.
#include "ui/plots/trace.hpp"

#include <qwt_plot.h>
#include <qwt_scale_map.h>

#include <QApplication>
#include <QPainter>
#include <cmath>

#include "ui/style/theme.hpp"

namespace abstand::ui {

Trace::Trace() {
  setZ(20.0);
  setItemAttribute(QwtPlotItem::AutoScale, false);
  setItemAttribute(QwtPlotItem::Legend, false);
}

double Trace::valueAtPlayhead() const {
  if (now) return *now;
  return series ? series->at(playhead) : std::nan("");
}

void Trace::draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const {
  if (first) drawBand(*painter, y, canvas);
  if (series) drawSeries(*painter, x, y, canvas);
  drawPlayhead(*painter, x, y, canvas);
}

void Trace::drawBand(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const {
  const double zero = y.transform(0.0);
  if (band_high > 0.0) {
    const QRectF band(QPointF(canvas.left(), y.transform(band_high)), QPointF(canvas.right(), zero));
    QColor tint(kAmber);
    tint.setAlpha(48);
    painter.fillRect(band, tint);
    painter.setPen(QPen(QColor(kAmber), 1.0, Qt::DashLine));
    painter.drawLine(band.topLeft(), band.topRight());
    painter.setPen(plot()->palette().color(QPalette::Text));
    if (band.height() > 2 + painter.fontMetrics().height())
      painter.drawText(band.adjusted(4, 1, -4, 0), Qt::AlignLeft | Qt::AlignTop, band_text);
  }
  if (canvas.top() < zero && zero < canvas.bottom()) {
    painter.setPen(QPen(plot()->palette().color(QPalette::Text), 1.0));
    painter.drawLine(QPointF(canvas.left(), zero), QPointF(canvas.right(), zero));
  }
}

void Trace::drawSeries(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                       const QRectF& canvas) const {
  series->decimate(x.invTransform(canvas.left()), x.invTransform(canvas.right()),
                   static_cast<int>(canvas.width()), points_);
  // Up to this width Qt draws lines without making polygons of them first.
  painter.setPen(QPen(colour, 1.0, style));
  painter.setRenderHint(QPainter::Antialiasing, points_.size() < 4000);
  const auto flush = [&] {
    if (line_.size() == 1)
      painter.drawPoint(line_.front());
    else if (!line_.isEmpty())
      painter.drawPolyline(line_);
    line_.resize(0);
  };
  for (const SeriesPoint& point : points_) {
    if (std::isnan(point.value))
      flush();
    else
      line_ << QPointF(x.transform(point.t), y.transform(point.value * factor));
  }
  flush();
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void Trace::drawPlayhead(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                         const QRectF& canvas) const {
  const double px = std::round(x.transform(playhead));
  if (px < canvas.left() || px > canvas.right()) return;
  QColor ink = plot()->palette().color(QPalette::Text);
  ink.setAlpha(150);
  painter.setPen(QPen(ink, 1.0));
  if (first) painter.drawLine(QPointF(px, canvas.top()), QPointF(px, canvas.bottom()));
  const double value = valueAtPlayhead();
  if (std::isnan(value)) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(colour);
  painter.setPen(QPen(plot()->palette().color(QPalette::Base), 1.5));
  painter.drawEllipse(QPointF(px, y.transform(value * factor)), 4.0, 4.0);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace abstand::ui
