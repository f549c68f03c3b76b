#include "app/tune/separation_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace abstand::tune {

SeparationRow separationRow(const std::vector<TunedRecording>& recordings, const std::string& name) {
  SeparationRow row;
  row.part = name;
  for (const TunedRecording& r : recordings)
    for (const PartClearance& part : r.pass.parts) {
      if (part.part != name) continue;
      row.broken += part.separation.broken;
      const auto& worst = part.separation.worst;
      if (worst && (!row.worst || worst->missing() > row.worst->missing()))
        row.worst = &*worst, row.worst_in = &r;
    }
  return row;
}

const char* largestTerm(const safety::ProtectiveDistance& s) {
  const std::array<std::pair<double, const char*>, 4> terms{
      {{s.person, "person"}, {s.reaction, "reaction"}, {s.stopping, "stopping"}, {s.constant, "constant"}}};
  return std::max_element(terms.begin(), terms.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

}  // namespace abstand::tune
