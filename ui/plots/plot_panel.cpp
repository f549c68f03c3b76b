// The live plots on one time axis.
#include "ui/plots/plot_panel.hpp"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/plots/strip_chart.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {
constexpr double kDefaultSpan = 10.0;  // s
// The playhead stands here in the window while following, with a little of the future in sight.
constexpr double kPlayheadPlace = 0.85;
constexpr QRgb kEarlier = 0xff8a949e;

QRgb classColour(PairClass of) {
  switch (of) {
    case PairClass::kPersonRobot:
      return kAccent;
    case PairClass::kPersonThing:
      return kCyan;
    case PairClass::kRobotRobot:
      return 0xff8a949e;
    case PairClass::kRobotThing:
      return 0xffa58c6f;
    case PairClass::kOther:
      break;
  }
  return 0xff4f5963;
}
}  // namespace

PlotPanel::PlotPanel(QWidget* parent)
    : QWidget(parent), span_{new QComboBox(this)}, joint_{new QComboBox(this)} {
  charts_ = {
      new StripChart({tr("Smallest distance"), lengthUnit(), lengthFactor(), lengthDecimals(1), false},
                     QColor(kAccent), this),
      new StripChart({tr("Largest force"), tr("N"), 1.0, 1, false}, QColor(kContactForce), this),
      new StripChart({tr("Largest joint torques"), tr("N·m"), 1.0, 1, true}, QColor(kContactForce), this)};
  charts_[0]->setToolTip(
      tr("Smallest distance of each class of pairs. Certified: never more than the true distance, over the\n"
         "whole recording; the others as far as they were played. Drop bodies and pairs here."));
  charts_[1]->setToolTip(
      tr("Largest force of a pair. Contact: its surfaces touch. Virtual: it is only inside its margin, and\n"
         "nothing touches. Of earlier margins: played before a margin was changed; play it again."));
  charts_[2]->setToolTip(tr(
      "Torques on the joints: of contact (margins too), what the reaction adds, of gravity, and of the\n"
      "motion itself (inertia). Gravity and motion are unknown (–) where the robot's file names no masses."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 4, 2, 2);
  layout->setSpacing(2);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 0, 6, 0);
  auto* label = new QLabel(tr("Time &span"), this);
  label->setBuddy(span_);
  for (const double seconds : {2.0, 5.0, 10.0, 30.0, 60.0}) span_->addItem(tr("%1 s").arg(seconds), seconds);
  span_->addItem(tr("all"), 0.0);
  span_->setCurrentIndex(span_->findData(kDefaultSpan));
  span_->setAccessibleName(tr("Time span of the plots"));
  span_->setToolTip(tr("How much time the plots show while they follow"));
  head->addWidget(label);
  head->addWidget(span_);
  head->addStretch();
  auto* of = new QLabel(tr("&Joint"), this);
  of->setBuddy(joint_);
  joint_->setAccessibleName(tr("Joint whose torques are plotted"));
  joint_->setObjectName(QStringLiteral("torque_joint"));
  joint_->setToolTip(tr("The joint whose torques are plotted, or the largest of all joints"));
  joint_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  joint_->setMinimumContentsLength(12);
  head->addWidget(of);
  head->addWidget(joint_);
  layout->addLayout(head);
  // Names of lines take more rows where the panel is narrow; a low window must not grow by them.
  auto* area = new QScrollArea(this);
  auto* column = new QWidget(area);
  auto* rows = new QVBoxLayout(column);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  column->setMinimumWidth(1);  // as narrow as the panel, whatever the plots would like
  area->setAccessibleName(tr("Plots"));
  area->setWidget(column);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  layout->addWidget(area);
  for (StripChart* chart : charts_) {
    rows->addWidget(chart, chart == charts_.back() ? 4 : 3);
    connect(chart, &StripChart::timePicked, this, &PlotPanel::timePicked);
    connect(chart, &StripChart::windowMoved, this, [this](double left, double right) {
      setFollow(false);
      moveWindow(left, right);
    });
  }
  connect(span_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    setFollow(true);
    followTime();
  });
  connect(joint_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    nameTorques();
    Q_EMIT jointChosen(joint_->currentData().toInt());
  });
  connect(&Units::shown(), &Units::changed, this, [this] {
    charts_[0]->setUnit(lengthUnit(), lengthFactor(), lengthDecimals(1));
    refresh();
  });
  setAcceptDrops(true);
  layLines();
  setJoints({});
}

void PlotPanel::setJoints(const std::vector<view::SceneOutline::JointInfo>& joints) {
  joint_->clear();
  prismatic_.clear();
  joint_->addItem(tr("largest of all"), -1);
  for (const auto& joint : joints) {
    joint_->addItem(
        tr("%1 %2").arg(QString::fromStdString(joint.mechanism), QString::fromStdString(joint.name)),
        static_cast<int>(prismatic_.size()));
    prismatic_.push_back(joint.prismatic);
  }
  joint_->setEnabled(!joints.empty());
  nameTorques();
}

void PlotPanel::nameTorques() {
  const int joint = joint_->currentData().toInt();
  const bool force = joint >= 0 && prismatic_[static_cast<std::size_t>(joint)];
  charts_[2]->setQuantity(joint < 0 ? tr("Largest joint torques")
                          : force   ? tr("Forces on %1").arg(joint_->currentText())
                                    : tr("Torques on %1").arg(joint_->currentText()),
                          force ? tr("N") : tr("N·m"));
}

