// Variation of girths among people of one stature.
#pragma once

#include "humanmodel/body_sections.hpp"

namespace abstand::humanmodel {

/// Standard deviation of a girth among people of one stature, as a share of stature (ANSUR II 2012). If the
/// body mass is known: sqrt(1 - r^2) times that, with r the correlation of the share with the body mass
/// index, known for chest, waist, thigh and biceps; other girths are not reduced. The correlation of a share
/// with stature is not in the source and not subtracted: this overestimates the deviation, but underestimates
/// girths that grow less than stature (the head) for short people.
double girthDeviation(GirthPlace place, Sex sex, bool mass_known);

/// The sections of meanSections, each scaled so that `percentile` per cent (1 to 99) of the people of that
/// stature (and mass) have one that fits inside. With sex: scaled by 1 + z s / m, with the normal score z,
/// deviation s and mean m of the girth, so the girth becomes m + z s. Without: a population of women and men
/// weighted by shareOfSexAt. Breadths and depths, whose deviations are unknown, keep their ratio to the
/// girth.
BodySections sectionsOfPercentile(double percentile, double height, std::optional<double> mass,
                                  std::optional<Sex> sex);

}  // namespace abstand::humanmodel
