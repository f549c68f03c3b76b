// The thesis's mechanism configuration file.
#pragma once

#include <filesystem>
#include <string>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Reads a `.mech` file [thesis 3.1.4, listings 3.1 and 5.1]. Throws ParseError with file, line and column.
///
/// Words are separated by spaces or tabs, one command for each line, in lower case; `#` starts a comment.
///
///     units ... end_units       at most once: `length mm|cm|m|inches` (default m), `angle degrees|radians`
///     mapping ... end_mapping   at most once: `dof ID FRAME [OFFSET SCALE]`, ids 0, 1, 2, ... in order
///     chain ... end_chain       any number: first an optional `reference FRAME` (0, the base, or a frame
///                               of an earlier chain), then `frame ID a alpha d theta`, each relative to
///                               the one before; the word `d` or `theta` in its place marks the variable
///     link ... end_link         any number: `id FRAME` and `center` with the 12 numbers of [R|t], row by
///                               row: centre of the link in its frame; R is a rotation within 1e-3
///
/// Optional extensions:
///
///     mapping: mimic DOF FRAME [OFFSET SCALE]   another frame that moves with an earlier dof
///     names ... end_names       `name FRAME NAME [JOINT]`: names of the frame and its joint
///     limits ... end_limits     `limit FRAME lower upper velocity effort` of the joint's value, in the
///                               units of the file (effort in N m or N); `none` for no limit
///     inertia ... end_inertia   `body FRAME mass x y z ixx iyy izz ixy ixz iyz`: kg, centre of mass in the
///                               frame, kg m^2 about the centre of mass in the frame's axes
///     geometry ... end_geometry `collision|visual FRAME KIND SIZES 12 numbers of [R|t]`; KIND and SIZES are
///                               `mesh FILE sx sy sz`, `sphere r`, `cuboid x y z`, `cylinder r l`,
///                               `capsule r l` or `ellipsoid a b c`; a mesh's scale is in metres per unit;
///                               FRAME 0 is the base
///
/// In names and files %20 means a blank, %23 means #, %25 means %.
///
/// The environments may be in any order, but a reference follows its frame. A frame's variable is offset +
/// scale * q with q in SI and the offset in the file's unit of that joint. If there is a mapping, it contains
/// every variable once; without one, the variables are numbered in file order. Lengths and angles are at most
/// 1e6 m or rad in absolute value.
mechanism::Mechanism loadMechanism(const std::filesystem::path& file);

/// The same from text; `name` is used as the file name in messages, and its stem becomes the mechanism's
/// name.
mechanism::Mechanism parseMechanism(const std::string& text, const std::string& name);

/// The same, with the geometry in the file.
Robot parseMech(const std::string& text, const std::string& name);

}  // namespace abstand::robot_file
