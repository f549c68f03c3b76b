// Statures and body masses of the ANSUR II population.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// m: stature of the percentile `percentile` (1 to 99), i.e. that many per cent of the people are shorter.
/// Percentiles of ANSUR II (2012, US Army, fit adults) at 1, 2.5, 5, 50, 95, 97.5 and 99 %; linear in the
/// normal score in between. Without sex: population of half women and half men.
double statureOfPercentile(double percentile, std::optional<Sex> sex);

/// kg: body mass of the percentile; see statureOfPercentile.
double massOfPercentile(double percentile, std::optional<Sex> sex);

/// m, mean and standard deviation of stature (ANSUR II).
struct StatureSpread {
  double mean, deviation;
};
StatureSpread statureSpread(Sex sex);

/// Share (0 to 1) of a sex among the people of a stature (m), in a population of half women and half men with
/// normally distributed statures: f_sex / (f_women + f_men).
double shareOfSexAt(double stature, Sex sex);

}  // namespace abstand::humanmodel
