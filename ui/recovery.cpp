#include "ui/recovery.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

namespace abstand::ui {

namespace {

QString say(const char* words) { return QCoreApplication::translate("recovery", words); }

QString nameOf(const LeftOver& left) {
  const Work& work = left.content.project.work;
  for (const QString& path : {left.content.saved_as, work.scene, work.recording, work.added_files.value(0)})
    if (!path.isEmpty()) return QFileInfo(path).fileName();
  return {};
}

QString question(const LeftOver& left) {
  const QString when = QLocale().toString(left.written, QLocale::ShortFormat);
  if (!left.problem.isEmpty())
    return say(QT_TRANSLATE_NOOP("recovery",
                                 "The program did not end properly, and its work of %1 cannot be "
                                 "read:\n%2"))
        .arg(when, left.problem);
  return say(QT_TRANSLATE_NOOP(
                 "recovery", "The program did not end properly. Its work on %1 was kept at %2. Recover it?"))
      .arg(nameOf(left), when);
}

}  // namespace

std::optional<LeftOver> offerRecovery(const QString& folder, QWidget* parent) {
  for (LeftOver& left : leftOvers(folder)) {
    QMessageBox box(QMessageBox::Question, say(QT_TRANSLATE_NOOP("recovery", "Recover work")), question(left),
                    QMessageBox::NoButton, parent);
    box.setObjectName(QStringLiteral("recovery"));
    box.setTextFormat(Qt::PlainText);
    QPushButton* recover = nullptr;
    if (left.problem.isEmpty())
      recover = box.addButton(say(QT_TRANSLATE_NOOP("recovery", "&Recover")), QMessageBox::AcceptRole);
    QPushButton* discard =
        box.addButton(say(QT_TRANSLATE_NOOP("recovery", "&Delete")), QMessageBox::DestructiveRole);
    box.addButton(say(QT_TRANSLATE_NOOP("recovery", "&Later")), QMessageBox::RejectRole);
    box.exec();
    if (box.clickedButton() == discard) left.remove();
    if (recover && box.clickedButton() == recover) return std::move(left);
  }
  return std::nullopt;
}

}  // namespace abstand::ui