void PlotPanel::setSeries(const PlotSeries& series, double start, double end) {
  series_ = series;
  earlier_ = false;
  layLines();
  start_ = start;
  end_ = end;
  time_ = start;
  followTime();
  setTime(start);
}

void PlotPanel::showEarlier(bool on) {
  if (std::exchange(earlier_, on) != on) layLines();
}

void PlotPanel::layLines() {
  std::vector<StripChart::Line> lines;
  for (const PlotSeries::Distance& distance : series_.distances)
    lines.push_back({distance.certified ? tr("%1, certified").arg(pairClassInSentence(distance.of))
                                        : pairClassInSentence(distance.of),
                     QColor(classColour(distance.of))});
  // The alarm colours mean something else.
  constexpr QRgb kColours[] = {kBlue, 0xff7a5aa6, 0xff3f8f6b, 0xff8a6d3b, 0xff56707f, 0xffa0527a};
  for (std::size_t i = 0; i < watched_.size(); ++i)
    lines.push_back({watched_[i].name, QColor(kColours[i % std::size(kColours)]),
                     watched_[i].pinned ? Qt::SolidLine : Qt::DashLine});
  charts_[0]->setLines(lines);
  std::size_t line = 0;
  for (const PlotSeries::Distance& distance : series_.distances)
    charts_[0]->setSeries(distance.series, line++);
  for (const WatchedSeries::Line& watched : watched_) charts_[0]->setSeries(watched.series, line++);

  std::vector<StripChart::Line> forces{{tr("contact"), QColor(kContactForce)},
                                       {tr("virtual (margin)"), QColor(kVirtualForce)}};
  // In the order of TorqueParts.
  std::vector<StripChart::Line> torques{{tr("contact and margins"), QColor(kContactForce)},
                                        {tr("reaction"), QColor(0xff7a5aa6)},
                                        {tr("gravity"), QColor(kBlue), Qt::DashLine},
                                        {tr("motion"), QColor(kCyan), Qt::DashLine}};
  if (earlier_)
    for (auto* both : {&forces, &torques})
      both->push_back({tr("of earlier margins"), QColor(kEarlier), Qt::DashDotLine});
  charts_[1]->setLines(forces);
  charts_[1]->setSeries(series_.contact_force, 0);
  charts_[1]->setSeries(series_.virtual_force, 1);
  if (earlier_) charts_[1]->setSeries(series_.earlier_force, 2);
  charts_[2]->setLines(torques);
  for (std::size_t k = 0; k < view::kTorqueParts; ++k)
    charts_[2]->setSeries(series_.torques ? &(*series_.torques)[k] : nullptr, k);
  if (earlier_) charts_[2]->setSeries(series_.earlier_torque, view::kTorqueParts);
  refresh();
}

void PlotPanel::setTime(double t) {
  time_ = t;
  for (StripChart* chart : charts_) chart->setPlayhead(t);
  if (follow_) followTime();
}

void PlotPanel::setMoment(long step, const view::PlotSample& sample, double clearance) {
  shown_step_ = step;
  setTime(sample.t);
  for (std::size_t i = 0; i < series_.distances.size(); ++i) {
    const PlotSeries::Distance& distance = series_.distances[i];
    charts_[0]->setNow(
        distance.certified ? clearance : sample.class_distance[static_cast<std::size_t>(distance.of)], i);
  }
  charts_[1]->setNow(sample.contact_force, 0);
  charts_[1]->setNow(sample.virtual_force, 1);
  for (std::size_t k = 0; k < view::kTorqueParts; ++k) charts_[2]->setNow(sample.peak_torque[k], k);
}

int PlotPanel::joint() const { return joint_->currentData().toInt(); }

void PlotPanel::setMargin(double metres) {
  charts_[0]->setBand(metres, tr("margin %1").arg(lengthText(metres, 0)));
}

void PlotPanel::setWatched(const std::vector<WatchedSeries::Line>& lines) {
  watched_ = lines;
  layLines();
}

void PlotPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!watchedIn(*event->mimeData()).empty()) event->acceptProposedAction();
}

void PlotPanel::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  Q_EMIT dropped(watchedIn(*event->mimeData()));
}

void PlotPanel::refresh() {
  if (!isVisible()) return;
  for (StripChart* chart : charts_) chart->refresh();
}

void PlotPanel::setFollow(bool on) {
  if (on == follow_) return;
  follow_ = on;
  if (on) followTime();
  Q_EMIT followChanged(on);
}

void PlotPanel::moveWindow(double left, double right) {
  for (StripChart* chart : charts_) chart->setWindow(left, right);
}

void PlotPanel::followTime() {
  const double chosen = span_->currentData().toDouble();
  const double whole = std::max(end_ - start_, 0.0);
  if (chosen <= 0.0) {
    moveWindow(start_, start_ + std::max({whole, time_ - start_, 0.1}));
    return;
  }
  if (whole > 0.0 && whole <= chosen) {
    moveWindow(start_, end_);
    return;
  }
  double left = std::max(start_, time_ - kPlayheadPlace * chosen);
  if (whole > 0.0) left = std::min(left, end_ - chosen);
  moveWindow(left, left + chosen);
}

}  // namespace abstand::ui
