#include "tests/core/contact/contact_table.hpp"

#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"
#include "tests/support/paths.hpp"

namespace abstand::contact {

const ContactLimits& shippedLimits() {
  static const ContactLimits limits = loadContactLimits(
      testing::projectFile("data/standards/iso_ts_15066_2016.yaml"), humanmodel::partNames());
  return limits;
}

const RegionLimits& shipped(std::string_view region) {
  const RegionLimits* const found = shippedLimits().region(region);
  ABSTAND_CHECK(found != nullptr);
  return *found;
}

}  // namespace abstand::contact
