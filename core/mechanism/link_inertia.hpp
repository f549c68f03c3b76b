// Mass of links: from solids, put together, and judged.
#pragma once

#include <string>

#include "core/geometry/mass_properties.hpp"
#include "core/mechanism/mechanism.hpp"

namespace abstand::mechanism {

/// Of a solid of uniform density (kg/m^3) whose own frame S lies at X_FS in the link's frame F. This is how a
/// link whose file gives no mass gets one: massProperties() of its mesh, and a density (steel 7850, aluminium
/// 2700, many plastics 1000 to 1400; whole robot arms 1500 to 3000).
LinkInertia inertiaOfSolid(const geometry::MassProperties& solid, double density, const Transform& X_FS);

/// The same body, seen from frame A in which its frame stands at X_AF.
LinkInertia seenFrom(const Transform& X_AF, const LinkInertia& body);

/// Two bodies of one frame as one.
LinkInertia together(const LinkInertia& a, const LinkInertia& b);

/// What keeps this from being the mass of a body, as "found ..., expected ...", or empty: numbers that are
/// not finite, a mass below 0, an inertia that is not symmetric or has a negative principal moment. A mass of
/// 0 is fine (a frame without a body), and so is a point mass. Moments that break the triangle inequality,
/// which no body has but many files do, are let through: dynamics needs no more than what is asked here.
std::string inertiaFault(const LinkInertia& body);

}  // namespace abstand::mechanism
