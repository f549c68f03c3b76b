// Drawing of a scene at one time, without a window.
#pragma once

#include <string>

#include "app/session/session.hpp"

namespace abstand::report {

/// The two bodies that the drawing highlights.
struct MomentBodies {
  std::string part, link;  ///< names of objects: "operator/hand_left", "left_arm/link7"
};

/// SVG with the outlines of all bodies from above and from the side (convex outlines, so non-convex bodies
/// look larger), people, robots and objects in different colours, the two bodies and the line of their
/// nearest points highlighted. The session is at that time (Session::step). Colours follow the page's style.
std::string momentPicture(const session::Session& session, const MomentBodies& bodies);

}  // namespace abstand::report
