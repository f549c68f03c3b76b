#include "ui/panels/inspector_panel.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/panels/joint_editor.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

const view::SceneOutline kNoScene;
constexpr int kPropertyWidth = 128, kJointsHeight = 170, kRowsHeight = 90;  // px, at first

void paintRow(QTreeWidgetItem* item, const InspectedRow& row) {
  QFont font = item->treeWidget()->font();
  font.setBold(row.mark == InspectedRow::Mark::kHeading);
  for (const int column : {0, 1}) {
    item->setText(column, column == 0 ? row.name : row.value);
    item->setToolTip(column, item->text(column));
    item->setFont(column, font);
  }
  item->setFirstColumnSpanned(row.mark == InspectedRow::Mark::kHeading);
  item->setForeground(1, row.mark == InspectedRow::Mark::kAlarm    ? QBrush(QColor(kVermillion))
                         : row.mark == InspectedRow::Mark::kInside ? QBrush(QColor(kOchre))
                                                                   : QBrush());
}

}  // namespace

InspectorPanel::InspectorPanel(QWidget* parent)
    : QWidget(parent),
      outline_{&kNoScene},
      title_{new QLabel(this)},
      rows_{new QTreeWidget(this)},
      joints_{new JointEditor(this)},
      person_{new PersonEditor(this)},
      joints_area_{new QScrollArea(this)} {
  title_->setObjectName(QStringLiteral("inspector_title"));
  title_->setContentsMargins(8, 6, 8, 2);
  title_->setWordWrap(true);
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  rows_->setAccessibleName(tr("Properties of what is selected"));
  rows_->setHeaderLabels({tr("Property"), tr("Value")});
  rows_->setRootIsDecorated(false);
  rows_->setUniformRowHeights(true);
  rows_->setAllColumnsShowFocus(true);
  rows_->setFrameShape(QFrame::NoFrame);
  rows_->setMinimumHeight(kRowsHeight);
  rows_->setColumnWidth(0, kPropertyWidth);
  rows_->header()->setStretchLastSection(true);
  joints_area_->setAccessibleName(tr("Joints"));
  joints_area_->setWidget(joints_);
  joints_area_->setWidgetResizable(true);
  joints_area_->setFrameShape(QFrame::NoFrame);
  joints_area_->setMinimumHeight(kJointsHeight);
  joints_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(title_);
  layout->addWidget(rows_, 2);
  layout->addWidget(joints_area_, 1);
  layout->addWidget(person_);
  open(kNoScene);
}

void InspectorPanel::open(const view::SceneOutline& outline) {
  outline_ = &outline;
  setSubject({}, -1);
}

void InspectorPanel::setSubject(const std::vector<int>& objects, int pair) {
  subject_ = inspectedSubject(*outline_, objects, pair);
  rows_->clear();
  shown_.clear();
  shown_step_ = -1;
  title_->setText(subject_.kind == SubjectKind::kNone
                      ? tr("Select a body, a robot or a person in the 3D view or in the scene tree.")
                      : subjectTitle(*outline_, subject_));
  showEditors();
}

void InspectorPanel::setWork(const Work& work) {
  const bool same_people = work.people == work_.people;
  work_ = work;
  if (subject_.robot >= 0)
    joints_->setPosed(work.posed.value(
        QString::fromStdString(outline_->robots[static_cast<std::size_t>(subject_.robot)].name)));
  if (!same_people) showEditors();
}

void InspectorPanel::showEditors() {
  joints_area_->setVisible(subject_.robot >= 0);
  person_->setVisible(subject_.person >= 0);
  joints_->open(*outline_, subject_.robot);
  if (subject_.robot >= 0) setWork(Work(work_));
  if (subject_.person < 0) return;
  const std::string& name = outline_->people[static_cast<std::size_t>(subject_.person)].name;
  person_->open(*outline_, subject_.person, work_.people.value(QString::fromStdString(name)));
}

void InspectorPanel::refresh(const view::SceneSnapshot& snapshot) {
  if (!in_front_ || subject_.kind == SubjectKind::kNone) return;
  const std::vector<InspectedRow> now = inspectedRows(*outline_, snapshot, subject_);
  while (rows_->topLevelItemCount() > static_cast<int>(now.size()))
    delete rows_->takeTopLevelItem(rows_->topLevelItemCount() - 1);
  for (std::size_t i = 0; i < now.size(); ++i) {
    QTreeWidgetItem* item = rows_->topLevelItem(static_cast<int>(i));
    if (!item) item = new QTreeWidgetItem(rows_);
    if (i >= shown_.size() || !(shown_[i] == now[i])) paintRow(item, now[i]);
  }
  shown_ = now;
  joints_->refresh(snapshot);
  shown_step_ = snapshot.step;
}

}  // namespace abstand::ui
