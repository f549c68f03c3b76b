// Two sets of margins below each other.
#include "ui/panels/compare_lanes.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/style/elided_label.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

/// The stretches in which some part is inside its margin.
std::vector<TimeRange> stopsOf(const margin::MarginReview& review) {
  std::vector<TimeRange> stops;
  for (const margin::ReviewEvent& event : review.events) {
    if (event.kind != margin::ReviewEvent::Kind::kIntrusion) continue;
    if (!stops.empty() && event.t0 <= stops.back().to)
      stops.back().to = std::max(stops.back().to, event.t1);
    else
      stops.push_back({event.t0, event.t1});
  }
  return stops;
}

QString more(long difference, const QString& what) {
  if (difference == 0) return CompareLanes::tr("as many %1").arg(what);
  return (difference > 0 ? CompareLanes::tr("%1 %2 more") : CompareLanes::tr("%1 %2 fewer"))
      .arg(std::labs(difference))
      .arg(what);
}

QString difference(const margin::MarginOutcome& a, const margin::MarginOutcome& b) {
  const double share = 100.0 * (a.stoppedShare() - b.stoppedShare());
  const QString time =
      (share < 0.0 ? CompareLanes::tr("%1 % of the time less") : CompareLanes::tr("%1 % of the time more"))
          .arg(fixed(std::abs(share), 1));
  return CompareLanes::tr("A against B: %1, %2, %3, %4")
      .arg(more(a.stops - b.stops, CompareLanes::tr("stops")), time,
           more(a.false_stops - b.false_stops, CompareLanes::tr("false")),
           more(a.missed_stops - b.missed_stops, CompareLanes::tr("missed")));
}

}  // namespace

CompareLanes::CompareLanes(const RecordingReview& review, const TimeAxis& axis, QWidget* parent)
    : QWidget(parent),
      review_(review),
      axis_(axis),
      sentence_{new ElidedLabel(this)},
      head_{new QWidget(this)} {
  setObjectName(QStringLiteral("compare_lanes"));
  setAccessibleName(tr("Stops of two sets of margins"));
  auto* close = new QToolButton(head_);
  close->setObjectName(QStringLiteral("close_compare"));
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setFixedSize(20, 20);
  close->setFocusPolicy(Qt::TabFocus);
  close->setToolTip(tr("Compare no longer"));
  close->setAccessibleName(close->toolTip());
  auto* row = new QHBoxLayout(head_);
  row->setContentsMargins(4, 0, 0, 0);
  row->addWidget(sentence_, 1);
  row->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 2 * kLaneHeight + 2);
  layout->addWidget(head_);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(close, &QToolButton::clicked, this, &CompareLanes::closeWanted);
  connect(&review_, &RecordingReview::changed, this, &CompareLanes::refresh);
  connect(&axis_, &TimeAxis::viewChanged, this, QOverload<>::of(&QWidget::update));
  hide();
}

QSize CompareLanes::sizeHint() const { return {240, 22 + 2 * kLaneHeight + 2}; }

void CompareLanes::setCompared(std::vector<double> margins) {
  margins_ = std::move(margins);
  judged_ = false;
  refresh();
}

void CompareLanes::refresh() {
  const bool shown = !margins_.empty() && review_.store() && !review_.store()->empty();
  setVisible(shown);
  if (!shown) {
    for (auto& stops : stops_) stops.clear();
    return;
  }
  if (opened_ != review_.opened() || !(settings_ == review_.settings())) {
    settings_ = review_.settings();
    opened_ = review_.opened();
    reviewer_ = {};
    judged_ = false;
  }
  if (!judged_ || kept_.frames != review_.review().frames)
    kept_ = reviewer_.review(*review_.store(), margins_, {review_.options(), kNearFactor});
  judged_ = true;
  stops_[0] = stopsOf(review_.review());
  stops_[1] = stopsOf(kept_);
  sentence_->setText(text());
  sentence_->setToolTip(tr("A, the present margins: %1\nB, the margins that were kept: %2\n%3")
                            .arg(outcomeText(review_.review().outcome), outcomeText(kept_.outcome),
                                 difference(review_.review().outcome, kept_.outcome)));
  update();
}

QString CompareLanes::text() const {
  return tr("%1.  B: %2.  A: %3")
      .arg(difference(review_.review().outcome, kept_.outcome), outcomeText(kept_.outcome),
           outcomeText(review_.review().outcome));
}

void CompareLanes::setTime(double t) {
  time_ = t;
  if (isVisible()) update();
}

QRect CompareLanes::lane(int set) const {
  const int right = width() - style()->pixelMetric(QStyle::PM_ScrollBarExtent) - LaneView::kSide;
  const int top = height() - (2 - set) * kLaneHeight;
  return {LaneView::kNameWidth, top, right - LaneView::kNameWidth, kLaneHeight - 2};
}

void CompareLanes::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont small = font();
  small.setPixelSize(kLaneHeight - 3);
  painter.setFont(small);
  const QString names[] = {tr("A: now"), tr("B: kept")};
  const double length = axis_.view().length();
  const auto x = [&](double t) {
    const double share = length > 0.0 ? std::clamp((t - axis_.view().from) / length, 0.0, 1.0) : 0.0;
    return lane(0).left() + static_cast<int>(std::lround(share * (lane(0).width() - 1)));
  };
  for (int set = 0; set < 2; ++set) {
    const QRect place = lane(set);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(4, place.top(), LaneView::kNameWidth - 10, place.height()),
                     Qt::AlignVCenter | Qt::AlignRight, names[set]);
    painter.fillRect(place, palette().color(QPalette::Base));
    for (const TimeRange& stop : stops_[set])
      if (stop.to >= axis_.view().from && stop.from <= axis_.view().to)
        painter.fillRect(
            QRect(x(stop.from), place.top(), std::max(1, x(stop.to) - x(stop.from)), place.height()),
            QColor(kVermillion));
  }
  if (!axis_.view().contains(time_)) return;
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  painter.drawLine(x(time_), lane(0).top(), x(time_), height());
}

}  // namespace abstand::ui
