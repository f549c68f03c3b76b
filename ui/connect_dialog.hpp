// Asks which server shall be shown.
#pragma once

#include <QString>
#include <optional>

class QWidget;

namespace abstand::ui {

struct ServerChoice {
  QString address;  ///< "127.0.0.1:4780"
  QString scene;    ///< file; empty: the one that the server states
};

/// None where the user gives up. GUI thread only.
std::optional<ServerChoice> askServer(const ServerChoice& present, QWidget* parent);

}  // namespace abstand::ui
