#include "ui/panels/inspector_panel.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/math/roll_pitch_yaw.hpp"
#include "ui/model/groups.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/panels/placement_editor.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

const view::SceneOutline kNoScene;
constexpr int kPropertyWidth = 128, kJointsHeight = 170, kRowsHeight = 90,
              kEditorsHeight = 96;  // px, at first

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
      placement_{new PlacementEditor(this)},
      joints_area_{new QScrollArea(this)},
      editors_area_{new QScrollArea(this)} {
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
  auto* editors = new QWidget(editors_area_);
  auto* column = new QVBoxLayout(editors);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(placement_);
  column->addWidget(person_);
  column->addStretch();
  editors_area_->setAccessibleName(tr("Place and person"));
  editors_area_->setWidget(editors);
  editors_area_->setWidgetResizable(true);
  editors_area_->setFrameShape(QFrame::NoFrame);
  editors_area_->setMinimumHeight(kEditorsHeight);
  editors_area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(title_);
  layout->addWidget(rows_, 2);
  layout->addWidget(joints_area_, 1);
  layout->addWidget(editors_area_, 3);
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
  showPlacement();
}

/// Of a body part or a link it is the place of the person or the robot.
void InspectorPanel::openPlacement() {
  using Kind = PlacementEditor::Kind;
  X_thing_ = Transform::Identity();
  const auto name = [](const std::string& s) { return QString::fromStdString(s); };
  if (subject_.robot >= 0)
    placement_->open(Kind::kRobot, name(outline_->robots[static_cast<std::size_t>(subject_.robot)].name));
  else if (subject_.person >= 0)
    placement_->open(Kind::kPerson, name(outline_->people[static_cast<std::size_t>(subject_.person)].name));
  else if (subject_.kind == SubjectKind::kBody &&
           isThing(outline_->objects[static_cast<std::size_t>(subject_.objects.front())]))
    placement_->open(Kind::kThing,
                     name(outline_->objects[static_cast<std::size_t>(subject_.objects.front())].name));
  else
    placement_->open(Kind::kNone, QString());
  showPlacement();
}

void InspectorPanel::showPlacement() {
  using Kind = PlacementEditor::Kind;
  if (placement_->kind() == Kind::kNone) return;
  const auto& places = placement_->kind() == Kind::kThing ? work_.things : work_.placed;
  const auto own = places.find(placement_->name());
  if (own != places.end()) return placement_->show(*own, true);
  if (placement_->kind() == Kind::kPerson) {
    const view::PersonCard& card = outline_->people[static_cast<std::size_t>(subject_.person)];
    return placement_->show({card.place_xyz, Vector3d(0.0, 0.0, card.place_yaw)}, false);
  }
  const Transform& X_WB = placement_->kind() == Kind::kRobot
                              ? outline_->robots[static_cast<std::size_t>(subject_.robot)].X_WB
                              : X_thing_;
  placement_->show({X_WB.translation(), neatRollPitchYaw(X_WB.linear())}, false);
}

void InspectorPanel::showEditors() {
  joints_area_->setVisible(subject_.robot >= 0);
  person_->setVisible(subject_.person >= 0);
  openPlacement();
  QWidget* editors = editors_area_->widget();
  editors->layout()->activate();
  editors_area_->setMaximumHeight(editors->sizeHint().height());
  editors_area_->setVisible(placement_->kind() != PlacementEditor::Kind::kNone || subject_.person >= 0);
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
  if (placement_->kind() == PlacementEditor::Kind::kThing && !work_.things.contains(placement_->name())) {
    const Transform& X_WB = snapshot.objects[static_cast<std::size_t>(subject_.objects.front())].X_WB;
    if (X_WB.matrix() != X_thing_.matrix()) {
      X_thing_ = X_WB;
      showPlacement();
    }
  }
  shown_step_ = snapshot.step;
}

}  // namespace abstand::ui
