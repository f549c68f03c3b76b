// Mass properties of links: from solids, combined, and validated.
#pragma once

#include <string>

#include "core/geometry/mass_properties.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// Mass properties of a solid of uniform density (kg/m^3) with frame S at X_FS in the link's frame F. For
/// links without mass in their file: massProperties() of the mesh and a density (steel 7850, aluminium 2700,
/// many plastics 1000 to 1400; whole robot arms 1500 to 3000).
LinkInertia inertiaOfSolid(const geometry::MassProperties& solid, double density, const Transform& X_FS);

/// The same body in frame A, in which its frame is at X_AF.
LinkInertia seenFrom(const Transform& X_AF, const LinkInertia& body);

/// Sum of two bodies in the same frame.
LinkInertia together(const LinkInertia& a, const LinkInertia& b);

/// Why this cannot be the mass of a body, as "found ..., expected ...", or empty: values that are not finite,
/// a negative mass, an inertia that is not symmetric or has a negative principal moment. Accepted: mass 0 (a
/// frame without a body), point masses, and moments that violate the triangle inequality, which no body has
/// but many files do; dynamics needs only what is checked here.
std::string inertiaFault(const LinkInertia& body);

}  // namespace abstand::mechanism
