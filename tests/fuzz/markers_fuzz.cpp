// Fuzzes marker sets: what is read can be matched to labels and placed on a body.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "tracking/markers/marker_set.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  static const tracking::BodyRig rig = tracking::makeRig(humanmodel::makeHuman({}));
  static const std::vector<std::string> names{"LASI", "s:RASI", "L.Knee", "LWRA", "LWRB", ""};
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const tracking::MarkerSet set = tracking::parseMarkerSet(text, "fuzz");
    for (const auto& found : tracking::matchMarkers(set, rig, names).markers) {
      ABSTAND_CHECK(found.p_S.allFinite() && found.spread > 0.0);
      for (const int i : found.points) ABSTAND_CHECK(i >= 0 && i < static_cast<int>(names.size()));
    }
  } catch (const ParseError&) {
  }
  return 0;
}
