// Transport buttons, speed, time and the scrub bar.
#include "ui/panels/timeline_panel.hpp"

#include <QComboBox>
#include <QDoubleValidator>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>

#include "ui/model/playback.hpp"
#include "ui/panels/time_strip.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr ActionId kButtons[] = {ActionId::kToStart, ActionId::kBackSecond,  ActionId::kStepBack,
                                 ActionId::kPlay,    ActionId::kStepForward, ActionId::kForwardSecond,
                                 ActionId::kToEnd,   ActionId::kLoop};
constexpr int kButtonSize = 28;      // px
constexpr int kPlayButtonSize = 34;  // px

QString speedText(double factor) { return QStringLiteral("%1×").arg(QLocale().toString(factor, 'g', 3)); }

}  // namespace

TimelinePanel::TimelinePanel(const Actions& actions, Playback& playback, QWidget* parent)
    : QWidget(parent),
      playback_{playback},
      strip_{new TimeStrip(this)},
      speed_{new QComboBox(this)},
      time_{new QLabel(this)},
      frame_{new QLabel(this)} {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  for (const ActionId id : kButtons) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(actions[id]);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAutoRaise(id != ActionId::kPlay);
    const int size = id == ActionId::kPlay ? kPlayButtonSize : kButtonSize;
    button->setFixedSize(size, size);
    button->setIconSize(QSize(size - 10, size - 10));
    button->setAccessibleName(actions[id]->text().remove(QLatin1Char('&')));
    layout->addWidget(button);
  }

  speed_->setEditable(true);
  speed_->setInsertPolicy(QComboBox::NoInsert);
  for (const double factor : {0.05, 0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0})
    speed_->addItem(speedText(factor), factor);
  speed_->setAccessibleName(tr("Playback speed"));
  speed_->setToolTip(tr("Speed, 0.05 to 8 times that of the recording (+ and −)"));
  speed_->setFixedWidth(78);
  layout->addSpacing(6);
  layout->addWidget(speed_);
  layout->addSpacing(8);
  layout->addWidget(strip_, 1);
  layout->addSpacing(8);

  auto* readout = new QVBoxLayout;
  readout->setSpacing(0);
  QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  digits.setPointSizeF(font().pointSizeF() + 2.0);
  digits.setWeight(QFont::DemiBold);
  time_->setFont(digits);
  time_->setAlignment(Qt::AlignRight | Qt::AlignBottom);
  time_->setAccessibleName(tr("Time"));
  frame_->setAlignment(Qt::AlignRight | Qt::AlignTop);
  frame_->setAccessibleName(tr("Frame"));
  frame_->setForegroundRole(QPalette::PlaceholderText);
  readout->addWidget(time_);
  readout->addWidget(frame_);
  layout->addLayout(readout);

  connect(strip_, &TimeStrip::scrubbed, &playback_, &Playback::seek);
  connect(&playback_, &Playback::timeChanged, this, &TimelinePanel::showTime);
  connect(&playback_, &Playback::rangeChanged, this, &TimelinePanel::showTime);
  connect(&playback_, &Playback::speedChanged, this, &TimelinePanel::showSpeed);
  connect(speed_, QOverload<int>::of(&QComboBox::activated), this, &TimelinePanel::takeSpeed);
  connect(speed_->lineEdit(), &QLineEdit::editingFinished, this, &TimelinePanel::takeSpeed);
  showSpeed(playback_.speed());
  showTime();
}

void TimelinePanel::showTime() {
  strip_->setTime(playback_.time());
  time_->setText(secondsWithUnit(playback_.time()));
  frame_->setText(tr("frame %1 / %2").arg(playback_.frame() + 1).arg(playback_.frameCount()));
  // Room for the longest text, so that the strip keeps its width.
  const int widest = time_->fontMetrics().horizontalAdvance(secondsWithUnit(playback_.end()));
  const QString count = QString::number(playback_.frameCount());
  const int widest_frame = frame_->fontMetrics().horizontalAdvance(tr("frame %1 / %2").arg(count, count));
  time_->setMinimumWidth(std::max(widest, widest_frame) + 4);
}

void TimelinePanel::showSpeed(double factor) { speed_->setEditText(speedText(factor)); }

void TimelinePanel::takeSpeed() {
  QString text = speed_->currentText();
  text.remove(QChar(0x00d7));
  bool understood = false;
  const double factor = QLocale().toDouble(text.trimmed(), &understood);
  if (understood && factor > 0.0) playback_.setSpeed(factor);
  showSpeed(playback_.speed());
}

}  // namespace abstand::ui
