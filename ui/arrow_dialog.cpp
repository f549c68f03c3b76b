// View > Arrows.
#include "ui/arrow_dialog.hpp"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>

#include "ui/style/number_box.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

struct ArrowNumber {
  double ViewOptions::*member;
  const char* name;  ///< of its field
  double shown;      ///< shown unit in the unit of the member
  int decimals;
};
constexpr ArrowNumber kArrowNumbers[] = {
    {&ViewOptions::metres_per_newton, "per_newton", 1e3, 2},
    {&ViewOptions::metres_per_newton_metre, "per_newton_metre", 1e3, 2},
    {&ViewOptions::metres_per_metre_per_second, "per_metre_per_second", 1e3, 1},
    {&ViewOptions::min_force, "least_force", 1.0, 2},
    {&ViewOptions::min_torque, "least_torque", 1.0, 3},
    {&ViewOptions::min_speed, "least_speed", 1.0, 3}};

}  // namespace

std::optional<ViewOptions> askArrows(const ViewOptions& present, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("arrows"));
  dialog.setWindowTitle(tr("Arrows"));
  auto* automatic = new QCheckBox(tr("&Scale to the largest in sight"), &dialog);
  automatic->setObjectName(QStringLiteral("automatic"));
  automatic->setChecked(present.auto_scale);
  auto* form = new QFormLayout(&dialog);
  form->addRow(automatic);
  const QString labels[] = {tr("Length per &newton"),
                            tr("Length per ne&wton metre"),
                            tr("Length per &metre per second"),
                            tr("Least &force"),
                            tr("Least &torque"),
                            tr("Least s&peed")};
  const QString units[] = {QStringLiteral(" mm/N"), QStringLiteral(" mm/(N·m)"), QStringLiteral(" mm/(m/s)"),
                           QStringLiteral(" N"),    QStringLiteral(" N·m"),      QStringLiteral(" m/s")};
  std::vector<NumberBox*> boxes;
  for (std::size_t i = 0; i < std::size(kArrowNumbers); ++i) {
    const ArrowNumber& number = kArrowNumbers[i];
    auto* box = new NumberBox(&dialog);
    box->setObjectName(QString::fromLatin1(number.name));
    box->setDecimals(number.decimals);
    box->setRange(i < 3 ? 0.01 : 0.0, 1e4);
    box->setSuffix(units[i]);
    box->setValue(present.*number.member * number.shown);
    box->setEnabled(i >= 3 || !present.auto_scale);
    if (i < 3) QObject::connect(automatic, &QCheckBox::toggled, box, &QWidget::setDisabled);
    form->addRow(labels[i], box);
    boxes.push_back(box);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  form->addRow(buttons);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  ViewOptions options = present;
  options.auto_scale = automatic->isChecked();
  for (std::size_t i = 0; i < std::size(kArrowNumbers); ++i) {
    // A value that the field rounds stays as it was.
    double& value = options.*kArrowNumbers[i].member;
    if (boxes[i]->value() != boxes[i]->valueFromText(boxes[i]->textFromValue(value * kArrowNumbers[i].shown)))
      value = boxes[i]->value() / kArrowNumbers[i].shown;
  }
  return options;
}

}  // namespace abstand::ui
