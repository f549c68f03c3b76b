// View > Arrows: how long arrows are and which are drawn.
#pragma once

#include <optional>

#include "ui/document/view_options.hpp"

class QWidget;

namespace abstand::ui {

/// Nothing where the user cancels.
std::optional<ViewOptions> askArrows(const ViewOptions& present, QWidget* parent);

}  // namespace abstand::ui
