// The thesis's mechanism configuration file.
#pragma once

#include <filesystem>
#include <string>

#include "core/robot_file/robot.hpp"

namespace abstand::robot_file {

/// Reads a `.mech` file [thesis 3.1.4, listings 3.1 and 5.1]. Throws ParseError with file, line and column.
///
/// Words stand between spaces or tabs, one command a line, in lowercase; `#` starts a comment anywhere.
///
///     units ... end_units       once or not at all: `length mm|cm|m|inches` (m), `angle degrees|radians`
///     mapping ... end_mapping   once or not at all: `dof ID FRAME [OFFSET SCALE]`, ids 0, 1, 2, ... in order
///     chain ... end_chain       any number: first, if wanted, `reference FRAME` (0, the base, or a frame of
///     a
///                               chain before), then `frame ID a alpha d theta`, each relative to the one
///                               before it; the word `d` or `theta` in its own place makes it the variable
///     link ... end_link         any number: `id FRAME` and `center` with the 12 numbers of [R|t], row by
///     row:
///                               the centre of the link in its frame; R is a rotation within 1e-3
///
/// Beyond the thesis, and all optional:
///
///     mapping: mimic DOF FRAME [OFFSET SCALE]   another frame that moves with a dof that stands before
///     names ... end_names       `name FRAME NAME [JOINT]`: what the frame and its joint are called
///     limits ... end_limits     `limit FRAME lower upper velocity effort` of the joint's value, in the units
///     of
///                               the file (effort in N m or N); the word none where there is none
///     inertia ... end_inertia   `body FRAME mass x y z ixx iyy izz ixy ixz iyz`: kg, centre of mass in the
///                               frame, kg m^2 about the centre of mass in the frame's axes
///     geometry ... end_geometry `collision|visual FRAME KIND SIZES 12 numbers of [R|t]`; KIND and SIZES are
///                               `mesh FILE sx sy sz`, `sphere r`, `cuboid x y z`, `cylinder r l`, `capsule r
///                               l` or `ellipsoid a b c`; a mesh's scale is in metres per unit; FRAME 0 is
///                               the base
///
/// In names and files %20 stands for a blank, %23 for #, %25 for %.
///
/// The environments may stand in any order, but a reference comes after its frame. A frame's variable is
/// offset + scale * q with q in SI and the offset in the file's unit of that joint. Where there is a mapping,
/// every variable stands in it once; where there is none, the variables are numbered in the order of the
/// file. Lengths and angles are at most 1e6 m or rad in size.
mechanism::Mechanism loadMechanism(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages, and its stem becomes the mechanism's name.
mechanism::Mechanism parseMechanism(const std::string& text, const std::string& name);

/// With the geometry that the file may have.
Robot parseMech(const std::string& text, const std::string& name);

}  // namespace abstand::robot_file
