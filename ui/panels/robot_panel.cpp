// The robots that react: state, reason, speed, and what led to it.
#include "ui/panels/robot_panel.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/model/inspected_subject.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kTextWidth = 120;  // px, at least

void setAlarm(QLabel* label, bool alarm) {
  QPalette palette = label->parentWidget()->palette();
  if (alarm) palette.setColor(QPalette::WindowText, QColor(kVermillion));
  if (label->palette().color(QPalette::WindowText) != palette.color(QPalette::WindowText))
    label->setPalette(palette);
}

}  // namespace

RobotPanel::RobotPanel(QWidget* parent)
    : QWidget(parent),
      head_{new QLabel(this)},
      reset_{new QPushButton(tr("Reset protective stops"), this)},
      cards_layout_{new QVBoxLayout},
      log_{new QPlainTextEdit(this)} {
  head_->setWordWrap(true);
  head_->setObjectName(QStringLiteral("robots_head"));
  reset_->setToolTip(tr("Let every robot that waits for it go on"));
  reset_->setFocusPolicy(Qt::TabFocus);
  reset_->setObjectName(QStringLiteral("reset_stops"));
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(kMaxLines);
  log_->document()->setDocumentMargin(8);
  log_->setFrameShape(QFrame::NoFrame);
  log_->setPlaceholderText(tr("No change of state yet"));
  log_->setAccessibleName(tr("Changes of state"));
  log_->setToolTip(tr("When a robot slowed down, stopped or went on, and why"));
  connect(reset_, &QPushButton::clicked, this, &RobotPanel::resetRequested);

  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 6, 8, 2);
  head->addWidget(head_, 1);
  head->addWidget(reset_);
  cards_layout_->setContentsMargins(8, 2, 8, 6);
  cards_layout_->setSpacing(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addLayout(cards_layout_);
  layout->addWidget(log_, 1);
  open({});
}

void RobotPanel::open(const view::SceneOutline& outline) {
  while (QLayoutItem* item = cards_layout_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  cards_.clear();
  for (const std::string& name : outline.reacting) addCard(QString::fromStdString(name));
  log_->clear();
  loops_ = -1;
  in_log_.assign(outline.reacting.size(), 0);
  refused_.assign(outline.reacting.size(), 0);
  broken_.assign(outline.reacting.size(), {});
  reset_->setVisible(!outline.reacting.empty());
  reset_->setEnabled(false);
  log_->setVisible(!outline.reacting.empty());
  head_->setText(tr("No robot of this scene has a reaction: all follow their recorded motion."));
}

void RobotPanel::addCard(const QString& name) {
  const std::size_t index = cards_.size();
  Card& card = cards_.emplace_back();
  card.state = new QLabel(this);
  card.state->setObjectName(QStringLiteral("state ") + name);
  QFont bold = card.state->font();
  bold.setBold(true);
  card.state->setFont(bold);
  // Long texts wrap or are cut rather than that the whole column of docks grows with each stop.
  card.state->setWordWrap(true);
  card.state->setMinimumWidth(kTextWidth);
  auto* row = new QWidget(this);
  card.reason = new QLabel(row);
  card.reason->setObjectName(QStringLiteral("reason ") + name);
  card.reason->setWordWrap(true);
  card.reason->setMinimumWidth(kTextWidth);
  card.reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  card.select = new QToolButton(row);
  card.select->setObjectName(QStringLiteral("select ") + name);
  card.select->setText(tr("Select"));
  card.select->setToolTip(tr("Select the two bodies that hold %1").arg(name));
  card.select->setFocusPolicy(Qt::TabFocus);
  card.select->hide();
  connect(card.select, &QToolButton::clicked, this, [this, index] { Q_EMIT pairPicked(cards_[index].pair); });
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(card.reason, 1);
  layout->addWidget(card.select);
  cards_layout_->addWidget(card.state);
  cards_layout_->addWidget(row);
}

void RobotPanel::showCause(Card& card, int pair) {
  card.pair = pair;
  card.select->setVisible(pair >= 0);
}

void RobotPanel::refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  if (cards_.empty()) return;
  const bool reacting = snapshot.robots.size() == cards_.size();
  head_->setText(!outline.cannot_react.empty()
                     ? tr("Not reacting: %1").arg(QString::fromStdString(outline.cannot_react))
                 : reacting && std::isnan(snapshot.loop_start)
                     ? tr("As the server reports them; their controllers react.")
                 : reacting ? tr("Restarted on their planned motion at %1; reacting since then")
                                  .arg(secondsWithUnit(snapshot.loop_start))
                            : tr("Not reacting: robots follow their recorded motion."));
  head_->setToolTip(
      tr("What a robot does depends on what happened before: a seek, a frame back and a new\n"
         "round put the robots on their plans at that time, and they react from there."));
  bool waits = false;
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    Card& card = cards_[i];
    const QString name = QString::fromStdString(outline.reacting[i]);
    if (!reacting) {
      card.state->setText(name);
      card.reason->clear();
      showCause(card, -1);
      setAlarm(card.state, false);
      continue;
    }
    if (isByHand(snapshot, robotOf(outline, outline.reacting[i]))) {
      card.state->setText(tr("%1: posed by hand").arg(name));
      card.reason->setText(tr("Its reaction is suspended until it follows its motion again."));
      showCause(card, -1);
      setAlarm(card.state, false);
      continue;
    }
    const view::RobotSnapshot& robot = snapshot.robots[i];
    waits |= robot.state == safety::StopState::kWaitingForReset;
    card.state->setText(tr("%1%2: %3 since %4, speed %5 %")
                            .arg(isStop(robot.state) ? QStringLiteral("⚠ ") : QString(), name,
                                 stateText(robot.state), secondsWithUnit(robot.since),
                                 fixed(100.0 * robot.speed_scale, 0)));
    setAlarm(card.state, isStop(robot.state));
    const bool held = robot.state != safety::StopState::kRunning;
    card.reason->setText(held ? causeText(robot.cause, outline, i) : QString());
    showCause(card, held && static_cast<std::size_t>(robot.cause.pair) < outline.pairs.size()
                        ? robot.cause.pair
                        : -1);
  }
  reset_->setEnabled(waits && can_reset_);
  if (reacting) addEntries(outline, snapshot);
}

