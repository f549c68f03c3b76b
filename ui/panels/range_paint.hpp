// How the range between IN and OUT is drawn.
#pragma once

#include <QPainter>
#include <algorithm>

#include "ui/model/time_axis.hpp"

namespace abstand::ui {

/// Dims what lies outside of the axis' range, with a line at each end. `x_of`: from seconds to pixels.
template <class XOf>
void paintRange(QPainter& painter, const QRect& area, const TimeAxis& axis, XOf x_of) {
  if (!axis.range()) return;
  const int in = std::clamp(static_cast<int>(x_of(axis.range()->from)), area.left() - 1, area.right() + 1);
  const int out = std::clamp(static_cast<int>(x_of(axis.range()->to)), area.left() - 1, area.right() + 1);
  const QColor dim(0, 0, 0, 120);
  painter.fillRect(QRect(QPoint(area.left(), area.top()), QPoint(in - 1, area.bottom())), dim);
  painter.fillRect(QRect(QPoint(out + 1, area.top()), QPoint(area.right(), area.bottom())), dim);
  painter.setPen(QPen(QColor(255, 255, 255), 1.0));
  for (const int x : {in, out})
    if (x >= area.left() && x <= area.right()) painter.drawLine(x, area.top(), x, area.bottom());
}

}  // namespace abstand::ui
