// Transport buttons, speed, time, the scrub bar and the lanes.
#include "ui/panels/timeline_panel.hpp"

#include <QAction>
#include <QComboBox>
#include <QDoubleValidator>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/time_text.hpp"
#include "ui/panels/compare_lanes.hpp"
#include "ui/panels/lane_view.hpp"
#include "ui/panels/time_minimap.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/clock_text.hpp"
#include "ui/style/elided_label.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr ActionId kButtons[] = {ActionId::kToStart, ActionId::kBackSecond,  ActionId::kStepBack,
                                 ActionId::kPlay,    ActionId::kStepForward, ActionId::kForwardSecond,
                                 ActionId::kToEnd,   ActionId::kLoop};
constexpr int kButtonSize = 28;      // px
constexpr int kPlayButtonSize = 34;  // px
constexpr int kFrameFrom = 720;      // px, width from which there is room for the frame beside the sentence
constexpr int kSpeedWidth = 72, kGoToWidth = 66;  // px

QString speedText(double factor) { return QStringLiteral("%1×").arg(QLocale().toString(factor, 'g', 3)); }

}  // namespace

TimelinePanel::TimelinePanel(const Actions& actions, Playback& playback, const RecordingReview& review,
                             TimeAxis& axis, QWidget* parent)
    : QWidget(parent),
      playback_{playback},
      review_{review},
      axis_{axis},
      strip_{new TimeStrip(review, axis, this)},
      compare_{new CompareLanes(review, axis, this)},
      lanes_{new LaneView(review, axis, this)},
      minimap_{new TimeMinimap(review, axis, this)},
      go_to_{new QLineEdit(this)},
      what_if_{new ElidedLabel(this)},
      no_lanes_{new QLabel(this)},
      speed_{new QComboBox(this)},
      time_{new QLabel(this)},
      frame_{new QLabel(this)},
      by_clock_{actions[ActionId::kClockTime]} {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(2);
  buildTransport(actions);
  // The strip stands over the lanes.
  auto* strip_row = new QHBoxLayout;
  strip_row->setContentsMargins(LaneView::kNameWidth - TimeStrip::kSide, 0,
                                style()->pixelMetric(QStyle::PM_ScrollBarExtent), 0);
  strip_row->addWidget(strip_);
  layout->addLayout(strip_row);
  layout->addWidget(compare_);
  layout->addWidget(lanes_, 1);
  auto* map_row = new QHBoxLayout;
  map_row->setContentsMargins(strip_row->contentsMargins());
  map_row->addWidget(minimap_);
  layout->addLayout(map_row);
  no_lanes_->setText(tr("Body parts have lanes here where a scene has a person and a robot"));
  no_lanes_->setForegroundRole(QPalette::PlaceholderText);
  no_lanes_->setAlignment(Qt::AlignCenter);
  no_lanes_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
  layout->addWidget(no_lanes_, 1);

  connect(strip_, &TimeStrip::scrubbed, &playback_, &Playback::seek);
  connect(lanes_, &LaneView::scrubbed, &playback_, &Playback::seek);
  connect(&playback_, &Playback::timeChanged, this, &TimelinePanel::showTime);
  connect(&playback_, &Playback::rangeChanged, this, &TimelinePanel::showTime);
  connect(&playback_, &Playback::rangeChanged, this, [this] {
    stops_ = {};
    strip_->setStops({});
  });
  connect(&playback_, &Playback::speedChanged, this, &TimelinePanel::showSpeed);
  connect(&review_, &RecordingReview::changed, this, &TimelinePanel::showReview);
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this, &TimelinePanel::takeSpeed);
  connect(speed_->lineEdit(), &QLineEdit::editingFinished, this, &TimelinePanel::takeSpeed);
  connect(go_to_, &QLineEdit::returnPressed, this, &TimelinePanel::goToTyped);
  showSpeed(playback_.speed());
  showTime();
  showReview();
}

void TimelinePanel::resizeEvent(QResizeEvent* event) {
  frame_->setVisible(width() >= kFrameFrom);
  QWidget::resizeEvent(event);
}

