// What the window lists of a scene that it opened.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "core/scene/scene_note.hpp"

namespace abstand {

/// The reservations that are known before a frame is run, joint limits that the planned motion breaks, and
/// the remarks that are not among them; what fails `check` first.
std::vector<SceneNote> notesOf(const Session& session);

}  // namespace abstand
