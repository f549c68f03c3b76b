// Variation of girths among people of one stature.
#pragma once

#include "humanmodel/body_sections.hpp"

namespace abstand::humanmodel {

// Among people of one stature and sex, girth / stature R is normally distributed (ANSUR II 2012):
//
//     mean m + rho s z,    variance s^2 (1 - rho^2),    or s^2 (1 - r^2 - rho^2) at a known body mass,
//
// m and s are its mean and standard deviation over all people of the sex (m: at the known body mass index),
// z the score of the stature (girthStatureScore), rho the correlation of R with stature (girthCorrelation),
// r that with the body mass index. Both parts of the variance are subtracted because the body mass index is
// taken as independent of stature.

/// Correlation rho of girth / stature with stature, the mean of men and women.
///
/// From coefficients of variation, cv = standard deviation / mean, of the ratio R, of stature h and of the
/// girth G = R h (its 95th percentile of men, 5th of women, minus m times the mean stature, over 1.645):
///
///     r_G = (cv_G^2 + cv_h^2 - cv_R^2) / (2 cv_G cv_h),    rho = (r_G cv_G - cv_h) / cv_R.
///
/// This is the first order of log G = log R + log h. Girths that depend on mass are skewed: the upper tail
/// (men) gives too small a |rho|, the lower one (women) too large a |rho|; the mean of both balances that.
double girthCorrelation(GirthPlace place);

/// (h - mean) / standard deviation of the statures of a sex, h in m; limited to -3 to 3, because the source
/// has hardly anyone farther out.
double girthStatureScore(double height, Sex sex);

/// rho s z: mean girth / stature of people of a stature (m), minus the mean over all people of the sex.
double girthShift(GirthPlace place, double height, Sex sex);

/// s sqrt(1 - rho^2), the standard deviation of girth / stature among people of one stature. If the body mass
/// is known: s sqrt(1 - r^2 - rho^2), r being known for chest, waist, thigh and biceps, and 0 elsewhere.
double girthDeviation(GirthPlace place, Sex sex, bool mass_known);

/// The sections of meanSections, each scaled so that `percentile` per cent (1 to 99) of the people of that
/// stature (and mass) have one that fits inside. With sex: the girth becomes h (mean + u deviation), with the
/// normal score u of the percentile, and mean and deviation as above. Without: a population of women and men
/// weighted by shareOfSexAt. Breadths and depths, whose deviations are unknown, keep their ratio to the
/// girth.
BodySections sectionsOfPercentile(double percentile, double height, std::optional<double> mass,
                                  std::optional<Sex> sex);

}  // namespace abstand::humanmodel
