// Mass, centre of mass and inertia of the parts.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Sets mass, com and inertia of every part; the masses sum exactly to the body mass. `parts` need their
/// joints and lengths. Source: de Leva 1996, Adjustments to Zatsiorsky-Seluyanov's segment inertia
/// parameters, J. Biomech. 29, table 4. Its segment end points correspond to our joints: vertex and cervicale
/// are head top and neck, cervicale and mid hip are neck and pelvis, joint centres are joint centres; the
/// foot extends from heel to toe tip, the hand from the wrist to the third knuckle. Centres of mass are on
/// the line between the end points. Radii of gyration: sagittal about x, transverse about y, longitudinal
/// about z; the foot is horizontal (longitudinal about x, sagittal about z) and the palm of a hanging hand
/// faces inwards (transverse about x, sagittal about y).
void assignInertia(double mass, std::optional<Sex> sex, std::vector<HumanPart>& parts);

}  // namespace abstand::humanmodel
