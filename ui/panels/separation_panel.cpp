// Speed and separation monitoring, and contact limits, at the moment.
#include "ui/panels/separation_panel.hpp"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>

#include "ui/panels/separation_chart.hpp"
#include "ui/style/calm_inputs.hpp"
#include "ui/style/elided_label.hpp"

namespace abstand::ui {

namespace {
constexpr int kFormWidth = 232, kFieldWidth = 92;  // px
const view::SceneOutline kNothingOpen;
}  // namespace

SeparationPanel::SeparationPanel(QWidget* parent)
    : QWidget(parent),
      outline_{&kNothingOpen},
      clamped_{new QCheckBox(tr("The part is clamped"), this)},
      table_{new ElidedLabel(this)},
      chart_{new SeparationChart} {
  auto* form_box = new QWidget;
  auto* form = new QFormLayout(form_box);
  form->setContentsMargins(8, 4, 8, 4);
  form->setVerticalSpacing(2);
  safety::SeparationOptions& set = settings_.options;
  form->addRow(tr("Reaction"), addField("reaction_time", set.reaction_time, 10.0, 1.0, tr(" s"), 2));
  form->addRow(tr("Stopping"), addField("stopping_time", set.stopping_time, 10.0, 1.0, tr(" s"), 2));
  auto* deceleration = addField("deceleration", set.deceleration, 1e3, 1.0, tr(" m/s²"), 1);
  deceleration->setSpecialValueText(tr("as above"));
  deceleration->setToolTip(
      tr("Deceleration along the approach; with it, the stopping time is speed by deceleration"));
  form->addRow(tr("or decelerates"), deceleration);
  form->addRow(tr("Intrusion C"), addField("intrusion", set.intrusion, 10.0, 1e3, tr(" mm"), 0));
  form->addRow(tr("Person Z_d"), addField("person_error", set.person_error, 10.0, 1e3, tr(" mm"), 0));
  form->addRow(tr("Robot Z_r"), addField("robot_error", set.robot_error, 10.0, 1e3, tr(" mm"), 0));
  auto* mass = addField("robot_mass", settings_.robot_mass, 1e4, 1.0, tr(" kg"), 1);
  mass->setSpecialValueText(tr("immovable"));
  mass->setToolTip(
      tr("Effective mass of the robot in a contact; where it is not known, it counts as immovable"));
  form->addRow(tr("Robot mass"), mass);
  form->addRow(clamped_);
  form->addRow(table_);
  clamped_->setObjectName(QStringLiteral("clamped"));
  clamped_->setToolTip(tr("A part that cannot recoil has the lower limit of a quasi-static contact"));
  table_->setForegroundRole(QPalette::PlaceholderText);
  auto* form_area = new QScrollArea(this);
  form_area->setWidget(form_box);
  form_area->setWidgetResizable(true);
  form_area->setFrameShape(QFrame::NoFrame);
  form_area->setFixedWidth(kFormWidth);
  form_area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  form_area->setAccessibleName(tr("What separation is judged with"));
  auto* chart_area = new QScrollArea(this);
  chart_area->setAccessibleName(chart_->accessibleName());
  chart_area->setWidget(chart_);
  chart_area->setWidgetResizable(true);
  chart_area->setFrameShape(QFrame::NoFrame);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(form_area);
  layout->addWidget(chart_area, 1);
  connect(clamped_, &QCheckBox::clicked, this, [this](bool clamped) {
    SeparationSettings wanted = settings_;
    wanted.clamped = clamped;
    Q_EMIT edited(wanted);
  });
  connect(chart_, &SeparationChart::pairPicked, this, &SeparationPanel::pairPicked);
  setLimits(nullptr);
}

QDoubleSpinBox* SeparationPanel::addField(const char* name, double& value, double most, double scale,
                                          const QString& suffix, int decimals) {
  auto* box = new CalmSpinBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setDecimals(decimals);
  box->setRange(0.0, most * scale);
  box->setSingleStep(decimals == 0 ? 10.0 : decimals == 1 ? 0.5 : 0.05);
  box->setSuffix(suffix);
  box->setValue(value * scale);
  box->setKeyboardTracking(false);
  box->setFixedWidth(kFieldWidth);
  fields_.push_back({box, &value, scale});
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, &value, scale](double shown) {
            // The owner takes it over by setSettings().
            const double before = value;
            value = shown / scale;
            const SeparationSettings wanted = settings_;
            value = before;
            Q_EMIT edited(wanted);
          });
  return box;
}

void SeparationPanel::setLimits(std::shared_ptr<const contact::ContactLimits> limits) {
  limits_ = std::move(limits);
  table_->setText(limits_ ? QString::fromStdString(limits_->edition) : tr("No table of contact limits"));
  table_->setToolTip(limits_ ? QString::fromStdString(limits_->stamp()) : QString());
}

void SeparationPanel::open(const view::SceneOutline& outline) {
  outline_ = &outline;
  chart_->open(outline);
}

void SeparationPanel::setSettings(const SeparationSettings& settings) {
  settings_ = settings;
  for (const Field& field : fields_) {
    const QSignalBlocker quiet(field.box);
    field.box->setValue(*field.value * field.scale);
  }
  clamped_->setChecked(settings.clamped);
}

void SeparationPanel::refresh(const view::SceneSnapshot& snapshot) {
  if (!isVisible() || visibleRegion().isEmpty()) return;
  chart_->show(separationRows(*outline_, snapshot, settings_, limits_.get()), settings_);
}

}  // namespace abstand::ui
