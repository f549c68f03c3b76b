// All checks of the engine, by name.
#include "core/verify/suite.hpp"

#include "core/verify/certified_bound.hpp"
#include "core/verify/closed_forms.hpp"
#include "core/verify/continuity.hpp"
#include "core/verify/convergence.hpp"
#include "core/verify/haptic_benchmark.hpp"
#include "core/verify/moving_bound.hpp"
#include "core/verify/same_bits.hpp"
#include "core/verify/third_law.hpp"

namespace abstand::verify {

const std::vector<CheckFamily>& checkFamilies() {
  static const std::vector<CheckFamily> families{
      {"certified bound", checkCertifiedBound},
      {"moving bodies", checkMovingBound},
      {"closed forms", checkClosedForms},
      {"third law", checkThirdLaw},
      {"same bits", checkSameBits},
      {"continuity", checkContinuity},
      {"convergence", checkConvergence},
      {"haptic benchmark", checkHapticBenchmark},
  };
  return families;
}

}  // namespace abstand::verify
