// Notes about an opened scene, for the window.
#pragma once

#include <vector>

#include "app/session/session.hpp"
#include "core/scene/scene_note.hpp"

namespace abstand::run {

/// Reservations known before a frame is run, joint limits violated by the plan, and other remarks; those that
/// fail `check` come first.
std::vector<scene::SceneNote> notesOf(const session::Session& session);

}  // namespace abstand::run
