// The scrub bar.
#include "ui/panels/time_strip.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/model/pair_level.hpp"
#include "ui/model/run_history.hpp"
#include "ui/panels/lane_image.hpp"
#include "ui/panels/range_paint.hpp"
#include "ui/style/format.hpp"
#include "ui/style/heat.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kMarkHeight = 9;      // px above the band
constexpr int kPlayheadReach = 10;  // px on either side of it
constexpr int kTickHeight = 16;     // px below

/// 1, 2 or 5 times a power of ten, at least `least`.
double niceStep(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least) return factor * decade;
  return 10.0 * decade;
}

/// Above `tip`: a triangle for what touches or is inside a margin, hollow where that is not certain, a square
/// for a robot that stopped, a hollow diamond for lost tracking.
void paintMark(QPainter& painter, QPointF tip, EventKind kind, const QColor& hollow) {
  const bool filled = kind == EventKind::kContact || kind == EventKind::kInside || kind == EventKind::kStop;
  painter.setPen(QPen(kindColour(kind), 1.2));
  painter.setBrush(filled ? kindColour(kind) : hollow);
  QVector<QPointF> shape{{-4.0, -7.0}, {4.0, -7.0}, {0.0, 0.0}};
  if (kind == EventKind::kStop) shape = {{-3.0, -7.0}, {3.0, -7.0}, {3.0, -1.0}, {-3.0, -1.0}};
  if (kind == EventKind::kLost) shape = {{0.0, -8.0}, {4.0, -4.0}, {0.0, 0.0}, {-4.0, -4.0}};
  for (QPointF& point : shape) point += tip;
  painter.drawPolygon(shape);
}

}  // namespace

TimeStrip::TimeStrip(const RecordingReview& review, TimeAxis& axis, QWidget* parent)
    : QWidget(parent), review_(review), axis_(axis) {
  setMouseTracking(true);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Time slider with the smallest distance"));
  setAccessibleDescription(tr("Move it with the arrow keys, Home and End"));
  connect(&review_, &RecordingReview::changed, this, [this] {
    rebuild();
    update();
  });
  connect(&axis_, &TimeAxis::viewChanged, this, QOverload<>::of(&QWidget::update));
  connect(&axis_, &TimeAxis::rangeChanged, this, QOverload<>::of(&QWidget::update));
}

void TimeStrip::setHistory(const RunHistory* history, double start, double end) {
  history_ = history;
  start_ = start;
  end_ = end;
  time_ = start;
  rebuild();
  update();
}

void TimeStrip::setTime(double t) {
  const int before = xOf(time_);
  time_ = t;
  const int now = xOf(t);
  if (now == before) return;
  for (const int x : {before, now}) update(x - kPlayheadReach, 0, 2 * kPlayheadReach, height());
}

void TimeStrip::setBookmarks(std::vector<double> times) {
  bookmarks_ = std::move(times);
  update();
}

void TimeStrip::setStops(std::vector<StopSpan> stops) {
  stops_ = std::move(stops);
  update();
}

void TimeStrip::refresh() {
  if (review_.available() || !history_ || history_->revision() == shown_revision_) return;
  rebuild();
  update();
}

QRect TimeStrip::band() const { return rect().adjusted(kSide, kMarkHeight + 3, -kSide, -kTickHeight - 2); }

double TimeStrip::timeAt(int x) const {
  const QRect area = band();
  if (area.width() <= 1 || !(end_ > start_)) return start_;
  const double f = std::clamp(static_cast<double>(x - area.left()) / (area.width() - 1), 0.0, 1.0);
  return start_ + f * (end_ - start_);
}

int TimeStrip::xOf(double t) const {
  const QRect area = band();
  if (!(end_ > start_)) return area.left();
  const double f = std::clamp((t - start_) / (end_ - start_), 0.0, 1.0);
  return area.left() + static_cast<int>(std::lround(f * (area.width() - 1)));
}

