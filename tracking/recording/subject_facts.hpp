// What a file says of the recorded person.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace abstand::tracking {

/// 0 and empty: not stated.
struct SubjectFacts {
  std::string name;
  double height{0.0};                   ///< m, stature
  double mass{0.0};                     ///< kg
  std::map<std::string, double> sizes;  ///< m: "knee_width_left", "leg_length_right", ...
  bool empty() const { return name.empty() && height == 0.0 && mass == 0.0 && sizes.empty(); }
};

/// A person in a file, with remarks on how the statements were understood.
struct StatedSubject {
  std::string label_prefix;  ///< of the person's markers; empty: not stated
  SubjectFacts facts;
  std::vector<std::string> notes, warnings;
};

}  // namespace abstand::tracking
