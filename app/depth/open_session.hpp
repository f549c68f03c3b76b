// Opens a session with depth recordings in which the scene's robots are known.
#pragma once

#include "app/session/session.hpp"

namespace abstand::depth {

/// A session with support of `cut_things`: images of the robots and objects are rendered by a second session
/// of the scene without people, created for the first depth recording that requests it and deleted when all
/// are read. Throws ParseError, UsageError.
std::unique_ptr<session::Session> openSession(scene_file::SceneDescription scene,
                                              session::SessionOptions options);

}  // namespace abstand::depth
