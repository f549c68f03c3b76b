#include "ui/panels/path_field.hpp"

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "ui/model/recent_folder.hpp"

namespace abstand::ui {

namespace {

constexpr QLatin1Char kBetweenPaths(';');

}  // namespace

PathField::PathField(Kind kind, const QString& name, const QString& filter, QWidget* parent)
    : QWidget(parent), kind_{kind}, filter_{filter}, field_{new QLineEdit(this)} {
  setObjectName(name);
  // The letter of a label goes to what takes the keyboard.
  setFocusPolicy(Qt::StrongFocus);
  setFocusProxy(field_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(field_, 1);
  const auto button = [&](const QString& text, bool folder) {
    auto* choice = new QPushButton(text, this);
    choice->setAutoDefault(false);
    row->addWidget(choice);
    connect(choice, &QPushButton::clicked, this, [this, folder] { choose(folder); });
  };
  button(kind == Kind::kFiles ? tr("Files…") : tr("File…"), false);
  if (kind == Kind::kRecording) button(tr("Folder…"), true);
  if (kind == Kind::kFiles) field_->setToolTip(tr("Several paths, with semicolons between them"));
  connect(field_, &QLineEdit::textChanged, this, &PathField::changed);
}

QString PathField::path() const { return QDir::fromNativeSeparators(field_->text().trimmed()); }

QStringList PathField::paths() const {
  QStringList paths;
  for (const QString& each : field_->text().split(kBetweenPaths, Qt::SkipEmptyParts))
    if (!each.trimmed().isEmpty()) paths << QDir::fromNativeSeparators(each.trimmed());
  return paths;
}

void PathField::choose(bool folder) {
  QFileDialog dialog(window(), folder ? tr("Choose a folder") : tr("Choose a file"), recentFolder(), filter_);
  dialog.setObjectName(objectName() + (folder ? QStringLiteral("_folder") : QStringLiteral("_file")));
  dialog.setFileMode(folder                  ? QFileDialog::Directory
                     : kind_ == Kind::kFiles ? QFileDialog::ExistingFiles
                                             : QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  QStringList native;
  for (const QString& file : dialog.selectedFiles()) native << QDir::toNativeSeparators(file);
  field_->setText(native.join(kBetweenPaths));
}

}  // namespace abstand::ui
