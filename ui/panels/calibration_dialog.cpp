#include "ui/panels/calibration_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/panels/board_fields.hpp"
#include "ui/panels/path_field.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr int kCalibrationWidth = 640, kCalibrationHeight = 520;  // px

QString modeHint(CalibrationMode mode) {
  switch (mode) {
    case CalibrationMode::kRoom:
      return CalibrationDialog::tr(
          "Two cameras see the same room with surfaces in three directions, such as a floor and two walls. "
          "The first pose of this camera is within 0.2 m and 20 degrees.");
    case CalibrationMode::kPerson:
      return CalibrationDialog::tr(
          "The camera and another one, or motion capture, record the same person at the same time, who walks "
          "about for some seconds. The clocks may differ by 5 s.");
    case CalibrationMode::kLinks:
      return CalibrationDialog::tr(
          "The camera sees a robot of the scene that is shown, at the times of the scene. The first pose of "
          "the camera is within 0.1 m and 10 degrees.");
    case CalibrationMode::kChessboard:
      return CalibrationDialog::tr(
          "Infrared or colour images of a chessboard whose place in the world is known: its origin is the "
          "inner corner at the dark corner square, x along the first side, z towards the viewer.");
    case CalibrationMode::kPoints:
      return CalibrationDialog::tr(
          "A table cx,cy,cz,wx,wy,wz of points that are known in the axes of the camera and in the world, in "
          "metres; three or more, not on one line.");
  }
  return {};
}

QString factName(CalibrationFact::Kind kind) {
  using Kind = CalibrationFact::Kind;
  switch (kind) {
    case Kind::kPoints:
      return CalibrationDialog::tr("Points used");
    case Kind::kImages:
      return CalibrationDialog::tr("Images");
    case Kind::kWorst:
    case Kind::kWorstPixels:
      return CalibrationDialog::tr("Largest residual");
    case Kind::kShared:
      return CalibrationDialog::tr("Surfaces that the other camera sees, too");
    case Kind::kAgreeing:
      return CalibrationDialog::tr("Agreement in the common view");
    case Kind::kExplained:
      return CalibrationDialog::tr("Visible surface of the robot that was found");
    case Kind::kMoved:
      return CalibrationDialog::tr("Distance from the first pose");
    case Kind::kTurned:
      return CalibrationDialog::tr("Turn from the first pose");
    case Kind::kClock:
      return CalibrationDialog::tr("Offset of the clock");
    case Kind::kPersonMoved:
      return CalibrationDialog::tr("Way of the person");
  }
  return {};
}

QString factValue(const CalibrationFact& fact) {
  using Kind = CalibrationFact::Kind;
  switch (fact.kind) {
    case Kind::kPoints:
    case Kind::kImages:
      return fixed(fact.value, 0);
    case Kind::kWorst:
      return CalibrationDialog::tr("%1 in line %2").arg(lengthText(fact.value, 2), fact.where);
    case Kind::kWorstPixels:
      return CalibrationDialog::tr("%1 pixels in %2").arg(fixed(fact.value, 3), fact.where);
    case Kind::kShared:
    case Kind::kAgreeing:
    case Kind::kExplained:
      return CalibrationDialog::tr("%1 %").arg(fixed(100.0 * fact.value, 0));
    case Kind::kTurned:
      return angleText(fact.value, 2);
    case Kind::kClock:
      return secondsWithUnit(fact.value);
    case Kind::kMoved:
    case Kind::kPersonMoved:
      return lengthText(fact.value);
  }
  return {};
}

QString calibrationOutcome(const CalibrationAnswer& answer) {
  QString text = CalibrationDialog::tr("The camera is at %1, %2, %3.")
                     .arg(lengthText(answer.xyz.x()), lengthText(answer.xyz.y()), lengthText(answer.xyz.z()));
  text +=
      QLatin1Char(' ') +
      CalibrationDialog::tr(
          "Its pose moves the points that it sees by %1 (standard deviation along an axis). Tracking adds "
          "this to the uncertainty of each joint, which widens the margins by at most %2.")
          .arg(lengthText(answer.spread, 2), lengthText(answer.widening, 2));
  for (const QString& warning : answer.warnings)
    text += QLatin1Char('\n') + CalibrationDialog::tr("Warning: %1").arg(warning);
  return text;
}

}  // namespace

