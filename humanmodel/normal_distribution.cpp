#include "humanmodel/normal_distribution.hpp"

#include <cmath>
#include <numbers>

namespace abstand::humanmodel {

double normalShare(double score) { return 0.5 * std::erfc(-score / std::numbers::sqrt2); }

double normalScore(double share) {
  // Bisection to the last bit: called a few times for each person, so speed does not matter.
  double low = -40.0, high = 40.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) return middle;
    (normalShare(middle) < share ? low : high) = middle;
  }
}

}  // namespace abstand::humanmodel
