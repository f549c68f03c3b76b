#include "ui/connect_dialog.hpp"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "ui/model/recent_folder.hpp"
#include "ui/style/file_kinds.hpp"

namespace abstand::ui {

namespace {

constexpr int kFieldWidth = 320;

QString said(const char* text) { return QCoreApplication::translate("connect_dialog", text); }

}  // namespace

std::optional<ServerChoice> askServer(const ServerChoice& present, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setObjectName(QStringLiteral("connect"));
  dialog.setWindowTitle(said(QT_TRANSLATE_NOOP("connect_dialog", "Connect to a running serve")));
  auto* address = new QLineEdit(present.address, &dialog);
  address->setObjectName(QStringLiteral("address"));
  address->setMinimumWidth(kFieldWidth);
  address->setToolTip(
      said(QT_TRANSLATE_NOOP("connect_dialog", "Address and port of abstand serve, as it prints them")));
  auto* scene = new QLineEdit(present.scene, &dialog);
  scene->setObjectName(QStringLiteral("scene"));
  scene->setPlaceholderText(said(QT_TRANSLATE_NOOP("connect_dialog", "the file that the server states")));
  auto* browse = new QPushButton(said(QT_TRANSLATE_NOOP("connect_dialog", "Choose…")), &dialog);
  QObject::connect(browse, &QPushButton::clicked, &dialog, [&] {
    const QString file = QFileDialog::getOpenFileName(&dialog, browse->text(), recentFolder(), openFilter());
    if (!file.isEmpty()) scene->setText(file);
  });
  auto* row = new QHBoxLayout;
  row->addWidget(scene, 1);
  row->addWidget(browse);
  auto* note = new QLabel(
      said(QT_TRANSLATE_NOOP("connect_dialog",
                             "The window only looks on: nothing here changes what the server does.")),
      &dialog);
  note->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  buttons->button(QDialogButtonBox::Ok)->setText(said(QT_TRANSLATE_NOOP("connect_dialog", "Connect")));
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* form = new QFormLayout(&dialog);
  form->addRow(said(QT_TRANSLATE_NOOP("connect_dialog", "&Address")), address);
  form->addRow(said(QT_TRANSLATE_NOOP("connect_dialog", "&Scene")), row);
  form->addRow(note);
  form->addRow(buttons);
  address->selectAll();
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return ServerChoice{address->text().trimmed(), scene->text().trimmed()};
}

}  // namespace abstand::ui
