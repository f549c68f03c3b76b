#include "ui/panels/live_camera_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/panels/path_field.hpp"
#include "ui/style/file_kinds.hpp"
#include "ui/style/format.hpp"
#include "ui/style/number_box.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

constexpr int kLiveCameraWidth = 560;    // px
constexpr double kTallestPerson = 2.5;   // m, as `abstand track --height`
constexpr double kShortestPerson = 0.5;  // m, likewise; below: measured

}  // namespace

LiveCameraDialog::LiveCameraDialog(QWidget* parent)
    : QDialog(parent),
      scene_{new PathField(PathField::Kind::kFile, QStringLiteral("live_scene"), openFilter(), this)},
      camera_{new PathField(PathField::Kind::kFile, QStringLiteral("live_camera"),
                            tr("Camera files (*.yaml *.yml)"), this)},
      second_{new PathField(PathField::Kind::kFile, QStringLiteral("live_second"),
                            tr("Camera files (*.yaml *.yml)"), this)},
      person_{new QComboBox(this)},
      height_{new NumberBox(this)},
      still_{new QCheckBox(tr("&Robots stand still where their motion begins"), this)},
      sentence_{new QLabel(this)},
      busy_{new QProgressBar(this)} {
  setObjectName(QStringLiteral("live_camera_dialog"));
  setWindowTitle(tr("Open a live depth camera"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(kLiveCameraWidth);
  auto* head = new QLabel(
      tr("One or two Kinects v1 at this computer move the person of a scene. Robots are lost until a program "
         "sends their joint values, unless they stand still."),
      this);
  head->setWordWrap(true);
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  busy_->setRange(0, 0);
  busy_->setAccessibleName(tr("Progress"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  start_ = buttons->addButton(tr("S&tart"), QDialogButtonBox::ActionRole);
  stop_ = buttons->addButton(tr("St&op"), QDialogButtonBox::ActionRole);
  start_->setDefault(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(head);
  buildFields();
  layout->addWidget(sentence_);
  layout->addWidget(busy_);
  layout->addStretch();
  layout->addWidget(buttons);
  connect(start_, &QPushButton::clicked, this, &LiveCameraDialog::ask);
  connect(stop_, &QPushButton::clicked, this, &LiveCameraDialog::stop);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::finished, this, &LiveCameraDialog::stop);
  setWaiting(false);
}

void LiveCameraDialog::buildFields() {
  person_->setObjectName(QStringLiteral("live_person"));
  person_->setEditable(true);
  person_->setToolTip(tr("Name in the scene of the person whom the camera sees"));
  height_->setObjectName(QStringLiteral("live_height"));
  height_->setSpecialValueText(tr("measured in the first images"));
  still_->setToolTip(tr("The distances hold only if that is so: nothing measures the robots"));
  height_->setToolTip(tr("Height of the person; a known height needs no measurement"));
  camera_->setToolTip(
      tr("With the pose of the camera in the world of the scene: View, Calibrate a depth camera"));
  second_->field()->setPlaceholderText(tr("none"));
  second_->setToolTip(
      tr("Camera file of the second Kinect in the order of the driver; both are fitted together"));
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Scene"), scene_);
  form->addRow(tr("Camera &file"), camera_);
  form->addRow(tr("Seco&nd camera"), second_);
  form->addRow(tr("&Person"), person_);
  form->addRow(tr("&Height"), height_);
  form->addRow(QString(), still_);
  static_cast<QVBoxLayout*>(layout())->addLayout(form);
  for (const PathField* field : {scene_, camera_})
    connect(field, &PathField::changed, this, &LiveCameraDialog::checkFields);
  connect(person_, &QComboBox::editTextChanged, this, &LiveCameraDialog::checkFields);
  connect(height_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double shown) {
    metres_ = shown / lengthFactor();
    if (metres_ < kShortestPerson) metres_ = 0.0;
  });
  connect(&Units::shown(), &Units::changed, this, &LiveCameraDialog::applyUnits);
  applyUnits();
}

void LiveCameraDialog::applyUnits() {
  const QSignalBlocker quiet(height_);
  height_->setDecimals(lengthDecimals(0));
  // The lowest value says "measured".
  height_->setRange((kShortestPerson - 0.01) * lengthFactor(), kTallestPerson * lengthFactor());
  height_->setSingleStep(0.01 * lengthFactor());
  height_->setSuffix(QLatin1Char(' ') + lengthUnit());
  height_->setValue(metres_ * lengthFactor());
}

void LiveCameraDialog::setRequest(const LiveCameraRequest& request, const QStringList& people) {
  scene_->field()->setText(request.scene);
  camera_->field()->setText(request.camera);
  second_->field()->setText(request.second);
  person_->clear();
  person_->addItems(people);
  person_->setEditText(request.person);
  metres_ = request.height;
  still_->setChecked(request.still);
  applyUnits();
  checkFields();
}

LiveCameraRequest LiveCameraDialog::request() const {
  return {scene_->path(), camera_->path(),     person_->currentText().trimmed(),
          metres_,        still_->isChecked(), second_->path()};
}

void LiveCameraDialog::checkFields() {
  const LiveCameraRequest now = request();
  start_->setEnabled(!waiting_ && !now.scene.isEmpty() && !now.camera.isEmpty() && !now.person.isEmpty());
}

void LiveCameraDialog::setWaiting(bool waiting) {
  waiting_ = waiting;
  busy_->setVisible(waiting);
  stop_->setEnabled(waiting);
  for (QWidget* each : std::initializer_list<QWidget*>{scene_, camera_, second_, person_, height_, still_})
    each->setEnabled(!waiting);
  checkFields();
}

void LiveCameraDialog::ask() {
  setWaiting(true);
  say({});
  Q_EMIT wanted(request());
}

void LiveCameraDialog::stop() {
  if (!waiting_) return;
  setWaiting(false);
  sentence_->setText(tr("Stopped."));
  Q_EMIT cancelled();
}

void LiveCameraDialog::say(const QString& progress) { sentence_->setText(progress); }

void LiveCameraDialog::fail(const QString& problem) {
  setWaiting(false);
  sentence_->setText(problem);
}

}  // namespace abstand::ui
