// Commands around a session that shows a running server, or a recording of one.
#pragma once

#include <QObject>
#include <vector>

#include "ui/connect_dialog.hpp"
#include "ui/panel_set.hpp"

class QAction;

namespace abstand::ui {

class Actions;
class SessionPort;

/// Asks for servers and files, says how the connection is, and takes away what cannot be edited while another
/// program decides. GUI thread only.
class LiveCommands : public QObject {
  Q_OBJECT

 public:
  /// All outlive it; dialogs belong to `window`.
  LiveCommands(const Actions& actions, const PanelSet& panels, QWidget* window);

  /// After all others have opened it; null: none.
  void open(SessionPort* session);
  /// Says how the connection is now.
  void refresh();

 Q_SIGNALS:
  void connectWanted(const QString& address, const QString& scene);
  void disconnectWanted();
  void saveWanted(const QString& file);
  void said(const QString& text);

 private:
  void ask();
  void askFile();
  void allowEdits(bool allowed, bool can_reset);

  const Actions& actions_;
  const PanelSet& panels_;
  QWidget* window_;
  SessionPort* session_{nullptr};
  ServerChoice choice_{QStringLiteral("127.0.0.1:4780"), {}};
  struct Taken {
    QAction* action;
    bool enabled;  ///< as it was
    QString tip;
  };
  std::vector<Taken> taken_;  ///< actions that cannot be used now
  bool was_stale_{false};
};

}  // namespace abstand::ui
