// How much girths differ among people of one stature.
#pragma once

#include "humanmodel/body_sections.hpp"

namespace abstand::humanmodel {

/// Standard deviation of a girth among people of one stature, as a share of stature (ANSUR II 2012). Given
/// the body mass as well: sqrt(1 - r^2) times that, r the correlation of the share with the body mass index,
/// which is known of chest, waist, thigh and biceps; the other girths keep the whole. The correlation of a
/// share with stature is not in the source at hand: none is taken off, which makes the spread rather too
/// large, and a girth that grows less than stature (the head) too small for short people.
double girthDeviation(GirthPlace place, Sex sex, bool mass_known);

/// The sections of meanSections, each scaled until `percentile` per cent (1 to 99) of the people of that
/// stature (and mass) have one that fits inside. With sex: by 1 + z s / m, with the normal score z, and
/// deviation s and mean m of the girth, so a girth becomes m + z s. Without: the people are women and men as
/// shareOfSexAt says. Breadths and depths, of which no deviation is at hand, keep their ratio to the girth.
BodySections sectionsOfPercentile(double percentile, double height, std::optional<double> mass,
                                  std::optional<Sex> sex);

}  // namespace abstand::humanmodel
