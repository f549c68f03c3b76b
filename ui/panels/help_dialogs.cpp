// The page of shortcuts and the about box.
#include "ui/panels/help_dialogs.hpp"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/style/actions.hpp"

namespace abstand::ui {

QString shortcutPage(const Actions& actions) {
  QString page;
  for (const auto group :
       {ActionGroup::kFile, ActionGroup::kEdit, ActionGroup::kPlayback, ActionGroup::kCamera,
        ActionGroup::kView, ActionGroup::kMargins, ActionGroup::kPanels, ActionGroup::kHelp}) {
    page += QStringLiteral("<h3>%1</h3><table cellpadding='3' width='100%'>")
                .arg(Actions::groupName(group).remove(QLatin1Char('&')));
    for (const auto& entry : actions.all()) {
      if (entry.group != group || !entry.action->isVisible()) continue;
      QStringList keys;
      for (const QKeySequence& key : entry.action->shortcuts())
        keys << key.toString(QKeySequence::NativeText);
      page += QStringLiteral("<tr><td width='130'><b>%1</b></td><td width='190'>%2</td><td>%3</td></tr>")
                  .arg(keys.join(QStringLiteral(", ")).toHtmlEscaped(),
                       entry.action->text().remove(QLatin1Char('&')).toHtmlEscaped(),
                       entry.action->statusTip().toHtmlEscaped());
    }
    page += QStringLiteral("</table>");
  }
  const std::pair<QString, QString> mouse[] = {
      {QApplication::translate("help", "Left button"),
       QApplication::translate("help", "Orbit; a click selects")},
      {QApplication::translate("help", "Right or middle button, or Shift and left button"),
       QApplication::translate("help", "Pan")},
      {QApplication::translate("help", "Ctrl and left button"),
       QApplication::translate("help", "Pull a link of a robot")},
      {QApplication::translate("help", "Left button on an arrow or the ring of a selected thing"),
       QApplication::translate("help", "Move or turn it")},
      {QApplication::translate("help", "Ctrl, Shift and left button"),
       QApplication::translate("help", "Poke a robot that reacts: 4 N per cm, at most 150 N")},
      {QApplication::translate("help", "Alt and left button"),
       QApplication::translate("help", "Scrub: the width of the view is what the timeline shows")},
      {QApplication::translate("help", "Wheel"), QApplication::translate("help", "Zoom")},
      {QApplication::translate("help", "Double click"),
       QApplication::translate("help", "Zoom to the selection")},
      {QApplication::translate("help", "Drop"),
       QApplication::translate("help", "Open a project, a scene, a robot or a recording")}};
  page += QStringLiteral("<h3>%1</h3><table cellpadding='3' width='100%'>")
              .arg(QApplication::translate("help", "Mouse in the 3D view"));
  for (const auto& [what, effect] : mouse)
    page += QStringLiteral("<tr><td width='320'><b>%1</b></td><td>%2</td></tr>")
                .arg(what.toHtmlEscaped(), effect.toHtmlEscaped());
  return page + QStringLiteral("</table>");
}

void showShortcuts(const Actions& actions, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QApplication::translate("help", "Shortcuts"));
  auto* layout = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser(dialog);
  text->setHtml(shortcutPage(actions));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  layout->addWidget(text);
  layout->addWidget(buttons);
  dialog->resize(680, 640);
  dialog->show();
}

void showAbout(QWidget* parent) {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, QApplication::translate("help", "About Abstand"),
      QApplication::translate(
          "help",
          "<h3>Abstand %1</h3><p>Distances and contact between people and robots: how close did they come, "
          "how hard "
          "would they have touched, and which safety margin would have been right.</p><p><b>This is an "
          "analysis tool, "
          "not a safety function.</b> Do not use it to stop a machine or to protect a person.</p>")
          .arg(QApplication::applicationVersion()),
      QMessageBox::Close, parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::RichText);
  box->open();
}

}  // namespace abstand::ui
