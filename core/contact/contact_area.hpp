// Contact patch of a body: area and displaced volume, from its exact triangles.
#pragma once

#include "core/contact/contact_surface.hpp"

namespace abstand::contact {

/// Contact location of a body with a person. In the body's frame.
struct ContactPlace {
  Vector3d p_B{Vector3d::Zero()};  ///< m, contact point; projected onto the body's surface
  /// Unit vector of approach, outwards, from the body to the person. If it is the normal of a pair of witness
  /// points, the contact point is the foremost one of its neighbourhood.
  Vector3d n_B{Vector3d::UnitZ()};
  double indentation{0.0};  ///< m, indentation of the person: PredictedContact::indentation
  /// m, the person's smallest radius of curvature there. Infinite: flat, like a measuring device; then a flat
  /// face counts entirely, even if it is larger than the body part.
  double body_radius{kInfinity};
};

/// The patch of surface within the indentation x of the foremost point along the approach, and connected to
/// it. The person is modelled as an elastic foundation of independent springs (Winkler): only the depth of
/// each point counts, depth = x - (distance behind the foremost point) - rho^2 / (2 body_radius), with rho
/// the distance from the contact point perpendicular to the approach. Areas are projected onto the plane
/// normal to the approach; overlapping parts of the patch count once.
///
/// If `certified`, `area` and `volume` are lower bounds, so that pressures are upper bounds: meshes and
/// cuboids are cut exactly; for the other shapes x is reduced by the sagitta of their inscribed triangles.
/// With a finite body_radius, triangles are subdivided until they follow the curve within about 2 % of x, on
/// the safe side.
struct ContactArea {
  double area{0.0};         ///< m^2, projected
  double volume{0.0};       ///< m^3, displaced: integral of depth over area
  double indentation{0.0};  ///< m, x
  Vector3d foremost_B{Vector3d::Zero()};
  double offset{0.0};        ///< m, of the foremost point ahead of the contact point; if large, the normal is
                             ///< doubtful
  std::size_t triangles{0};  ///< polygons in the patch
  bool certified{false};     ///< the mesh is closed and its triangles face outwards

  /// Mean pressure (Pa) F / A for a force F (N). 0 without force; infinite without certified area.
  double meanPressure(double force) const;
  /// Peak pressure (Pa) F x / V: pressure at the deepest point of the foundation, proportional to depth, that
  /// carries F.
  double peakPressure(double force) const;
};

/// Contact patch at `place`. Time and memory are proportional to the mesh. Empty for an indentation that is
/// not positive and for values that are not finite. Pure; any thread. Throws only if memory runs out.
ContactArea contactArea(const ContactSurface& surface, const ContactPlace& place);

}  // namespace abstand::contact