void RobotPanel::addEntries(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  if (snapshot.loops != loops_) {
    loops_ = snapshot.loops;
    std::fill(in_log_.begin(), in_log_.end(), 0);
    std::fill(refused_.begin(), refused_.end(), 0);
    for (auto& limits : broken_) limits.clear();
    log_->clear();
  }
  struct New {
    const safety::StopEntry* entry;
    std::size_t robot;
  };
  std::vector<New> news;
  for (std::size_t i = 0; i < snapshot.robots.size(); ++i) {
    const safety::StopLog& log = snapshot.robots[i].log;
    const std::size_t unseen = log.count() - in_log_[i];
    if (unseen > log.kept())
      log_->appendPlainText(tr("%1: %2 earlier changes are not listed")
                                .arg(QString::fromStdString(outline.reacting[i]))
                                .arg(unseen - log.kept()));
    for (std::size_t k = log.kept() - std::min(unseen, log.kept()); k < log.kept(); ++k)
      news.push_back({&log.entry(k), i});
    in_log_[i] = log.count();
  }
  std::stable_sort(news.begin(), news.end(),
                   [](const New& a, const New& b) { return a.entry->t < b.entry->t; });
  for (const New& n : news) log_->appendPlainText(entryText(*n.entry, outline, n.robot));
  for (std::size_t i = 0; i < snapshot.robots.size(); ++i) {
    const view::RobotSnapshot& robot = snapshot.robots[i];
    if (robot.refused_resets > refused_[i])
      log_->appendPlainText(tr("%1  %2: reset refused: %3")
                                .arg(secondsWithUnit(snapshot.t), QString::fromStdString(outline.reacting[i]),
                                     refusalText(robot.refusal)));
    refused_[i] = robot.refused_resets;
    for (std::size_t k = 0; k < std::min(robot.breach_count, robot.breaches.size()); ++k)
      if (broken_[i].emplace(robot.breaches[k].dof, robot.breaches[k].kind).second)
        log_->appendPlainText(breachText(robot.breaches[k], outline, i));
  }
}

}  // namespace abstand::ui
