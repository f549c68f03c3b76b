// Clothing: how far it widens the parts of a body.
#pragma once

#include <map>
#include <span>
#include <string_view>

#include "core/geometry/shape.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::humanmodel {

/// m, thickness of what is worn, measured outwards from the skin; parts without an entry are bare.
using Clothing = std::map<BodyPart, double>;

inline constexpr double kMaxClothing = 0.2;  ///< m

/// Names of the presets: what is worn by usual people at work. The thicknesses are assumptions of this
/// project (docs/human.md); none is a measured value.
std::span<const std::string_view> clothingPresets();

/// Adds a preset; where a part has clothing, the thicker one counts. False: no preset has that name.
bool addClothingPreset(std::string_view name, Clothing& clothing);

/// Adds other clothing; where both cover a part, the thicker one counts.
void addClothing(const Clothing& more, Clothing& clothing);

/// A shape of the same kind that contains every point within `thickness` (m, not negative) of `shape`, an
/// ellipsoid or a cuboid. Of a cuboid each extent grows by twice the thickness. Of an ellipsoid with
/// semi-axes a_i the squared semi-axes become (1 + 1/p) a_i^2 + (1 + p) d^2 with p = |a| / (d sqrt 3): the
/// ellipsoid with the least sum of squared semi-axes that contains the sum of ellipsoid and ball [Kurzhanski
/// and Valyi 1997, Ellipsoidal Calculus]. Semi-axes a_i + d would not do: between the axes such an
/// ellipsoid is less than d thicker.
geometry::Shape widened(const geometry::Shape& shape, double thickness);

}  // namespace abstand::humanmodel
