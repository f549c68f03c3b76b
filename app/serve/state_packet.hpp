// Answer of `abstand serve` as bytes, as a JSON line, and as a table of offsets.
#pragma once

#include "app/serve/state_report.hpp"

namespace abstand::serve {

/// The packet that an answer belongs to.
struct ReplyTo {
  std::uint32_t sequence{0}, index{0};
  std::uint64_t time_us{0};
  bool unasked{false};
};

/// Size of the binary answer; the same for all reports of a scene.
std::size_t stateBytes(const StateReport& report);
/// `into` has at least stateBytes(). Returns the bytes written. No allocation.
std::size_t writeState(const StateReport& report, const ReplyTo& to, std::span<std::byte> into) noexcept;

/// One line of JSON with its end; infinite values and NaN are null. `quoted_*`: names escaped once by
/// quoted(). No allocation; returns 0 if `into` is too small.
std::size_t writeStateJson(const StateReport& report, const ReplyTo& to, const PacketFormat& quoted_format,
                           const StateNames& quoted_names, std::span<std::byte> into) noexcept;
PacketFormat quoted(PacketFormat format);
StateNames quoted(StateNames names);

/// All packets of a scene: offset, type and meaning of every number, and the objects with their numbers.
std::string describeLayout(const PacketFormat& format, const StateNames& names, const StateReport& report);

}  // namespace abstand::serve
