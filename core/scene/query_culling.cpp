#include "core/scene/query_culling.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::scene {

void QueryCulling::validate() const {
  if (!(rest >= 0.0 && rest <= 1.0))
    throw UsageError("rest " + formatDouble(rest) + ": expected a share from 0 to 1");
  if (!(horizon >= 0.0))
    throw UsageError("horizon " + formatDouble(horizon) + ": expected a distance in m, 0 or more");
  if (!(budget >= 0.0))
    throw UsageError("budget " + formatDouble(budget) + ": expected a time in s, 0 or more");
  if (!(far_tolerance >= 0.0 && far_tolerance <= query::kMaxFarTolerance))
    throw UsageError("tolerance " + formatDouble(far_tolerance) + ": expected a share from 0 to " +
                     formatDouble(query::kMaxFarTolerance));
}

}  // namespace abstand::scene
