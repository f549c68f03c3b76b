// Offers what a program had that did not end well.
#pragma once

#include <optional>

#include "ui/document/left_overs.hpp"

class QWidget;

namespace abstand::ui {

/// Asks for each autosave whether its work shall be opened; the newest comes first, and one that is taken
/// ends the asking. None: what was not given up stays for the next start.
std::optional<LeftOver> offerRecovery(const QString& folder, QWidget* parent);

}  // namespace abstand::ui
