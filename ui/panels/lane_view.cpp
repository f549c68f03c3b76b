// The lanes of the timeline.
#include "ui/panels/lane_view.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/panels/range_paint.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kGap = 1;        // px between lanes
constexpr int kBarHeight = 4;  // px of the bar of intrusions
constexpr int kShownLanes = 7;
constexpr double kPanStep = 0.1;

/// Calls `paint(first, last)` for each run of true values.
template <class Paint>
void eachRun(const std::vector<bool>& values, Paint paint) {
  for (std::size_t x = 0; x < values.size(); ++x) {
    if (!values[x]) continue;
    const std::size_t first = x;
    while (x + 1 < values.size() && values[x + 1]) ++x;
    paint(static_cast<int>(first), static_cast<int>(x));
  }
}

}  // namespace

LaneView::LaneView(const RecordingReview& review, TimeAxis& axis, QWidget* parent)
    : QAbstractScrollArea(parent), review_(review), axis_(axis) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // So that the lanes keep their place below the strip.
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setFocusPolicy(Qt::NoFocus);
  viewport()->setBackgroundRole(QPalette::Window);
  viewport()->setMouseTracking(true);
  viewport()->setCursor(Qt::PointingHandCursor);
  setAccessibleName(tr("Distance of each body part to the robots over time"));
  verticalScrollBar()->setSingleStep(kLaneHeight);
  connect(&review_, &RecordingReview::changed, this, &LaneView::renew);
  connect(&axis_, &TimeAxis::viewChanged, this, &LaneView::renew);
  connect(&axis_, &TimeAxis::rangeChanged, viewport(), QOverload<>::of(&QWidget::update));
}

int LaneView::lanes() const {
  return review_.store() ? static_cast<int>(review_.store()->layout().parts.size()) : 0;
}

QSize LaneView::sizeHint() const { return {400, std::clamp(lanes(), 3, kShownLanes) * kLaneHeight + 2}; }

QRect LaneView::area() const { return viewport()->rect().adjusted(kNameWidth, 0, -kSide, 0); }

int LaneView::xOf(double t) const {
  if (!(axis_.view().length() > 0.0)) return area().left();
  const double share = (t - axis_.view().from) / axis_.view().length();
  return area().left() + static_cast<int>(std::lround(share * (area().width() - 1)));
}

double LaneView::timeAt(int x) const {
  const double share = static_cast<double>(x - area().left()) / std::max(1, area().width() - 1);
  return axis_.view().from + std::clamp(share, 0.0, 1.0) * axis_.view().length();
}

int LaneView::laneAt(int y) const {
  const int lane = (y + verticalScrollBar()->value()) / kLaneHeight;
  return y >= 0 && lane < lanes() ? lane : -1;
}

void LaneView::setTime(double t) {
  const int before = xOf(time_);
  time_ = t;
  const int now = xOf(t);
  if (now == before) return;
  for (const int x : {before, now}) viewport()->update(x - 3, 0, 6, viewport()->height());
}

void LaneView::renew() {
  rows_.clear();
  bounds_.clear();
  verticalScrollBar()->setRange(0, std::max(0, lanes() * kLaneHeight - viewport()->height()));
  verticalScrollBar()->setPageStep(viewport()->height());
  viewport()->update();
}

const LaneRow& LaneView::row(int lane) const {
  const int columns = std::max(1, area().width());
  if (bounds_.empty() && review_.store()) bounds_ = columnFrames(*review_.store(), axis_.view(), columns);
  rows_.resize(static_cast<std::size_t>(lanes()));
  LaneRow& row = rows_[static_cast<std::size_t>(lane)];
  if (row.colour.empty()) row = laneRow(review_, static_cast<std::size_t>(lane), axis_.view(), bounds_);
  return row;
}

QString LaneView::nameOf(int lane) const {
  return partText(*review_.store(), static_cast<std::size_t>(lane));
}

void LaneView::setSelected(const std::vector<int>& objects) {
  selected_ = objects;
  for (int lane = 0; lane < lanes(); ++lane) {
    if (!isSelected(lane)) continue;
    const int top = lane * kLaneHeight, at = verticalScrollBar()->value(), height = viewport()->height();
    if (top < at || top + kLaneHeight > at + height)
      verticalScrollBar()->setValue(top - (height - kLaneHeight) / 2);
    break;
  }
  viewport()->update();
}

bool LaneView::isSelected(int lane) const {
  const auto object =
      static_cast<int>(review_.store()->layout().parts[static_cast<std::size_t>(lane)].object);
  return std::binary_search(selected_.begin(), selected_.end(), object);
}

