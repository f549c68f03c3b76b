// Opens a session whose depth recordings know the scene's robots.
#pragma once

#include "app/session/session.hpp"

namespace abstand::depth {

/// A session in which `cut_things` works: the images of the robots and objects are drawn by a second session
/// of the scene without its people, made when the first depth recording asks for it and gone when all are
/// read. Throws ParseError, UsageError.
std::unique_ptr<session::Session> openSession(scene_file::SceneDescription scene,
                                              session::SessionOptions options);

}  // namespace abstand::depth
