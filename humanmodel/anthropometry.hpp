// Measured people: ANSUR II means by stature, sex and body mass.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Body mass index of the mean person of ANSUR II, kg/m^2; without sex the mean of both.
double meanBodyMassIndex(std::optional<Sex> sex);

/// Measures of one person, metres. Girths, breadths and depths at the body's own thickest place.
struct BodyMeasures {
  double chest_girth, waist_girth, buttock_girth;
  double chest_breadth, waist_breadth, hip_breadth;
  double chest_depth, waist_depth, buttock_depth;
  double head_girth, head_breadth, head_depth, neck_girth;
  double biceps_girth, forearm_girth, hand_girth, hand_breadth;
  double thigh_girth, calf_girth;
  double foot_length, foot_breadth, ball_girth;
  double cervicale_height, acromial_height, crotch_height;
  double acromion_trochanter, trochanter_epicondyle, epicondyle_malleolus;
  double acromion_radiale, radiale_stylion, hand_length;
  double biacromial_breadth;
};

/// Means of ANSUR II (Gordon et al. 2014, US Army, fit adults: 4,082 men, 1,986 women) as shares of stature.
/// Chest, waist, thigh and biceps girths follow lines in the body mass index fitted to the same data; the
/// rest of the body follows as the .cpp says. `height` m, `mass` kg, both in range.
BodyMeasures measuresOf(double height, double mass, std::optional<Sex> sex);

}  // namespace abstand::humanmodel
