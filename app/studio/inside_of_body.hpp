// What the engine computes with, for the window.
#pragma once

#include "core/structure/haptic_structure.hpp"
#include "ui/model/body_inside.hpp"

namespace abstand::studio {

/// The slice goes through the middle of the body's bounding sphere and reaches a little beyond the body.
ui::BodyInside insideOf(const structure::HapticStructure& structure);

}  // namespace abstand::studio