void TimeStrip::rebuild() {
  const int width = std::max(1, band().width());
  if (heat_.width() != width) heat_ = QImage(width, 1, QImage::Format_RGB32);
  if (review_.available()) {
    rebuildFromReview();
    return;
  }
  const auto columns = static_cast<std::size_t>(width);
  marks_ = {std::vector<bool>(columns), std::vector<bool>(columns), std::vector<bool>(columns), {}};
  const QRgb unknown = palette().color(QPalette::Mid).rgb();
  auto* row = reinterpret_cast<QRgb*>(heat_.scanLine(0));
  const double column = (end_ - start_) / width;
  for (std::size_t x = 0; x < columns; ++x) {
    row[x] = unknown;
    if (!history_ || !(column > 0.0)) continue;
    const double left = start_ + static_cast<double>(x) * column, right = left + column;
    const double nearest = history_->firstDistance().between(left, right).low;
    if (!std::isnan(nearest)) row[x] = heat(nearest);
    marks_.touching[x] = history_->touched(left, right);
    marks_.inside[x] = history_->wasInside(left, right);
    marks_.earlier[x] = history_->hasEarlier() && history_->wasInsideEarlier(left, right);
    const auto begins = [&](const std::vector<bool>& marks) { return marks[x] && (x == 0 || !marks[x - 1]); };
    if (begins(marks_.inside)) marks_.events.emplace_back(static_cast<int>(x), EventKind::kInside);
    if (begins(marks_.touching)) marks_.events.emplace_back(static_cast<int>(x), EventKind::kContact);
  }
  placeEvents();
  shown_revision_ = history_ ? history_->revision() : -1;
}

void TimeStrip::rebuildFromReview() {
  const LaneRow row = wholeRow(review_, {start_, end_}, heat_.width());
  auto* line = reinterpret_cast<QRgb*>(heat_.scanLine(0));
  const QRgb unknown = palette().color(QPalette::Mid).rgb();
  for (std::size_t x = 0; x < row.colour.size(); ++x) line[x] = row.unknown[x] ? unknown : row.colour[x];
  marks_ = {row.touching, row.inside, std::vector<bool>(row.inside.size()), {}};
  placeEvents();
}

void TimeStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawImage(band(), heat_);
  paintMarks(painter);
  paintRange(painter, band(), axis_, [this](double t) { return xOf(t); });
  paintView(painter);
  paintStops(painter);
  paintBookmarks(painter);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(band().adjusted(-1, -1, 0, 0));
  paintTicks(painter);
  if (hover_x_ >= 0 && end_ > start_) {
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0, Qt::DotLine));
    painter.drawLine(hover_x_, band().top(), hover_x_, band().bottom());
  }
  if (end_ > start_) paintPlayhead(painter);
}

void TimeStrip::paintMarks(QPainter& painter) const {
  const QRect area = band();
  const auto bar = [&](const std::vector<bool>& marks, const QColor& colour) {
    for (int x = 0; x < static_cast<int>(marks.size()); ++x)
      if (marks[static_cast<std::size_t>(x)])
        painter.fillRect(QRect(area.left() + x, area.top() + area.height() / 2, 1, area.height() / 2 + 1),
                         colour);
  };
  bar(marks_.earlier, palette().color(QPalette::Text));
  bar(marks_.inside, levelColour(PairLevel::kInside));
  bar(marks_.touching, levelColour(PairLevel::kTouching));
  paintEventMarks(painter);
}

/// A mark for each kind that begins or is nearest in a column, those of less weight first.
void TimeStrip::placeEvents() {
  for (const RecordingEvent& event : review_.events()) {
    if (!review_.shownKinds()[static_cast<std::size_t>(event.kind)]) continue;
    marks_.events.emplace_back(xOf(event.mark()) - band().left(), event.kind);
  }
  const auto before = [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first < b.first;
  };
  std::sort(marks_.events.begin(), marks_.events.end(), before);
  marks_.events.erase(std::unique(marks_.events.begin(), marks_.events.end()), marks_.events.end());
}

