#include "app/tune/contact_row.hpp"

namespace abstand::tune {

ContactRow contactRow(const std::vector<TunedRecording>& recordings, const std::string& name) {
  ContactRow row;
  row.part = name;
  for (const TunedRecording& r : recordings)
    for (const PartClearance& part : r.pass.parts) {
      if (part.part != name) continue;
      row.exceeded += part.contacts.exceeded;
      const auto& worst = part.contacts.worst;
      if (worst && (!row.worst || isHarder(worst->contact, row.worst->contact)))
        row.worst = &*worst, row.worst_in = &r;
    }
  return row;
}

}  // namespace abstand::tune
