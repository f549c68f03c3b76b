// What a strip chart draws on its canvas: band, zero line, the series, the playhead. Qwt only here and in its
// users' .cpp.
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <optional>
#include <vector>

#include "ui/model/frame_series.hpp"

namespace abstand::ui {

/// Draws a series with at most two points a pixel column, so that long recordings cost no more than short
/// ones.
class Trace : public QwtPlotItem {
 public:
  Trace();

  const FrameSeries* series{nullptr};
  double factor{1.0};  ///< from the series's unit to the axis's
  QColor colour;
  Qt::PenStyle style{Qt::SolidLine};
  bool first{true};           ///< of its chart: draws what belongs to no series
  double playhead{0.0};       ///< s
  std::optional<double> now;  ///< value at the playhead where it is known better than by the series
  double valueAtPlayhead() const;
  double band_high{0.0};  ///< axis unit; a band from 0 up to here, none when 0
  QString band_text;

  int rtti() const override { return QwtPlotItem::Rtti_PlotUserItem; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
            const QRectF& canvas) const override;

 private:
  void drawBand(QPainter& painter, const QwtScaleMap& y, const QRectF& canvas) const;
  void drawSeries(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const;
  void drawPlayhead(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                    const QRectF& canvas) const;

  mutable std::vector<SeriesPoint> points_;  // kept from frame to frame
  mutable QPolygonF line_;
};

}  // namespace abstand::ui
