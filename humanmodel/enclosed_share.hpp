// Share of people whose parts are enclosed by those of a model.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Shares of people, 0 to 1.
struct EnclosedShare {
  double at_stature{0.0};    ///< of people as tall as the model
  double all_statures{0.0};  ///< of all people
};

/// For each part, in the order of BodyPart: share of people whose part is inside of the model's, with equal
/// centre and axes, judged by the largest cross-section.
///
/// G is the largest girth of a section with the proportions of the mean person of that sex whose breadth and
/// depth are within the part's. Girth / stature is normally distributed among people of a stature H, with
/// mean m(H) = m + girthShift and standard deviation s = girthDeviation (girth_spread.hpp; ANSUR II 2012).
/// With the normal distribution function F
///
///     at_stature = F((G / h - m(h)) / s),    all_statures = integral of F((G / H - m(H)) / s) f(H) dH,
///
/// h is the model's stature and f the normal density of statures. For the torso, chest, waist and buttock are
/// judged separately and the smallest share is used; the share that fits at all three is smaller, but the
/// source has no correlations. Lengths, the neck and the joints are not judged.
///
/// `sex`: people to count; without: a population of half women and half men, weighted at the model's stature
/// by shareOfSexAt. Independent of body mass: people of every mass are counted.
std::array<EnclosedShare, kBodyPartCount> enclosedShare(const HumanModel& model, std::optional<Sex> sex);

}  // namespace abstand::humanmodel
