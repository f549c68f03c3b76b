// Sequence numbers of a stream of packets.
#pragma once

#include <cstdint>

#include "app/serve/address.hpp"
#include "core/math/transform.hpp"

namespace abstand::serve {

/// Counts of one stream, or of all.
struct StreamCounts {
  long late{0};        ///< older than an earlier one, first arrival
  long lost{0};        ///< skipped numbers, minus those that arrived late
  long duplicates{0};  ///< numbers that had already arrived
  long foreign{0};     ///< from a sender that does not own the stream
};

/// A stream starts with its first packet and belongs to that sender. A packet is accepted if its number is
/// newer than all before, modulo 2^32. After a silence of `stale` seconds, an older number or another sender
/// restarts the stream. One thread, no allocation.
class PacketStream {
 public:
  explicit PacketStream(double stale) : stale_(stale) {}

  /// True if the packet is accepted. `t`: s, arrival time.
  bool take(std::uint32_t sequence, double t, const Address& from, StreamCounts& counts) noexcept;

 private:
  void begin(std::uint32_t sequence, const Address& from) noexcept;

  double stale_;
  double last_{-kInfinity};  ///< s, of the last accepted packet
  std::uint32_t newest_{0};
  std::uint64_t seen_{0};    ///< bit i: newest_ - i has arrived
  std::uint64_t missed_{0};  ///< bit i: newest_ - i is counted as lost
  Address owner_;
};

}  // namespace abstand::serve
