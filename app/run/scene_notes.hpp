// What the window lists of a scene that it opened.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "core/scene/scene_note.hpp"

namespace abstand::run {

/// The reservations that are known before a frame is run, joint limits that the planned motion breaks, and
/// the remarks that are not among them; what fails `check` first.
std::vector<scene::SceneNote> notesOf(const session::Session& session);

}  // namespace abstand::run
