// Postures that several scenes share.
#pragma once

#include "tests/tracking/tracker/posed_person.hpp"

namespace abstand::testing {

inline Posture standing(double t) { return {.t = t}; }
inline Posture seated(double t) {
  return {.t = t,
          .hips = {0.0, 0.0, 0.50},
          .back = 0.1,
          .reach = 0.30,
          .aside = 0.16,
          .low = 0.62,
          .foot = 0.44,
          .apart = 0.12};
}
inline Posture kneeling(double t) {
  return {.t = t,
          .hips = {0.0, 0.0, 0.48},
          .reach = 0.10,
          .low = 0.46,
          .foot = -0.38,
          .ankle = 0.09,
          .toes = -2.8};
}
inline Posture bent(double t) {
  return {.t = t,
          .hips = {-0.20, 0.0, 0.70},
          .loins = 1.0,
          .back = 1.7,
          .head = 1.9,
          .reach = 0.35,
          .aside = 0.15,
          .low = 0.20};
}
inline Posture handsAhead(double t) { return {.t = t, .reach = 0.40, .aside = 0.20, .low = 1.05}; }
inline Posture armsAside(double t) { return {.t = t, .reach = 0.05, .aside = 0.75, .low = 1.45}; }
inline Posture armsUp(double t) { return {.t = t, .reach = 0.15, .aside = 0.30, .low = 1.95}; }
inline Posture squatting(double t) {
  return {.t = t,
          .hips = {-0.15, 0.0, 0.35},
          .loins = 0.6,
          .back = 0.6,
          .reach = 0.30,
          .aside = 0.25,
          .low = 0.45,
          .foot = 0.10,
          .apart = 0.14};
}

}  // namespace abstand::testing
