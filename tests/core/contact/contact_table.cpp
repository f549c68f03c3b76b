#include "tests/core/contact/contact_table.hpp"

#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "humanmodel/body_part.hpp"
#include "tests/support/paths.hpp"

namespace abstand::contact {

const std::vector<std::string_view>& modelParts() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i)
      all.push_back(humanmodel::partName(static_cast<humanmodel::BodyPart>(i)));
    return all;
  }();
  return names;
}

const ContactLimits& shippedLimits() {
  static const ContactLimits limits =
      loadContactLimits(testing::projectFile("data/standards/iso_ts_15066_2016.yaml"), modelParts());
  return limits;
}

const RegionLimits& shipped(std::string_view region) {
  const RegionLimits* const found = shippedLimits().region(region);
  ABSTAND_CHECK(found != nullptr);
  return *found;
}

}  // namespace abstand::contact
