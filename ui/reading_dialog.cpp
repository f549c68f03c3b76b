#include "ui/reading_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>

#include "ui/style/number_box.hpp"

namespace abstand::ui {

namespace {

constexpr double kSlowest = 0.01, kFastest = 100.0;

QString words(const char* text) { return QCoreApplication::translate("reading_dialog", text); }

/// A choice of words of the scene file; the first stands for what the scene says.
QComboBox* choice(const char* name, std::initializer_list<const char*> values, const QString& present,
                  QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(QString::fromLatin1(name));
  box->addItem(words(QT_TRANSLATE_NOOP("reading_dialog", "as in the scene")), QString());
  box->addItem(words(QT_TRANSLATE_NOOP("reading_dialog", "guessed from the file")), QStringLiteral("auto"));
  for (const char* value : values) box->addItem(QString::fromLatin1(value), QString::fromLatin1(value));
  // A project may name metres per unit.
  if (box->findData(present) < 0) box->addItem(present, present);
  box->setCurrentIndex(box->findData(present));
  return box;
}

}  // namespace

std::optional<ReadingOptions> askReading(const ReadingOptions& present, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("recording_options"));
  dialog.setWindowTitle(words(QT_TRANSLATE_NOOP("reading_dialog", "Recording options")));
  QComboBox* units = choice("units", {"m", "cm", "mm", "inches", "cmu"}, present.units, &dialog);
  QComboBox* up = choice("up", {"x", "y", "z", "-x", "-y", "-z"}, present.up, &dialog);
  auto* speed = new NumberBox(&dialog);
  speed->setObjectName(QStringLiteral("speed"));
  speed->setRange(kSlowest, kFastest);
  speed->setDecimals(2);
  speed->setSingleStep(0.1);
  speed->setSuffix(QStringLiteral(" ×"));
  speed->setValue(present.speed);
  speed->setToolTip(words(QT_TRANSLATE_NOOP("reading_dialog", "2: people move twice as fast as recorded")));
  auto* cut = new QCheckBox(
      words(QT_TRANSLATE_NOOP("reading_dialog", "Cut the scene's robots and objects out of depth images")),
      &dialog);
  cut->setChecked(present.cut_things);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);

  auto* form = new QFormLayout(&dialog);
  form->addRow(words(QT_TRANSLATE_NOOP("reading_dialog", "&Units of the file")), units);
  form->addRow(words(QT_TRANSLATE_NOOP("reading_dialog", "Axis that points &up")), up);
  form->addRow(words(QT_TRANSLATE_NOOP("reading_dialog", "&Speed of people")), speed);
  form->addRow(cut);
  form->addRow(buttons);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  ReadingOptions reading = present;
  reading.units = units->currentData().toString();
  reading.up = up->currentData().toString();
  reading.cut_things = cut->isChecked();
  // A speed that the box rounds stays as it was.
  if (speed->value() != speed->valueFromText(speed->textFromValue(present.speed)))
    reading.speed = speed->value();
  return reading;
}

}  // namespace abstand::ui
