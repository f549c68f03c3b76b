// Asks how a recording shall be understood.
#pragma once

#include <optional>

#include "ui/document/work.hpp"

class QWidget;

namespace abstand::ui {

/// None where the user gives up. GUI thread only.
std::optional<ReadingOptions> askReading(const ReadingOptions& present, QWidget* parent);

}  // namespace abstand::ui