void LaneView::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  QFont small = font();
  small.setPixelSize(kLaneHeight - kGap - 1);
  painter.setFont(small);
  for (int lane = std::max(0, laneAt(0)); lane < lanes(); ++lane) {
    const int top = lane * kLaneHeight - verticalScrollBar()->value();
    if (top >= viewport()->height()) break;
    paintLane(painter, lane, QRect(area().left(), top, area().width(), kLaneHeight - kGap));
  }
  paintRange(painter, area(), axis_, [this](double t) { return xOf(t); });
  if (lanes() == 0 || !axis_.view().contains(time_)) return;
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  painter.drawLine(xOf(time_), 0, xOf(time_), viewport()->height());
}

void LaneView::paintLane(QPainter& painter, int lane, const QRect& place) const {
  const QRect name(4, place.top(), kNameWidth - 10, place.height());
  const bool selected = isSelected(lane);
  if (selected) painter.fillRect(name.adjusted(-4, 0, 4, 0), palette().color(QPalette::Highlight));
  painter.setPen(palette().color(selected ? QPalette::HighlightedText : QPalette::Text));
  painter.drawText(name, Qt::AlignVCenter | Qt::AlignRight,
                   painter.fontMetrics().elidedText(nameOf(lane), Qt::ElideLeft, name.width()));
  const LaneRow& values = row(lane);
  if (values.colour.empty()) return;
  QImage heat(static_cast<int>(values.colour.size()), 1, QImage::Format_RGB32);
  auto* line = reinterpret_cast<QRgb*>(heat.scanLine(0));
  const QRgb unknown = palette().color(QPalette::Mid).rgb();
  for (std::size_t x = 0; x < values.colour.size(); ++x)
    line[x] = values.unknown[x] ? unknown : values.colour[x];
  painter.drawImage(place, heat);
  const auto stretch = [&](int first, int last, int height) {
    return QRect(place.left() + first, place.bottom() + 1 - height, last - first + 1, height);
  };
  eachRun(values.unknown, [&](int first, int last) {
    painter.fillRect(stretch(first, last, place.height()),
                     QBrush(palette().color(QPalette::Window), Qt::BDiagPattern));
  });
  const auto bar = [&](const std::vector<bool>& marks, const QColor& colour, int height) {
    eachRun(marks, [&](int first, int last) {
      painter.fillRect(stretch(first, last, height + 1), palette().color(QPalette::Base));
      painter.fillRect(stretch(first, last, height), colour);
    });
  };
  bar(values.near, kindColour(EventKind::kNear), kBarHeight - 2);
  bar(values.inside, kindColour(EventKind::kInside), kBarHeight);
  bar(values.touching, kindColour(EventKind::kContact), kBarHeight + 2);
}

void LaneView::resizeEvent(QResizeEvent*) { renew(); }

void LaneView::mousePressEvent(QMouseEvent* event) {
  const int lane = laneAt(event->y());
  if (event->button() != Qt::LeftButton || lane < 0) return;
  const double t = timeAt(event->x());
  Q_EMIT scrubbed(t);
  const margin::ClearanceStore& store = *review_.store();
  if (store.empty()) return;
  Q_EMIT pairPicked(lane, store.nearest(static_cast<std::size_t>(lane), store.frameAt(t)).link);
}

void LaneView::mouseMoveEvent(QMouseEvent* event) {
  const int lane = laneAt(event->y());
  if (event->buttons() & Qt::LeftButton && lanes() > 0)
    Q_EMIT scrubbed(timeAt(event->x()));
  else if (lane >= 0)
    QToolTip::showText(event->globalPos(), tipAt(lane, timeAt(event->x())), this);
}

void LaneView::wheelEvent(QWheelEvent* event) {
  const double steps = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
  if (event->modifiers() & Qt::ControlModifier)
    axis_.zoomSteps(steps, timeAt(static_cast<int>(event->position().x())));
  else if (event->modifiers() & Qt::ShiftModifier)
    axis_.pan(-kPanStep * steps);
  else
    QAbstractScrollArea::wheelEvent(event);
}

QString LaneView::tipAt(int lane, double t) const {
  const QString text = momentText(review_, static_cast<std::size_t>(lane), t);
  return tips_ ? tips_(t, text) : text;
}

bool LaneView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int lane = laneAt(help->y());
    if (lane >= 0) QToolTip::showText(help->globalPos(), tipAt(lane, timeAt(help->x())), this);
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

}  // namespace abstand::ui
