// Files for other programs.
#include "ui/exchange_commands.hpp"

#include <QFileDialog>
#include <QInputDialog>

#include "ui/model/recent_folder.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/time_axis.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

ExchangeCommands::ExchangeCommands(const Actions& actions, const Selection& selection, const TimeAxis& axis,
                                   QWidget* window)
    : QObject(window), actions_{actions}, selection_{selection}, axis_{axis}, window_{window} {
  connect(actions[ActionId::kSaveRange], &QAction::triggered, this, &ExchangeCommands::saveRange);
  connect(actions[ActionId::kOpenPairs], &QAction::triggered, this, &ExchangeCommands::openPairs);
  connect(actions[ActionId::kSavePairs], &QAction::triggered, this, &ExchangeCommands::savePairs);
}

void ExchangeCommands::open(const view::SceneOutline* outline) {
  outline_ = outline;
  actions_[ActionId::kSaveRange]->setEnabled(outline && !outline->recordings.empty());
  for (const ActionId id : {ActionId::kOpenPairs, ActionId::kSavePairs})
    actions_[id]->setEnabled(outline && !outline->robots.empty());
}

/// The only one, that of the selection, or what the user says.
std::optional<QString> ExchangeCommands::chosen(const QStringList& names, const QString& question) {
  if (names.isEmpty()) return std::nullopt;
  if (names.size() == 1) return names.constFirst();
  for (const int object : selection_.objects()) {
    const QString group = QString::fromStdString(outline_->objects[static_cast<std::size_t>(object)].group);
    if (names.contains(group)) return group;
  }
  bool good = false;
  const QString name = QInputDialog::getItem(window_, tr("Choose"), question, names, 0, false, &good);
  return good ? std::optional(name) : std::nullopt;
}

QString ExchangeCommands::fileToSave(const QString& title, const QString& name, const QString& filter,
                                     const QString& suffix, const QString& object) {
  QFileDialog dialog(window_, title, recentFolder(), filter);
  dialog.setObjectName(object);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(name);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  rememberFolder(dialog.selectedFiles().constFirst());
  return dialog.selectedFiles().constFirst();
}

void ExchangeCommands::saveRange() {
  QStringList people;
  for (const view::RecordingCard& card : outline_->recordings) people << QString::fromStdString(card.person);
  const auto person = chosen(people, tr("Whose recording?"));
  if (!person) return;
  const QString file =
      fileToSave(tr("Save range as recording"), QStringLiteral("range.rec"), tr("Recordings (*.rec)"),
                 QStringLiteral("rec"), QStringLiteral("save_range"));
  if (!file.isEmpty()) Q_EMIT rangeWanted(*person, axis_.range().value_or(axis_.whole()), file);
}

QStringList ExchangeCommands::robots() const {
  QStringList names;
  for (const view::RobotCard& robot : outline_->robots) names << QString::fromStdString(robot.name);
  return names;
}

void ExchangeCommands::openPairs() {
  const auto robot = chosen(robots(), tr("Of which robot?"));
  if (!robot) return;
  QFileDialog dialog(window_, tr("Open pairs of %1").arg(*robot), recentFolder(), tr("SRDF (*.srdf)"));
  dialog.setObjectName(QStringLiteral("open_pairs"));
  dialog.setFileMode(QFileDialog::ExistingFile);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  Q_EMIT pairsWanted(*robot, dialog.selectedFiles().constFirst());
}

void ExchangeCommands::savePairs() {
  const auto robot = chosen(robots(), tr("Of which robot?"));
  if (!robot) return;
  const QString file = fileToSave(tr("Save pairs of %1").arg(*robot), *robot + QStringLiteral(".srdf"),
                                  tr("SRDF (*.srdf)"), QStringLiteral("srdf"), QStringLiteral("save_pairs"));
  if (!file.isEmpty()) Q_EMIT savePairsWanted(*robot, file);
}

}  // namespace abstand::ui
