// Fuzzes the packets of `abstand serve`: nothing may come out but a fault or numbers that a scene can take.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "app/serve/packet.hpp"
#include "core/base/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  static const serve::PacketFormat format{
      {{"left_arm", 2}, {"right_arm", 1}}, {"operator"}, {"g", "rest"}, {"a", "b"}};
  static serve::Packet packet = serve::makePacket(format);
  const auto bytes = std::as_bytes(std::span(data, size));
  if (serve::parsePacket(bytes, format, packet) != serve::PacketFault::kNone) return 0;
  if (packet.type == serve::PacketType::kJoints) {
    ABSTAND_CHECK(format.hasMechanism(packet.index) && packet.values == format.dof(packet.index));
    for (std::size_t i = 0; i < packet.values; ++i)
      ABSTAND_CHECK(std::abs(packet.q[i]) <= serve::kMaxCoordinate);
  } else if (packet.type == serve::PacketType::kControl) {
    ABSTAND_CHECK(serve::checkControl(format, packet.control) == serve::PacketFault::kNone);
  } else {
    ABSTAND_CHECK(packet.type == serve::PacketType::kSkeleton && packet.index < format.people.size());
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (packet.skeleton.has(static_cast<humanmodel::Joint>(j)))
        ABSTAND_CHECK(packet.skeleton.p[j].cwiseAbs().maxCoeff() <= serve::kMaxCoordinate);
  }
  return 0;
}
