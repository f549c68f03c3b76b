// How many people have parts that fit into those of a model.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Shares of people, 0 to 1.
struct EnclosedShare {
  double at_stature{0.0};    ///< of people as tall as the model
  double all_statures{0.0};  ///< of all people
};

/// Of each part, in the order of BodyPart: the share of people whose part fits into the model's, both of the
/// same middle and axes, compared by their largest cross-section.
///
/// Formula: G is the largest girth of a section in the proportions of the mean person of that sex whose
/// breadth and depth are within the part's. Girth / stature is normal with the mean m and the deviation s of
/// ANSUR II (2012), independent of stature. Then with the normal distribution function F
///
///     at_stature = F((G / h - m) / s),    all_statures = integral of F((G / H - m) / s) f(H) dH,
///
/// h the model's stature and f the normal density of statures. Of the torso, chest, waist and buttock are
/// taken one by one, and the smallest share counts: how these girths go together is not in the source at
/// hand, so the share that fits at all three is smaller. Lengths, the neck and the joints are not judged.
///
/// `sex`: whom to count; without: a population half women and half men, so among people of the model's
/// stature each sex as shareOfSexAt says. Body mass is not looked at: people of every mass are counted.
std::array<EnclosedShare, kBodyPartCount> enclosedShare(const HumanModel& model, std::optional<Sex> sex);

}  // namespace abstand::humanmodel
