// A moment of a scene as a drawing, without a window.
#pragma once

#include <string>

#include "app/session/session.hpp"

namespace abstand::report {

/// Which bodies the drawing is about.
struct MomentBodies {
  std::string part, link;  ///< names of objects: "operator/hand_left", "left_arm/link7"
};

/// SVG with the outlines of all bodies from above and from the side (convex outlines: a body that is not
/// convex looks fuller than it is), people, robots and things in different colours, the two bodies and the
/// line of their nearest points drawn strongly. The session stands at the moment (Session::step). Colours
/// follow the page's style.
std::string momentPicture(const session::Session& session, const MomentBodies& bodies);

}  // namespace abstand::report
