#include "ui/live_commands.hpp"

#include <QAction>
#include <QFileDialog>
#include <QWidget>

#include "ui/model/live_text.hpp"
#include "ui/model/recent_folder.hpp"
#include "ui/model/session_port.hpp"
#include "ui/panels/group_panel.hpp"
#include "ui/panels/inspector_panel.hpp"
#include "ui/panels/joint_editor.hpp"
#include "ui/panels/margin_tools.hpp"
#include "ui/panels/person_editor.hpp"
#include "ui/panels/recording_panel.hpp"
#include "ui/panels/robot_panel.hpp"
#include "ui/panels/status_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

using Id = ActionId;

/// What would change what the server computes, or needs a recording with people of its own.
constexpr Id kEditing[] = {Id::kOpenRecording,   Id::kImport,      Id::kRecordingOptions,
                           Id::kReload,          Id::kReport,      Id::kSaveRange,
                           Id::kOpenPairs,       Id::kVideo,       Id::kLinkLeft,
                           Id::kLinkRight,       Id::kLinkUp,      Id::kLinkDown,
                           Id::kLinkNearer,      Id::kLinkFarther, Id::kReact,
                           Id::kReactionTorques, Id::kResetStops,  Id::kLoop};

}  // namespace

LiveCommands::LiveCommands(const Actions& actions, const PanelSet& panels, QWidget* window)
    : QObject(window), actions_{actions}, panels_{panels}, window_{window} {
  connect(actions[Id::kConnect], &QAction::triggered, this, &LiveCommands::ask);
  connect(actions[Id::kDisconnect], &QAction::triggered, this, &LiveCommands::disconnectWanted);
  connect(actions[Id::kSaveMoments], &QAction::triggered, this, &LiveCommands::askFile);
  connect(actions[Id::kToLive], &QAction::triggered, this, [this] {
    if (session_) session_->toLive();
  });
  open(nullptr);
}

void LiveCommands::ask() {
  const auto choice = askServer(choice_, window_);
  if (!choice) return;
  choice_ = *choice;
  Q_EMIT connectWanted(choice->address, choice->scene);
}

void LiveCommands::askFile() {
  QFileDialog dialog(window_, tr("Save the recording"), recentFolder(), tr("Recorded moments (*.moments)"));
  dialog.setObjectName(QStringLiteral("save_moments"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("moments"));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  rememberFolder(dialog.selectedFiles().constFirst());
  Q_EMIT saveWanted(dialog.selectedFiles().constFirst());
}

void LiveCommands::open(SessionPort* session) {
  session_ = session;
  const auto live = session ? session->live() : std::nullopt;
  allowEdits(!live, !live || live->can_reset);
  const bool connected = live && live->state != LiveStatus::State::kFile;
  actions_[Id::kDisconnect]->setEnabled(connected);
  actions_[Id::kSaveMoments]->setEnabled(connected);
  actions_[Id::kToLive]->setEnabled(connected);
  was_stale_ = false;
  refresh();
}

void LiveCommands::refresh() {
  const auto live = session_ ? session_->live() : std::nullopt;
  panels_.status->showLive(live);
  if (!live) return;
  const bool stale = isStale(*live);
  if (std::exchange(was_stale_, stale) != stale) Q_EMIT said(liveText(*live));
}

void LiveCommands::allowEdits(bool allowed, bool can_reset) {
  for (const Taken& taken : taken_) {
    taken.action->setEnabled(taken.enabled);
    taken.action->setToolTip(taken.tip);
  }
  taken_.clear();
  for (QWidget* panel : {static_cast<QWidget*>(panels_.margin_tools), static_cast<QWidget*>(panels_.groups),
                         static_cast<QWidget*>(panels_.recordings)}) {
    panel->setEnabled(allowed);
    panel->setToolTip(allowed ? QString() : tr("The server decides this; here it is only shown."));
  }
  panels_.robots->allowReset(can_reset);
  panels_.inspector->joints()->setEnabled(allowed);
  panels_.inspector->person()->setEnabled(allowed);
  if (allowed) return;
  const auto take = [this](QAction* action) {
    taken_.push_back({action, action->isEnabled(), action->toolTip()});
    action->setEnabled(false);
    action->setToolTip(
        tr("%1\nNot here: what is shown comes from a server, which decides.").arg(action->toolTip()));
  };
  for (const Id id : kEditing)
    if (id != Id::kResetStops || !can_reset) take(actions_[id]);
  for (const auto& entry : actions_.all())
    if (entry.group == ActionGroup::kMargins) take(entry.action);
}

}  // namespace abstand::ui
