#include "ui/style/elided_label.hpp"

#include <QPainter>
#include <algorithm>

namespace abstand::ui {

namespace {
constexpr int kMinWidth = 24;  // px
constexpr int kBeside = 10;    // px left and right of the text
constexpr int kRounding = 2;   // px by which an exact width may be too small for elidedText()
}  // namespace

QSize ElidedLabel::sizeHint() const {
  const int width = text().isEmpty() ? 0 : fontMetrics().horizontalAdvance(text()) + 2 * kBeside + kRounding;
  widest_ = std::max(widest_, width);
  return {widest_, QLabel::sizeHint().height()};
}

QSize ElidedLabel::minimumSizeHint() const {
  return {whole_ ? sizeHint().width() : std::min(kMinWidth, sizeHint().width()),
          QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  const int beside = std::min(kBeside, width() / 8);
  const QRect room = rect().adjusted(beside, 0, -beside, 0);
  painter.drawText(room, static_cast<int>(alignment()),
                   fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
}

}  // namespace abstand::ui
