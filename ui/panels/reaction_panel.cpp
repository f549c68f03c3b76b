#include "ui/panels/reaction_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/error.hpp"
#include "ui/model/law_text.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/panels/law_row.hpp"
#include "ui/panels/response_row.hpp"

namespace abstand::ui {

namespace {
const view::SceneOutline kNoReactions;
}  // namespace

ReactionPanel::ReactionPanel(QWidget* parent)
    : QWidget(parent),
      outline_{&kNoReactions},
      robots_{new QComboBox(this)},
      head_{new QLabel(this)},
      back_{new QPushButton(tr("Back to the scene file"), this)},
      list_{new QVBoxLayout} {
  robots_->setObjectName(QStringLiteral("reaction_robot"));
  robots_->setAccessibleName(tr("Robot whose laws are shown"));
  robots_->setToolTip(robots_->accessibleName());
  head_->setObjectName(QStringLiteral("reaction_head"));
  head_->setWordWrap(true);
  back_->setObjectName(QStringLiteral("reaction_back"));
  back_->setToolTip(tr("All laws and numbers of this robot as in the scene file"));
  back_->setFocusPolicy(Qt::TabFocus);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(8, 6, 8, 2);
  top->addWidget(robots_, 1);
  top->addWidget(back_);
  head_->setContentsMargins(8, 0, 8, 2);
  auto* content = new QWidget;
  list_->setContentsMargins(8, 2, 8, 6);
  list_->setSpacing(2);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(list_);
  column->addStretch(1);
  auto* area = new QScrollArea(this);
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setAccessibleName(tr("Laws and numbers"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(top);
  layout->addWidget(head_);
  layout->addWidget(area, 1);
  connect(robots_, QOverload<int>::of(&QComboBox::activated), this, [this] { build(); });
  connect(back_, &QPushButton::clicked, this, [this] {
    Q_EMIT edited(robot(), {}, tr("back to the scene file"), {});
    build();  // drops what was refused
  });
  build();
}

QString ReactionPanel::robot() const { return robots_->currentText(); }

const control::ReactionDescription* ReactionPanel::scene() const {
  const auto r = static_cast<std::size_t>(robots_->currentIndex());
  return r < outline_->reactions.size() ? &outline_->reactions[r] : nullptr;
}

int ReactionPanel::joints() const {
  for (const view::RobotCard& card : outline_->robots)
    if (QString::fromStdString(card.name) == robot()) return card.joints;
  return 0;
}

/// Why a law stays as it is in the scene file, by what the robot permits; empty: it may be switched.
std::string ReactionPanel::problemOfSwitching(const control::LawState& law) const {
  const auto r = static_cast<std::size_t>(robots_->currentIndex());
  if (!law.restarts || r >= outline_->drives.size()) return {};
  control::ReactionChange other;
  other.laws[law.name] = !law.scene_on;
  return view::driveProblem(outline_->drives[r], control::changedReaction(*scene(), other, joints()));
}

void ReactionPanel::open(const view::SceneOutline& outline) {
  const QString before = robot();
  outline_ = &outline;
  robots_->clear();
  for (std::size_t r = 0; r < outline.reactions.size(); ++r)
    robots_->addItem(QString::fromStdString(outline.reacting[r]));
  robots_->setCurrentIndex(std::max(0, robots_->findText(before)));
  build();
}

void ReactionPanel::showRobot(int robot) {
  robots_->setCurrentIndex(robot);
  build();
}

void ReactionPanel::setReactions(const QMap<QString, control::ReactionChange>& reactions) {
  reactions_ = reactions;
  refresh();
}

void ReactionPanel::build() {
  while (QLayoutItem* item = list_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  laws_.clear();
  rows_.clear();
  responses_.clear();
  robots_->setVisible(robots_->count() > 1);
  back_->setVisible(scene() != nullptr);
  if (scene())
    for (const control::LawState& law : control::lawStates(*scene(), change())) addLaw(law, joints());
  refresh();
}

void ReactionPanel::addLaw(const control::LawState& law, int joints) {
  Law& added = laws_.emplace_back();
  added.name = law.name;
  QWidget* title = nullptr;
  QString tip = lawMeaning(law.name);
  if (law.switchable) {
    title = added.box = new QCheckBox(lawName(law.name), this);
    added.box->setObjectName(QStringLiteral("law ") + QString::fromStdString(law.name));
    const std::string problem = problemOfSwitching(law);
    added.box->setEnabled(problem.empty());
    if (!problem.empty())
      tip += QLatin1Char('\n') + QString::fromStdString(problem);
    else if (law.restarts)
      tip += QLatin1Char('\n') + tr("Switching it starts the robots anew on their planned motion.");
    connect(added.box, &QCheckBox::clicked, this, [this, name = law.name](bool on) { switchLaw(name, on); });
  } else {
    title = new QLabel(lawName(law.name), this);
  }
  title->setToolTip(tip);
  list_->addWidget(title);
  added.numbers = new QWidget(this);
  auto* column = new QVBoxLayout(added.numbers);
  column->setContentsMargins(0, 0, 0, 4);
  column->setSpacing(1);
  for (const control::LawNumber& number : law.numbers) {
    auto* row = new LawRow(number, joints, added.numbers);
    column->addWidget(row);
    rows_.push_back(row);
    connect(row, &LawRow::edited, this,
            [this, row](const config::JointNumbers& numbers) { take(*row, numbers); });
    connect(row, &LawRow::backWanted, this, [this, row] {
      Q_EMIT released();
      take(*row, row->scene());
    });
    connect(row, &LawRow::left, this, &ReactionPanel::released);
  }
  if (!law.responses.empty()) column->addWidget(new QLabel(tr("What it does for each reason"), this));
  for (const control::StopChoice& choice : law.responses) {
    auto* row = new ResponseRow(choice, added.numbers);
    column->addWidget(row);
    responses_.push_back(row);
    connect(row, &ResponseRow::edited, this,
            [this, row](safety::StopResponse response) { choose(row->reason(), response); });
  }
  list_->addWidget(added.numbers);
}

void ReactionPanel::refresh() {
  if (!scene()) {
    head_->setText(outline_->reacting.empty() ? tr("No robot of this scene has a reaction.")
                                              : tr("The laws are those of the server."));
    return;
  }
  int differing = 0;
  std::size_t next = 0, next_response = 0;
  const std::vector<control::LawState> laws = control::lawStates(*scene(), change());
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const control::LawState& law = laws[i];
    if (laws_[i].box) {
      laws_[i].box->setChecked(law.on);
      QFont font = laws_[i].box->font();
      font.setBold(law.on != law.scene_on);
      laws_[i].box->setFont(font);
    }
    differing += law.on != law.scene_on ? 1 : 0;
    laws_[i].numbers->setVisible(law.on);
    for (const control::LawNumber& number : law.numbers) {
      differing += number.value != number.scene ? 1 : 0;
      rows_[next++]->show(number);
    }
    for (const control::StopChoice& choice : law.responses) {
      differing += choice.value != choice.scene ? 1 : 0;
      responses_[next_response++]->show(choice);
    }
  }
  head_->setText(differing == 0 ? tr("As in the scene file")
                                : tr("%n differences from the scene file", nullptr, differing));
  back_->setEnabled(differing > 0);
}

void ReactionPanel::take(LawRow& row, const config::JointNumbers& numbers) {
  control::ReactionChange wanted = change();
  wanted.numbers[row.key()] = numbers;
  try {
    control::changedReaction(*scene(), wanted, joints());
  } catch (const UsageError& e) {
    return row.refuse(QString::fromStdString(e.what()));
  }
  for (const control::LawState& law : control::lawStates(*scene(), {}))
    for (const control::LawNumber& number : law.numbers)
      if (number.key == row.key() && number.scene == numbers) wanted.numbers.erase(row.key());
  Q_EMIT edited(robot(), wanted, numberName(row.key()),
                QStringLiteral("reaction/%1/%2").arg(robot(), QString::fromStdString(row.key())));
}

void ReactionPanel::choose(safety::StopReason reason, safety::StopResponse response) {
  control::ReactionChange wanted = change();
  const std::string key(safety::reasonKey(reason));
  if (scene()->stop.policy.of(reason) == response)
    wanted.responses.erase(key);
  else
    wanted.responses[key] = response;
  Q_EMIT edited(robot(), wanted, tr("%1: %2").arg(reasonText(reason), responseText(response)), {});
  refresh();
}

void ReactionPanel::switchLaw(const std::string& name, bool on) {
  control::ReactionChange wanted = change();
  wanted.laws.erase(name);
  for (const control::LawState& law : control::lawStates(*scene(), {}))
    if (law.name == name && law.scene_on != on) wanted.laws[name] = on;
  refresh();  // until the document says so
  try {
    control::changedReaction(*scene(), wanted, joints());
  } catch (const UsageError& e) {
    return head_->setText(QString::fromStdString(e.what()));
  }
  Q_EMIT edited(robot(), wanted, on ? tr("%1 on").arg(lawName(name)) : tr("%1 off").arg(lawName(name)), {});
}

}  // namespace abstand::ui
