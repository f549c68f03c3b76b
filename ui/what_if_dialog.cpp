#include "ui/what_if_dialog.hpp"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <vector>

#include "ui/style/number_box.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr int kWhatIfWidth = 460;  // px

/// How a number of WhatIfSettings is shown.
struct ShownAssumption {
  const char* name;
  const char* label;
  const char* tip;
  const char* suffix;
  double factor;  ///< of the number in the box
  double step;    ///< of the box
  int decimals;
};
#define TEXT(s) QT_TRANSLATE_NOOP("abstand::ui", s)  // scripts/translations knows this name
const std::array<ShownAssumption, 6> kAssumptions{
    {{"limit", TEXT("Clearance &limit"), TEXT("Clearance that a moving robot must keep; 0: no contact"),
      " mm", 1e3, 10.0, 1},
     {"reaction_time", TEXT("&Reaction time"),
      TEXT("From the frame that breaks a margin until the robot slows down: sensor, network and controller"),
      " s", 1.0, 0.01, 3},
     {"deceleration", TEXT("&Deceleration"), TEXT("Of every joint, on the path of its motion"),
      " rad/s² | m/s²", 1.0, 0.5, 3},
     {"restart_time", TEXT("Re&start time"), TEXT("From the end of an intrusion until the robot resumes"),
      " s", 1.0, 0.1, 3},
     {"calibration_error", TEXT("&Calibration error"),
      TEXT("Largest error between the frames of recording and robots; part of every uncertainty"), " mm", 1e3,
      1.0, 1},
     {"latency", TEXT("Age of &poses"), TEXT("How old a person's pose is when it arrives"), " s", 1.0, 0.01,
      3}}};
#undef TEXT

}  // namespace

std::optional<WhatIfSettings> askWhatIf(const WhatIfSettings& present, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("what_if_settings"));
  dialog.setWindowTitle(tr("What-if assumptions"));
  dialog.resize(kWhatIfWidth, 0);
  auto* head = new QLabel(tr("Lanes, events, margin curve, proposed margins and report are "
                             "judged with these numbers of your cell; "
                             "they are those of \"abstand tune\". Another reaction time, "
                             "deceleration, limit, calibration error or "
                             "age of poses runs the analysis of the recording again."),
                          &dialog);
  head->setWordWrap(true);
  auto* form = new QFormLayout;
  WhatIfSettings wanted = present;
  std::vector<std::pair<double*, NumberBox*>> boxes;
  WhatIfSettings::eachNumber(wanted, [&](const char* name, double& value, const config::NumberRule& rule) {
    const auto shown = std::find_if(
        kAssumptions.begin(), kAssumptions.end(),
        [&](const ShownAssumption& each) { return QLatin1String(each.name) == QLatin1String(name); });
    auto* box = new NumberBox(&dialog);
    box->setObjectName(QString::fromLatin1(name));
    box->setDecimals(shown->decimals);
    box->setRange(rule.min * shown->factor, rule.max * shown->factor);
    box->setSingleStep(shown->step);
    box->setSuffix(QString::fromUtf8(shown->suffix));
    box->setValue(value * shown->factor);
    box->setToolTip(tr(shown->tip));
    form->addRow(tr(shown->label), box);
    boxes.emplace_back(&value, box);
  });
  auto* buttons = new QDialogButtonBox(
      QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, &dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  const auto factor_of = [](const NumberBox* box) {
    for (const ShownAssumption& each : kAssumptions)
      if (box->objectName() == QLatin1String(each.name)) return each.factor;
    return 1.0;
  };
  QObject::connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, &dialog, [&] {
    const WhatIfSettings usual;
    auto box = boxes.begin();
    WhatIfSettings::eachNumber(usual, [&](const char*, const double& value, const auto&) {
      box->second->setValue(value * factor_of(box->second));
      ++box;
    });
  });
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(head);
  layout->addLayout(form);
  layout->addWidget(buttons);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  for (const auto& [value, box] : boxes) {
    // A number that the box rounds stays as it was.
    const double factor = factor_of(box);
    if (box->value() != box->valueFromText(box->textFromValue(*value * factor)))
      *value = box->value() / factor;
  }
  return wanted;
}

}  // namespace abstand::ui
