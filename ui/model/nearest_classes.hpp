// The nearest pairs of people and robots, people first.
#pragma once

#include <QString>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_class.hpp"
#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// The pair of one class with the smallest certified clearance (distance − bound − pose uncertainty), and how
/// far its bodies are apart. What is known badly comes before what is known to be farther away.
struct NearestOfClass {
  PairClass of;
  int pair;         ///< index into SceneOutline::pairs
  double distance;  ///< m
};

/// Person – robot, person – thing, robot – robot, robot – thing, in this order; a class without a pair whose
/// distance is known is left out. Two people and two things are in no class.
std::vector<NearestOfClass> nearestOfClasses(const view::SceneOutline& outline,
                                             const view::SceneSnapshot& snapshot);

/// m, certified: of the pairs of a person and a robot, -infinity where one is not known, NaN without one.
double clearancePersonRobot(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);

/// "Person – robot: operator/hand_left – arm/link7, 12.3 mm ± 8 mm, ⚠ inside margin; person – thing 40.1 mm,
/// clear";
/// the nearest of all where no class has one; empty without pairs.
QString nearestText(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
/// The heaviest level of the pairs that nearestText() names.
PairLevel nearestLevel(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);
/// A line for each class, with the names of the bodies.
QString nearestLines(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot);

}  // namespace abstand::ui
