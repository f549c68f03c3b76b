// Layout of the packets of a scene, for programs and people.
#pragma once

#include "app/serve/state_packet.hpp"

namespace abstand::serve {

/// All packets of one scene, field by field.
struct Layout {
  struct Field {
    std::size_t offset;  ///< bytes
    std::string type;    ///< f64, u32, ...
    std::string meaning;
  };
  struct PacketLayout {
    std::string title;
    std::size_t bytes;
    std::vector<Field> fields;
  };
  std::vector<PacketLayout> packets;
  std::vector<std::string> states, reasons, groups, objects;  ///< by number
};

Layout layoutOf(const PacketFormat& format, const StateNames& names, const StateReport& report);

}  // namespace abstand::serve
