// Tracks which client sends the joint values of each mechanism.
#pragma once

#include <vector>

#include "app/serve/packet.hpp"
#include "app/serve/packet_stream.hpp"

namespace abstand::serve {

/// Each joint value has one sender at a time, whether in packets of its mechanism or of all mechanisms. A
/// mechanism belongs to the sender of its last accepted packet until that sender was silent for `stale`
/// seconds. One thread, no allocation after construction.
class JointOwners {
 public:
  JointOwners(std::size_t mechanisms, double stale) : owners_(mechanisms), stale_(stale) {}

  /// True if the sender may set the joints of the mechanism (or of kAllMechanisms) at `t` (s).
  bool mayTake(std::uint32_t mechanism, double t, const Address& from) const noexcept {
    for (std::size_t m = 0; m < owners_.size(); ++m)
      if (concerns(mechanism, m) && owners_[m].from.known() && !(owners_[m].from == from) &&
          t - owners_[m].t <= stale_)
        return false;
    return true;
  }
  /// Call after an accepted packet.
  void took(std::uint32_t mechanism, double t, const Address& from) noexcept {
    for (std::size_t m = 0; m < owners_.size(); ++m)
      if (concerns(mechanism, m)) owners_[m] = {from, t};
  }

 private:
  static bool concerns(std::uint32_t packet, std::size_t mechanism) noexcept {
    return packet == kAllMechanisms || packet == mechanism;
  }
  struct Owner {
    Address from;
    double t{-kInfinity};
  };
  std::vector<Owner> owners_;
  double stale_;
};

}  // namespace abstand::serve
