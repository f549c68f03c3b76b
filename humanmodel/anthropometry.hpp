// Anthropometry: ANSUR II means by stature, sex and body mass.
#pragma once

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Body mass index (kg/m^2) of the mean person of ANSUR II; without sex the mean of both.
double meanBodyMassIndex(std::optional<Sex> sex);

/// Circumferences, m.
struct Girths {
  double head_girth, neck_girth, chest_girth, waist_girth, buttock_girth;
  double biceps_girth, forearm_girth, hand_girth;
  double thigh_girth, calf_girth, ball_girth;
};

/// Breadths (left to right) and depths (front to back), m.
struct Widths {
  double head_breadth, head_depth;
  double biacromial_breadth, chest_breadth, chest_depth, waist_breadth, waist_depth, hip_breadth,
      buttock_depth;
  double hand_breadth, foot_breadth;
};

/// Heights above the floor and distances between landmarks, m.
struct Lengths {
  double cervicale_height, acromial_height, crotch_height;
  double acromion_trochanter, trochanter_epicondyle, epicondyle_malleolus;
  double acromion_radiale, radiale_stylion, hand_length, foot_length;
};

/// Measures of one person, m. Girths, breadths and depths at the thickest place of each segment.
struct BodyMeasures : Girths, Widths, Lengths {};

/// Means of ANSUR II (Gordon et al. 2014, US Army, fit adults: 4,082 men, 1,986 women) as shares of stature.
/// Chest, waist, thigh and biceps girths are linear in the body mass index, fitted to the same data; all
/// others scale as described in the .cpp. `height` (stature, m) and `mass` (kg) are in range.
BodyMeasures measuresOf(double height, double mass, std::optional<Sex> sex);

}  // namespace abstand::humanmodel
