#include "app/serve/state_packet.hpp"

#include "app/serve/state_fields.hpp"
#include "app/serve/wire.hpp"

namespace abstand::serve {

std::size_t stateBytes(const StateReport& report) {
  std::size_t bytes = 0;
  eachField(report, {}, 0, [&](const FieldLabel&, auto value) { bytes += sizeof value; });
  return bytes;
}

std::size_t writeState(const StateReport& report, const ReplyTo& to, std::span<std::byte> into) noexcept {
  std::size_t at = 0;
  const auto bytes = static_cast<std::uint32_t>(stateBytes(report));
  eachField(report, to, bytes, [&](const FieldLabel&, auto value) {
    store(into, at, value);
    at += sizeof value;
  });
  return at;
}

}  // namespace abstand::serve
