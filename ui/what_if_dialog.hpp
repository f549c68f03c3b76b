// Asks what the outcome of margins is judged with.
#pragma once

#include <optional>

#include "ui/model/what_if_settings.hpp"

class QWidget;

namespace abstand::ui {

/// Nothing where the user cancels.
std::optional<WhatIfSettings> askWhatIf(const WhatIfSettings& present, QWidget* parent);

}  // namespace abstand::ui
