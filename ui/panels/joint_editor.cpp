#include "ui/panels/joint_editor.hpp"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/model/pose_text.hpp"
#include "ui/panels/joint_row.hpp"

namespace abstand::ui {

JointEditor::JointEditor(QWidget* parent)
    : QWidget(parent),
      state_{new QLabel(this)},
      follow_{new QPushButton(tr("Follow the motion"), this)},
      copy_{new QToolButton(this)},
      layout_{new QVBoxLayout(this)} {
  state_->setObjectName(QStringLiteral("joints_state"));
  state_->setWordWrap(true);
  state_->setToolTip(
      tr("While a robot is posed by hand, the clock continues for everything else and its reaction is "
         "suspended.\n"
         "Lanes, events and reports stay those of its recorded motion."));
  follow_->setObjectName(QStringLiteral("follow_motion"));
  follow_->setToolTip(tr("Ends the posing by hand. Robots that react begin anew on their planned motion"));
  follow_->setFocusPolicy(Qt::TabFocus);
  auto* head = new QHBoxLayout;
  head->addWidget(state_, 1);
  head->addWidget(follow_);
  head->addWidget(copy_);
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Put the joints of the robot on the clipboard (rad, m)"));
  copy_->setPopupMode(QToolButton::InstantPopup);
  copy_->setFocusPolicy(Qt::TabFocus);
  auto* menu = new QMenu(copy_);
  copy_->setMenu(menu);
  const std::pair<const char*, PoseFormat> formats[] = {
      {"JSON", PoseFormat::kJson}, {"YAML", PoseFormat::kYaml}, {"C++", PoseFormat::kCpp}};
  for (const auto& [name, format] : formats)
    connect(menu->addAction(QString::fromLatin1(name)), &QAction::triggered, this, [this, f = format] {
      QApplication::clipboard()->setText(poseText(f, names_, posed_.isEmpty() ? shown_ : posed_));
    });
  layout_->setContentsMargins(8, 4, 8, 4);
  layout_->setSpacing(1);
  layout_->addLayout(head);
  connect(follow_, &QPushButton::clicked, this, [this] { Q_EMIT followWanted(robot_); });
}

void JointEditor::open(const view::SceneOutline& outline, int robot) {
  for (JointRow* row : rows_) delete row;
  rows_.clear();
  robot_ = robot;
  posed_.clear();
  names_.clear();
  shown_.clear();
  if (robot < 0) return;
  const view::RobotCard& card = outline.robots[static_cast<std::size_t>(robot)];
  name_ = QString::fromStdString(card.name);
  first_joint_ = card.first_joint;
  for (int k = 0; k < card.joints; ++k) {
    auto* row = new JointRow(outline.joints[static_cast<std::size_t>(first_joint_ + k)], this);
    connect(row, &JointRow::edited, this, [this, k](double value) { Q_EMIT edited(robot_, k, value); });
    connect(row, &JointRow::released, this, &JointEditor::released);
    names_ << QString::fromStdString(outline.joints[static_cast<std::size_t>(first_joint_ + k)].name);
    layout_->addWidget(row);
    rows_.push_back(row);
  }
  showState();
}

void JointEditor::setPosed(const QVector<double>& posed) {
  posed_ = posed.size() == static_cast<int>(rows_.size()) ? posed : QVector<double>();
  for (int k = 0; k < posed_.size(); ++k) row(k)->show(posed_[k]);
  showState();
}

void JointEditor::showState() {
  state_->setText(posed_.isEmpty() ? tr("%1 is not posed by hand").arg(name_)
                                   : tr("%1 is posed by hand").arg(name_));
  follow_->setEnabled(!posed_.isEmpty());
}

void JointEditor::refresh(const view::SceneSnapshot& snapshot) {
  if (!posed_.isEmpty()) return;
  shown_.resize(static_cast<int>(rows_.size()));
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto i = static_cast<std::size_t>(first_joint_) + k;
    if (i < snapshot.joint_positions.size())
      rows_[k]->show(shown_[static_cast<int>(k)] = snapshot.joint_positions[i]);
  }
}

}  // namespace abstand::ui
