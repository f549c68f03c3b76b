#include "ui/panels/time_minimap.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/panels/lane_image.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kGripReach = 5;  // px on either side of an end of the frame
constexpr int kMinFrame = 6;

}  // namespace

TimeMinimap::TimeMinimap(const RecordingReview& review, TimeAxis& axis, QWidget* parent)
    : QWidget(parent), review_(review), axis_(axis) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Whole recording"));
  setToolTip(
      tr("The whole recording. Drag the frame to move what the lanes show (Alt+PgUp, Alt+PgDown), an "
         "end of it to show more or less"));
  connect(&review_, &RecordingReview::changed, this, [this] {
    heat_ = QImage();
    update();
  });
  connect(&axis_, &TimeAxis::viewChanged, this, &TimeMinimap::showState);
  showState();
}

void TimeMinimap::showState() {
  // While it is dragged it stays, even over the whole recording.
  setVisible(axis_.zoomed() || grip_ != Grip::kNone);
  update();
}

void TimeMinimap::setTime(double t) {
  if (std::exchange(time_, t) != t && isVisible()) update();
}

QRect TimeMinimap::band() const { return rect().adjusted(kSide, 2, -kSide, -3); }

double TimeMinimap::timeAt(int x) const {
  const QRect area = band();
  const double share = static_cast<double>(x - area.left()) / std::max(1, area.width() - 1);
  return axis_.whole().from + std::clamp(share, 0.0, 1.0) * axis_.whole().length();
}

int TimeMinimap::xOf(double t) const {
  const QRect area = band();
  if (!(axis_.whole().length() > 0.0)) return area.left();
  const double share = std::clamp((t - axis_.whole().from) / axis_.whole().length(), 0.0, 1.0);
  return area.left() + static_cast<int>(std::lround(share * (area.width() - 1)));
}

/// Wide enough to be seen and held, however short the view is.
QRect TimeMinimap::frame() const {
  const int from = xOf(axis_.view().from), to = xOf(axis_.view().to);
  const int more = std::max(0, kMinFrame - (to - from)) / 2;
  return {QPoint(from - more, band().top() - 2), QPoint(to + more, band().bottom() + 2)};
}

TimeMinimap::Grip TimeMinimap::gripAt(int x) const {
  const QRect shown = frame();
  const int to_left = std::abs(x - shown.left()), to_right = std::abs(x - shown.right());
  // In a short frame its middle moves it.
  const int reach = std::min(kGripReach, std::max(1, shown.width() / 4));
  if (std::min(to_left, to_right) <= reach) return to_left <= to_right ? Grip::kFrom : Grip::kTo;
  return x > shown.left() && x < shown.right() ? Grip::kWhole : Grip::kNone;
}

void TimeMinimap::rebuild() {
  const LaneRow row = wholeRow(review_, axis_.whole(), std::max(1, band().width()));
  heat_ = QImage(static_cast<int>(row.colour.size()), 1, QImage::Format_RGB32);
  auto* line = reinterpret_cast<QRgb*>(heat_.scanLine(0));
  const QRgb unknown = palette().color(QPalette::Mid).rgb();
  for (std::size_t x = 0; x < row.colour.size(); ++x)
    line[x] = row.unknown[x]    ? unknown
              : row.touching[x] ? kindColour(EventKind::kContact).rgb()
              : row.inside[x]   ? kindColour(EventKind::kInside).rgb()
                                : row.colour[x];
}

void TimeMinimap::paintEvent(QPaintEvent*) {
  if (heat_.isNull()) rebuild();
  QPainter painter(this);
  painter.drawImage(band(), heat_);
  const QRect shown = frame();
  // What the lanes do not show is dimmed.
  QColor veil = palette().color(QPalette::Window);
  veil.setAlpha(150);
  painter.fillRect(QRect(band().topLeft(), QPoint(shown.left(), band().bottom())), veil);
  painter.fillRect(QRect(QPoint(shown.right(), band().top()), band().bottomRight()), veil);
  painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
  painter.drawLine(xOf(time_), band().top(), xOf(time_), band().bottom());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawRoundedRect(QRectF(shown).adjusted(0.5, 1.0, -0.5, -1.0), 2.0, 2.0);
}

void TimeMinimap::resizeEvent(QResizeEvent*) { heat_ = QImage(); }

void TimeMinimap::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  grip_ = gripAt(event->x());
  const double t = timeAt(event->x()), length = axis_.view().length();
  if (grip_ == Grip::kNone) {
    axis_.setView({t - 0.5 * length, t + 0.5 * length});
    grip_ = Grip::kWhole;
  }
  grabbed_ = t - axis_.view().from;
}

void TimeMinimap::mouseMoveEvent(QMouseEvent* event) {
  const double t = timeAt(event->x());
  const TimeRange view = axis_.view();
  switch (grip_) {
    case Grip::kWhole:
      return axis_.setView({t - grabbed_, t - grabbed_ + view.length()});
    case Grip::kFrom:
      return axis_.setView({std::min(t, view.to), view.to});
    case Grip::kTo:
      return axis_.setView({view.from, std::max(t, view.from)});
    case Grip::kNone:
      break;
  }
  const Grip below = gripAt(event->x());
  setCursor(below == Grip::kWhole  ? Qt::OpenHandCursor
            : below == Grip::kNone ? Qt::PointingHandCursor
                                   : Qt::SizeHorCursor);
}

void TimeMinimap::mouseReleaseEvent(QMouseEvent*) {
  grip_ = Grip::kNone;
  showState();
}

void TimeMinimap::wheelEvent(QWheelEvent* event) {
  const double steps = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
  axis_.zoomSteps(steps, timeAt(static_cast<int>(event->position().x())));
}

}  // namespace abstand::ui
