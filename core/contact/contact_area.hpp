// How much of a body's surface takes part in a contact: from its exact triangles, without points placed by
// hand.
#pragma once

#include "core/contact/contact_surface.hpp"

namespace abstand::contact {

/// Where a body presses on a person. In the body's frame.
struct ContactPlace {
  Vector3d p_B{Vector3d::Zero()};  ///< m, the contact point on the body's surface; its nearest point counts
  /// Unit vector of approach, outwards, from the body to the person. As the normal of a pair of witness
  /// points, it makes the contact point the foremost one of its neighbourhood.
  Vector3d n_B{Vector3d::UnitZ()};
  double indentation{0.0};  ///< m, by which the person gives way: PredictedContact::indentation
  /// m, the person's smallest radius of curvature there. Infinite: flat and wide, as a measuring device is;
  /// then a flat face counts as a whole, be it larger than the part of the body.
  double body_radius{kInfinity};
};

/// The patch of surface that lies within the indentation x of the foremost point along the approach and is
/// connected to it there. The person is taken as a foundation of springs (Winkler): only how deep each point
/// lies counts, depth = x - (distance behind the foremost point) - rho^2 / (2 body_radius), rho being the
/// distance from the contact point across the approach. Projected onto the plane normal to the approach; what
/// is hidden behind other parts of the patch counts once.
///
/// Both `area` and `volume` are lower bounds where `certified`, so that pressures are only ever
/// overestimated: meshes and cuboids are cut exactly; for the other shapes x is shortened by the sagitta of
/// their triangles, which lie within the shape. With a finite body_radius, triangles are divided until they
/// follow the curve within some 2 % of x, on the same side.
struct ContactArea {
  double area{0.0};         ///< m^2, projected
  double volume{0.0};       ///< m^3, displaced: the sum of depth times area
  double indentation{0.0};  ///< m, x
  Vector3d foremost_B{Vector3d::Zero()};
  double offset{0.0};        ///< m, of the foremost point before the contact point; large: doubt the normal
  std::size_t triangles{0};  ///< pieces in the patch
  bool certified{false};     ///< the mesh is closed and its triangles point outwards

  /// Pa, F / A for a force F (N). 0 without a force; infinite where nothing is certain of the area.
  double meanPressure(double force) const;
  /// Pa, F x / V: the pressure at the deepest point of the foundation, proportional to depth, that carries F.
  double peakPressure(double force) const;
};

/// Takes time and memory in proportion to the mesh. An indentation that is not positive, and places that are
/// not finite, give an empty patch. Pure; any thread. Throws nothing but for lack of memory.
ContactArea contactArea(const ContactSurface& surface, const ContactPlace& place);

}  // namespace abstand::contact
