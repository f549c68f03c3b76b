#include "ui/panels/person_editor.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/panels/body_view.hpp"
#include "ui/style/calm_inputs.hpp"

namespace abstand::ui {

namespace {

// As `height`, `percentile` and `mass` of a person in a scene file.
constexpr double kMinStature = 0.5, kMaxStature = 2.5;     // m
constexpr double kMinPercentile = 1, kMaxPercentile = 99;  // per cent
constexpr double kMinMass = 10, kMaxMass = 300;            // kg
constexpr double kUsualPercentile = 50;

}  // namespace

PersonEditor::PersonEditor(QWidget* parent)
    : QWidget(parent),
      sex_{new CalmComboBox(this)},
      apply_{new QPushButton(tr("Rebuild the person"), this)},
      body_{new BodyView(this)} {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 4, 8, 4);
  form->setVerticalSpacing(2);
  stature_ = add(tr("Stature"), "stature", kMinStature, kMaxStature, tr(" m"));
  stature_.box->setDecimals(3);
  stature_.box->setSingleStep(0.01);
  percentile_ = add(tr("Percentile"), "percentile", kMinPercentile, kMaxPercentile, tr(" %"));
  percentile_.box->setDecimals(1);
  percentile_.box->setToolTip(
      tr("Girths, breadths and depths enclose those of this percentage of the people of that stature"));
  mass_ = add(tr("Mass"), "mass", kMinMass, kMaxMass, tr(" kg"));
  mass_.box->setDecimals(1);
  sex_->setObjectName(QStringLiteral("sex"));
  sex_->setAccessibleName(tr("Sex"));
  sex_->addItem(tr("as in the scene"), QString());
  sex_->addItem(tr("female"), QStringLiteral("f"));
  sex_->addItem(tr("male"), QStringLiteral("m"));
  form->addRow(tr("Sex"), sex_);
  apply_->setObjectName(QStringLiteral("rebuild_person"));
  apply_->setToolTip(tr("In the background; what is shown stays until the new person is there"));
  form->addRow(apply_);
  form->addRow(body_);
  connect(sex_, qOverload<int>(&QComboBox::currentIndexChanged), this, &PersonEditor::changed);
  connect(apply_, &QPushButton::clicked, this, [this] { Q_EMIT wanted(person_, options()); });
}

PersonEditor::Field PersonEditor::add(const QString& name, const char* object, double lower, double upper,
                                      const QString& unit) {
  Field field{new QCheckBox(name, this), new CalmSpinBox(this)};
  field.on->setObjectName(QString::fromLatin1(object) + QStringLiteral("_on"));
  field.on->setToolTip(tr("Not ticked: as in the scene"));
  field.box->setObjectName(QString::fromLatin1(object));
  field.box->setAccessibleName(name);
  field.box->setRange(lower, upper);
  field.box->setSuffix(unit);
  static_cast<QFormLayout*>(layout())->addRow(field.on, field.box);
  connect(field.on, &QCheckBox::toggled, field.box, &QWidget::setEnabled);
  connect(field.on, &QCheckBox::toggled, this, &PersonEditor::changed);
  connect(field.box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PersonEditor::changed);
  return field;
}

void PersonEditor::fill(const Field& field, const std::optional<double>& value, double usual) {
  const QSignalBlocker no_on(field.on), no_box(field.box);
  field.on->setChecked(value.has_value());
  field.box->setEnabled(value.has_value());
  field.box->setValue(value.value_or(usual));
}

void PersonEditor::open(const view::SceneOutline& outline, int person, const PersonOptions& present) {
  const view::PersonCard& card = outline.people[static_cast<std::size_t>(person)];
  person_ = QString::fromStdString(card.name);
  present_ = present;
  fill(stature_, present.stature, card.stature);
  fill(percentile_, present.percentile, card.percentile.value_or(kUsualPercentile));
  fill(mass_, present.mass, card.mass);
  const QSignalBlocker no_sex(sex_);
  sex_->setCurrentIndex(std::max(0, sex_->findData(present.sex)));
  apply_->setEnabled(false);
  preview();
}

PersonOptions PersonEditor::options() const {
  PersonOptions options;
  // A value that the field rounds stays as it was.
  const auto value = [](const Field& field, const std::optional<double>& before) -> std::optional<double> {
    if (!field.on->isChecked()) return std::nullopt;
    const bool kept =
        before && field.box->valueFromText(field.box->textFromValue(*before)) == field.box->value();
    return kept ? *before : field.box->value();
  };
  options.stature = value(stature_, present_.stature);
  options.percentile = value(percentile_, present_.percentile);
  options.mass = value(mass_, present_.mass);
  options.sex = sex_->currentData().toString();
  return options;
}

void PersonEditor::changed() {
  apply_->setEnabled(!(options() == present_));
  preview();
}

void PersonEditor::preview() {
  body_->setVisible(previewer_ != nullptr);
  if (previewer_) body_->show(previewer_(person_, options()));
}

}  // namespace abstand::ui