CalibrationDialog::CalibrationDialog(const QStringList& robots, QWidget* parent)
    : QDialog(parent),
      mode_{new QComboBox(this)},
      hint_{new QLabel(this)},
      form_{new QGridLayout},
      robot_{new QComboBox(this)},
      board_{new BoardFields(this)},
      table_{new QTableWidget(0, 2, this)},
      sentence_{new QLabel(this)},
      busy_{new QProgressBar(this)} {
  setObjectName(QStringLiteral("calibration"));
  setWindowTitle(tr("Calibrate a depth camera"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(kCalibrationWidth, kCalibrationHeight);
  buildFields(robots);
  hint_->setWordWrap(true);
  table_->setAccessibleName(tr("Quality of the calibration"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  busy_->setRange(0, 0);
  busy_->setAccessibleName(tr("The pose is being computed"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  compute_ = buttons->addButton(tr("&Compute"), QDialogButtonBox::ActionRole);
  save_ = buttons->addButton(tr("&Save camera file…"), QDialogButtonBox::ActionRole);
  stop_ = buttons->addButton(tr("S&top"), QDialogButtonBox::ActionRole);
  compute_->setDefault(true);
  connect(compute_, &QPushButton::clicked, this, &CalibrationDialog::ask);
  connect(save_, &QPushButton::clicked, this, [this] { Q_EMIT saveWanted(found_); });
  connect(stop_, &QPushButton::clicked, this, &CalibrationDialog::stop);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this, &QDialog::finished, this, &CalibrationDialog::stop);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  layout->addWidget(table_, 1);
  layout->addWidget(sentence_);
  layout->addWidget(busy_);
  layout->addStretch();
  layout->addWidget(buttons);
  setWaiting(false);
  showMode();
}

void CalibrationDialog::buildFields(const QStringList& robots) {
  using Kind = PathField::Kind;
  camera_ = new PathField(Kind::kFile, QStringLiteral("calibration_camera"),
                          tr("Camera files (*.yaml *.yml)"), this);
  clip_ = new PathField(Kind::kRecording, QStringLiteral("calibration_clip"), {}, this);
  reference_ = new PathField(Kind::kRecording, QStringLiteral("calibration_reference"), {}, this);
  images_ = new PathField(Kind::kFiles, QStringLiteral("calibration_images"), tr("Images (*.png)"), this);
  points_ = new PathField(Kind::kFile, QStringLiteral("calibration_points"), tr("Tables (*.csv)"), this);
  mode_->setObjectName(QStringLiteral("calibration_mode"));
  mode_->addItem(tr("By the room that another camera sees, too"));
  mode_->addItem(tr("By a person whom another camera sees, too"));
  mode_->addItem(tr("By the links of a robot of the scene"));
  mode_->addItem(tr("By images of a chessboard"));
  mode_->addItem(tr("By a table of points"));
  robot_->setObjectName(QStringLiteral("calibration_robot"));
  robot_->addItems(robots);
  const auto add = [this](const QString& name, QWidget* field) {
    auto* label = new QLabel(name, this);
    label->setBuddy(field);
    const int row = form_->rowCount();
    form_->addWidget(label, row, 0);
    form_->addWidget(field, row, 1);
  };
  add(tr("&Method"), mode_);
  form_->addWidget(hint_, form_->rowCount(), 0, 1, 2);
  add(tr("Depth &recording of this camera"), clip_);
  add(tr("Recording &known in the world"), reference_);
  add(tr("R&obot"), robot_);
  add(tr("&Images"), images_);
  add(tr("Board"), board_);
  add(tr("Table of &points"), points_);
  add(tr("Camera &file"), camera_);
  camera_->setToolTip(
      tr("With the lens of the camera, and its first pose where the method needs one; empty: "
         "as the depth recording says"));
  connect(mode_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CalibrationDialog::showMode);
  for (const PathField* field : {camera_, clip_, reference_, images_, points_})
    connect(field, &PathField::changed, this, [this] {
      forget();
      checkFields();
    });
}

CalibrationMode CalibrationDialog::mode() const {
  return static_cast<CalibrationMode>(mode_->currentIndex());
}

void CalibrationDialog::showMode() {
  const auto show_row = [this](QWidget* field, bool visible) {
    field->setVisible(visible);
    for (QLabel* label : findChildren<QLabel*>())
      if (label->buddy() == field) label->setVisible(visible);
  };
  const CalibrationMode now = mode();
  const bool two = now == CalibrationMode::kRoom || now == CalibrationMode::kPerson;
  show_row(clip_, two || now == CalibrationMode::kLinks);
  show_row(reference_, two);
  show_row(robot_, now == CalibrationMode::kLinks);
  show_row(images_, now == CalibrationMode::kChessboard);
  show_row(board_, now == CalibrationMode::kChessboard);
  show_row(points_, now == CalibrationMode::kPoints);
  hint_->setText(modeHint(now));
  forget();
  checkFields();
}

/// What was found is not of what the fields say now.
void CalibrationDialog::forget() {
  found_.clear();
  table_->setRowCount(0);
  table_->hide();
  sentence_->clear();
}

void CalibrationDialog::checkFields() {
  const CalibrationMode now = mode();
  bool filled = true;
  switch (now) {
    case CalibrationMode::kRoom:
    case CalibrationMode::kPerson:
      filled = !clip_->path().isEmpty() && !reference_->path().isEmpty();
      break;
    case CalibrationMode::kLinks:
      filled = !clip_->path().isEmpty() && robot_->count() > 0;
      break;
    case CalibrationMode::kChessboard:
      filled = !images_->paths().isEmpty() && !camera_->path().isEmpty();
      break;
    case CalibrationMode::kPoints:
      filled = !points_->path().isEmpty() && !camera_->path().isEmpty();
      break;
  }
  compute_->setEnabled(filled && !waiting_);
  save_->setEnabled(!found_.isEmpty() && !waiting_);
  if (now == CalibrationMode::kLinks && robot_->count() == 0 && !waiting_)
    sentence_->setText(tr("The scene that is shown has no robot."));
}

void CalibrationDialog::setRequest(const CalibrationRequest& request) {
  mode_->setCurrentIndex(static_cast<int>(request.mode));
  camera_->field()->setText(request.camera);
  (request.mode == CalibrationMode::kPoints ? points_ : clip_)->field()->setText(request.clip);
  reference_->field()->setText(request.reference);
  images_->field()->setText(request.images.join(QLatin1Char(';')));
  robot_->setCurrentIndex(robot_->findText(request.robot));
  board_->show(request);
}

CalibrationRequest CalibrationDialog::request() const {
  CalibrationRequest request;
  request.mode = mode();
  request.camera = camera_->path();
  request.clip = request.mode == CalibrationMode::kPoints ? points_->path() : clip_->path();
  request.reference = reference_->path();
  request.robot = robot_->currentText();
  request.images = images_->paths();
  board_->fill(request);
  return request;
}

void CalibrationDialog::setWaiting(bool waiting) {
  waiting_ = waiting;
  busy_->setVisible(waiting);
  stop_->setEnabled(waiting);
  for (QWidget* each :
       std::initializer_list<QWidget*>{mode_, camera_, clip_, reference_, images_, points_, robot_, board_})
    each->setEnabled(!waiting);
  checkFields();
}

void CalibrationDialog::ask() {
  forget();
  setWaiting(true);
  sentence_->setText(tr("Computing the pose…"));
  Q_EMIT wanted(request());
}

void CalibrationDialog::stop() {
  if (!waiting_) return;
  setWaiting(false);
  sentence_->setText(tr("Stopped."));
  Q_EMIT cancelled();
}

void CalibrationDialog::show(const CalibrationAnswer& answer) {
  found_ = answer.camera;
  setWaiting(false);
  table_->setRowCount(0);
  const auto add = [this](const QString& name, const QString& value, const QString& tip) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* number = new QTableWidgetItem(value);
    number->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setItem(row, 0, new QTableWidgetItem(name));
    table_->setItem(row, 1, number);
    for (int column = 0; column < 2; ++column) table_->item(row, column)->setToolTip(tip);
  };
  add(tr("Residual (RMS)"),
      answer.in_pixels ? tr("%1 pixels").arg(fixed(answer.residual, 3)) : lengthText(answer.residual, 2),
      tr("How far apart what the camera measures and what is known in the world remain; the noise of the "
         "camera is part of it"));
  add(tr("Uncertainty of the pose"), lengthText(answer.spread, 2),
      tr("Standard deviation of the position of a seen point along an axis, due to the pose"));
  for (const CalibrationFact& fact : answer.facts) add(factName(fact.kind), factValue(fact), {});
  table_->show();
  sentence_->setText(calibrationOutcome(answer));
}

void CalibrationDialog::fail(const QString& problem) {
  setWaiting(false);
  sentence_->setText(problem);
}

}  // namespace abstand::ui