void TimelinePanel::buildTransport(const Actions& actions) {
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  for (const ActionId id : kButtons) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions[id]);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAutoRaise(id != ActionId::kPlay);
    const int size = id == ActionId::kPlay ? kPlayButtonSize : kButtonSize;
    button->setFixedSize(size, size);
    button->setIconSize(QSize(size - 10, size - 10));
    button->setAccessibleName(actions[id]->text().remove(QLatin1Char('&')));
    row->addWidget(button);
  }

  speed_->setEditable(true);
  speed_->setInsertPolicy(QComboBox::NoInsert);
  for (const double factor : {0.05, 0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0})
    speed_->addItem(speedText(factor), factor);
  speed_->setAccessibleName(tr("Playback speed"));
  speed_->setToolTip(tr("Speed, 0.05 to 8 times that of the recording (+ and −)"));
  speed_->setFixedWidth(kSpeedWidth);
  row->addSpacing(6);
  row->addWidget(speed_);
  row->addSpacing(6);

  go_to_->setPlaceholderText(tr("Go to"));
  go_to_->setAccessibleName(tr("Go to time or frame"));
  go_to_->setToolTip(tr("Go to a time or a frame: 12.5, 1:02.5 or f120 (Ctrl+G)"));
  go_to_->setFixedWidth(kGoToWidth);
  row->addWidget(go_to_);
  row->addSpacing(10);

  what_if_->setObjectName(QStringLiteral("what_if"));
  what_if_->setAccessibleName(tr("Outcome of the present margins"));
  what_if_->setToolTip(whatIfTip(review_));
  what_if_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(what_if_, 1);
  row->addSpacing(8);

  QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  digits.setPointSizeF(font().pointSizeF() + 2.0);
  digits.setWeight(QFont::DemiBold);
  time_->setFont(digits);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_->setAccessibleName(tr("Time"));
  frame_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  frame_->setAccessibleName(tr("Frame"));
  frame_->setForegroundRole(QPalette::PlaceholderText);
  row->addWidget(frame_);
  row->addSpacing(8);
  row->addWidget(time_);
  by_clock_->setEnabled(false);
  connect(by_clock_, &QAction::toggled, this, &TimelinePanel::showTime);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void TimelinePanel::showReview() {
  const bool available = review_.available();
  lanes_->setVisible(available);
  what_if_->setText(whatIfText(review_));
  what_if_->setToolTip(whatIfTip(review_));
  no_lanes_->setVisible(!available);
}

void TimelinePanel::refresh(const view::SceneSnapshot& snapshot) {
  if (stops_.add(snapshot)) strip_->setStops(stops_.spans());
}

void TimelinePanel::setRecordings(const std::vector<view::RecordingCard>& cards) {
  const auto dated = std::find_if(cards.begin(), cards.end(), [](const view::RecordingCard& card) {
    return std::isfinite(card.clock_start);
  });
  clock_start_ = dated == cards.end() ? kNaN : dated->clock_start;
  by_clock_->setEnabled(std::isfinite(clock_start_));
  showTime();
}

void TimelinePanel::goToTyped() {
  const auto t = timeFromText(go_to_->text(), playback_);
  if (!t) {
    go_to_->selectAll();
    return;
  }
  playback_.seek(*t);
  axis_.reveal(playback_.time());
  go_to_->clear();
  go_to_->clearFocus();
}

void TimelinePanel::showTime() {
  strip_->setTime(playback_.time());
  lanes_->setTime(playback_.time());
  minimap_->setTime(playback_.time());
  compare_->setTime(playback_.time());
  const bool has_clock = std::isfinite(clock_start_), by_clock = has_clock && by_clock_->isChecked();
  const auto shown = [&](double t) { return by_clock ? clockText(clock_start_ + t) : secondsWithUnit(t); };
  time_->setText(shown(playback_.time()));
  frame_->setText(tr("frame %1 / %2").arg(playback_.frame() + 1).arg(playback_.frameCount()));
  QStringList forms{frame_->text(), secondsWithUnit(playback_.time())};
  if (has_clock) forms << dateText(clock_start_ + playback_.time());
  time_->setToolTip(forms.join(QLatin1Char('\n')));
  // Room for the longest text, so that what stands beside it keeps its place.
  const int widest = time_->fontMetrics().horizontalAdvance(shown(playback_.end()));
  // Of fixed size, so that a new text does not lay out the whole window anew.
  time_->setFixedSize(widest + 4, time_->fontMetrics().height() + 4);
  const QString count = QString::number(playback_.frameCount());
  const int room = frame_->fontMetrics().horizontalAdvance(tr("frame %1 / %2").arg(count, count));
  frame_->setFixedSize(room + 4, frame_->fontMetrics().height() + 4);
}

void TimelinePanel::showSpeed(double factor) { speed_->setEditText(speedText(factor)); }

void TimelinePanel::takeSpeed() {
  QString text = speed_->currentText();
  text.remove(QChar(0x00d7));
  const auto factor = numberFromText(text);
  if (factor && *factor > 0.0) playback_.setSpeed(*factor);
  showSpeed(playback_.speed());
}

}  // namespace abstand::ui
