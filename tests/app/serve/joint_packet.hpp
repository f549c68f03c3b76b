// Packets of one joint, for scenes with one slide.
#pragma once

#include "app/serve/packet.hpp"

namespace abstand::serve {

/// Joint 0 of mechanism 0 is at `value` (rad or m), sent at `t` (s).
inline void setJoint(Packet& packet, double value, double t, bool reset) {
  packet.type = PacketType::kJoints;
  packet.index = 0;
  packet.values = 1;
  packet.q[0] = value;
  packet.time_us = static_cast<std::uint64_t>(1e6 * t);
  packet.reset = reset;
}

}  // namespace abstand::serve
