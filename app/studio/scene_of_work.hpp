// The scene as the document of the window wants it.
#pragma once

#include "app/scene_file/scene_description.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Replaces what `options` sets.
void applyPerson(const ui::PersonOptions& options, humanmodel::HumanOptions& body);

/// Changes how recordings are read, where people and robots stand, how people are built, and which pairs are
/// checked. People and bodies of
/// the work that the scene does not have have no effect.
void applyWork(const ui::Work& work, scene_file::SceneDescription& scene);

/// Puts the objects of the room where the work has them. A running session is told so (LiveSession).
void placeThings(const ui::Work& work, scene_file::SceneDescription& scene);

/// Leaves out the pairs that the user does not check.
void leaveOutUnchecked(const ui::Work& work, scene_file::SceneDescription& scene);
/// There are such pairs.
bool hasUnchecked(const ui::Work& work);

/// applyWork() or placeThings() changes something.
bool changesScene(const ui::Work& work);

}  // namespace abstand::studio