void TimeStrip::paintEventMarks(QPainter& painter) const {
  const QRect area = band();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [x, kind] : marks_.events)
    paintMark(painter, QPointF(area.left() + x, area.top() - 2.0), kind, palette().color(QPalette::Window));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimeStrip::paintTicks(QPainter& painter) const {
  if (!(end_ > start_)) return;
  const QRect area = band();
  const double step = niceStep((end_ - start_) * 70.0 / std::max(1, area.width()));
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  QFont small = font();
  small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1.5));
  painter.setFont(small);
  for (double k = std::ceil(start_ / step - 1e-9); k * step <= end_ + 1e-9; ++k) {
    const int x = xOf(k * step);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(x, area.bottom() + 1, x, area.bottom() + 4);
    painter.setPen(palette().color(QPalette::Text));
    QRect label(x - 40, area.bottom() + 3, 80, kTickHeight);
    int align = Qt::AlignHCenter;
    if (label.left() < 0) label.moveLeft(x), align = Qt::AlignLeft;
    if (label.right() >= width()) label.moveRight(x), align = Qt::AlignRight;
    painter.drawText(label, align | Qt::AlignTop, tr("%1 s").arg(fixed(k * step, decimals)));
  }
}

void TimeStrip::paintPlayhead(QPainter& painter) const {
  const QRect area = band();
  const double x = xOf(time_) + 0.5;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Base), 3.0));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + 3));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + 3));
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
  painter.drawEllipse(QPointF(x, area.top() - 4.0), 6.0, 6.0);
}

/// What the lanes show.
void TimeStrip::paintView(QPainter& painter) const {
  if (!axis_.zoomed()) return;
  const QRect shown(QPoint(xOf(axis_.view().from), band().top() - 2),
                    QPoint(xOf(axis_.view().to), band().bottom() + 1));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawRect(shown);
}

void TimeStrip::paintStops(QPainter& painter) const {
  for (const StopSpan& stop : stops_) {
    const QRect bar(QPoint(xOf(stop.range.from), band().top()), QPoint(xOf(stop.range.to), band().top() + 4));
    painter.fillRect(bar.adjusted(0, 0, 0, 1), palette().color(QPalette::Base));
    painter.fillRect(bar, QColor(kVermillion));
  }
}

void TimeStrip::paintBookmarks(QPainter& painter) const {
  painter.setPen(Qt::NoPen);
  for (const double t : bookmarks_)
    painter.fillRect(QRect(xOf(t) - 2, band().top() - 8, 4, 7), palette().color(QPalette::Highlight));
}

void TimeStrip::wheelEvent(QWheelEvent* event) {
  const double steps = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
  axis_.zoomSteps(steps, timeAt(static_cast<int>(event->position().x())));
}

void TimeStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT scrubbed(timeAt(event->x()));
}

void TimeStrip::mouseMoveEvent(QMouseEvent* event) {
  hover_x_ = std::clamp(event->x(), band().left(), band().right());
  if (event->buttons() & Qt::LeftButton)
    Q_EMIT scrubbed(timeAt(event->x()));
  else if (history_)
    QToolTip::showText(event->globalPos(), tipAt(timeAt(event->x())), this);
  update();
}

void TimeStrip::leaveEvent(QEvent*) {
  hover_x_ = -1;
  update();
}

void TimeStrip::resizeEvent(QResizeEvent*) { rebuild(); }

QString TimeStrip::textAt(double t) const {
  QString text = momentAt(t);
  for (const StopSpan& stop : stops_)
    if (stop.range.contains(t) && stop_text_) text += QLatin1Char('\n') + stop_text_(stop);
  return text;
}

QString TimeStrip::tipAt(double t) const { return tips_ ? tips_(t, textAt(t)) : textAt(t); }

QString TimeStrip::momentAt(double t) const {
  if (review_.available()) return nearestMomentText(review_, t);
  const double d = history_->firstDistance().at(t);
  if (std::isnan(d)) return tr("%1: not computed yet").arg(secondsWithUnit(t));
  QString text = tr("%1: smallest distance %2").arg(secondsWithUnit(t), lengthText(d));
  if (history_->touched(t, t))
    text += tr("; touching");
  else if (history_->wasInside(t, t))
    text += tr("; inside a margin");
  else if (history_->wasInsideEarlier(t, t))
    text += tr("; inside a margin that has changed since: play it again");
  return text;
}

bool TimeStrip::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && history_) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tipAt(timeAt(help->pos().x())), this);
    return true;
  }
  if (event->type() == QEvent::PaletteChange) rebuild();
  return QWidget::event(event);
}

}  // namespace abstand::ui
