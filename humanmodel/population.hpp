// The people of ANSUR II: their statures and body masses.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// m: `percentile` per cent (1 to 99) of the people are shorter. Table of percentiles of ANSUR II (2012, US
/// Army, fit adults) at 1, 2.5, 5, 50, 95, 97.5 and 99 %; straight lines in the normal score between them.
/// Without sex: of a population half women and half men.
double statureOfPercentile(double percentile, std::optional<Sex> sex);

/// kg: `percentile` per cent of the people are lighter. As statureOfPercentile.
double massOfPercentile(double percentile, std::optional<Sex> sex);

/// m, mean and standard deviation (ANSUR II).
struct StatureSpread {
  double mean, deviation;
};
StatureSpread statureSpread(Sex sex);

/// Share (0 to 1) of a sex among the people of a stature (m), in a population half women and half men with
/// normally distributed statures: f_sex / (f_women + f_men).
double shareOfSexAt(double stature, Sex sex);

}  // namespace abstand::humanmodel
