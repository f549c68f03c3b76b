// Packets of one kind in the order of their sequence numbers.
#pragma once

#include <cstdint>

#include "app/serve/address.hpp"
#include "core/math/transform.hpp"

namespace abstand::serve {

/// What became of the packets of a stream, or of all.
struct StreamCounts {
  long late{0};        ///< older than one that came before, and not seen yet
  long lost{0};        ///< numbers left out, less those that came late
  long duplicates{0};  ///< numbers seen already
  long foreign{0};     ///< of another sender than the one whose stream it is
};

/// A stream begins with its first packet and belongs to that sender. A packet is taken when its number is
/// newer than all before, compared modulo 2^32. After a silence of `stale` seconds, an older number or
/// another sender begins the stream anew. One thread, no allocation.
class PacketStream {
 public:
  explicit PacketStream(double stale) : stale_(stale) {}

  /// True when the packet is to be used. `t`: s, when it came.
  bool take(std::uint32_t sequence, double t, const Address& from, StreamCounts& counts) noexcept;

 private:
  void begin(std::uint32_t sequence, const Address& from) noexcept;

  double stale_;
  double last_{-kInfinity};  ///< s, of the last packet that was taken
  std::uint32_t newest_{0};
  std::uint64_t seen_{0};    ///< bit i: newest_ - i came
  std::uint64_t missed_{0};  ///< bit i: newest_ - i is counted as lost
  Address owner_;
};

}  // namespace abstand::serve
