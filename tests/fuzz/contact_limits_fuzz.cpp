// Fuzzes the reader of contact limits: only ParseError may come out, and no table that gives the head a limit
// or leaves out a part.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.hpp"
#include "core/contact/contact_limits_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  // Few, so that a small table covers all.
  static constexpr std::string_view kParts[] = {"head", "hand_left"};
  try {
    const auto limits =
        contact::parseContactLimits(std::string(reinterpret_cast<const char*>(data), size), "fuzz", kParts);
    for (const std::string_view part : kParts) {
      const auto regions = limits.regionsOf(std::string(part));
      ABSTAND_CHECK(!regions.empty());
      for (const auto* region : regions) {
        ABSTAND_CHECK(part != contact::kExcludedPart || region->excluded());
        ABSTAND_CHECK(std::isfinite(region->force.value) && region->force.value > 0.0);
        ABSTAND_CHECK(std::isfinite(region->spring.value) && region->spring.value > 0.0);
        ABSTAND_CHECK(region->excluded() || region->transient.value >= 1.0);
      }
    }
  } catch (const ParseError&) {
  }
  return 0;
}
