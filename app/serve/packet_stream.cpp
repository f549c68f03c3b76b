#include "app/serve/packet_stream.hpp"

namespace abstand::serve {
namespace {

constexpr std::uint32_t kWindow = 64;

/// Shifts by n; bits beyond the window are dropped.
std::uint64_t shifted(std::uint64_t bits, std::uint32_t n) { return n < kWindow ? bits << n : 0; }

}  // namespace

void PacketStream::begin(std::uint32_t sequence, const Address& from) noexcept {
  owner_ = from;
  newest_ = sequence;
  seen_ = 1;
  missed_ = 0;
}

bool PacketStream::take(std::uint32_t sequence, double t, const Address& from,
                        StreamCounts& counts) noexcept {
  const bool silent = !(t - last_ <= stale_);
  const bool ours = owner_ == from;
  if (!ours && !silent) {
    ++counts.foreign;
    return false;
  }
  const auto step = static_cast<std::int32_t>(sequence - newest_);
  if (!owner_.known() || !ours || (silent && step <= 0)) {
    begin(sequence, from);
  } else if (step > 0) {
    const auto n = static_cast<std::uint32_t>(step);
    counts.lost += n - 1;
    seen_ = shifted(seen_, n) | 1;
    // Bits 1 to n - 1: numbers skipped just now.
    missed_ = shifted(missed_, n) |
              ((n < kWindow ? (std::uint64_t{1} << n) - 1 : ~std::uint64_t{0}) & ~std::uint64_t{1});
    newest_ = sequence;
  } else {
    const std::uint32_t back = newest_ - sequence;
    const std::uint64_t bit = back < kWindow ? std::uint64_t{1} << back : 0;
    if (seen_ & bit) {
      ++counts.duplicates;
    } else {
      ++counts.late;
      if (missed_ & bit) --counts.lost;
      seen_ |= bit;
      missed_ &= ~bit;
    }
    return false;
  }
  last_ = t;
  return true;
}

}  // namespace abstand::serve
