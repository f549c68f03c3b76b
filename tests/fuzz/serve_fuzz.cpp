// Fuzzes the packets of `abstand serve` and the frames of its viewers: nothing may come out but a fault or
// numbers that a scene can take.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "app/moment/moment_packet.hpp"
#include "app/serve/packet.hpp"
#include "app/viewer/watch_frame.hpp"
#include "core/base/error.hpp"

namespace {

using namespace abstand;

/// A stream of frames in both directions.
void readFrames(std::span<const std::byte> bytes) {
  static const moment::SceneCard card{1, {}, "s", {"a", "b"}, {"anna"}, {"g"}, {{"arm", 2}}, {{0, 1}}};
  static moment::Moment moment = moment::makeMoment(card);
  moment::FrameSplitter frames;
  frames.add(bytes);
  while (const auto frame = frames.next()) {
    if (const auto rate = viewer::watchedRate(*frame)) ABSTAND_CHECK(*rate >= viewer::kMinWatchRate);
    if (const auto read = moment::readSceneCard(*frame))
      for (const auto& [a, b] : read->pairs)
        ABSTAND_CHECK(a < read->objects.size() && b < read->objects.size());
    if (!moment::readMoment(*frame, moment)) continue;
    for (const view::ObjectSnapshot& object : moment.shown.objects)
      ABSTAND_CHECK(object.X_WB.matrix().allFinite() && object.margin >= 0.0);
    // Neither distance may count as safe without being one.
    ABSTAND_CHECK(!std::isinf(moment.shown.pairs[0].result.distance));
    ABSTAND_CHECK(moment.shown.pair_group[0] < 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  static const serve::PacketFormat format{
      {{"left_arm", 2}, {"right_arm", 1}}, {"operator"}, {"g", "rest"}, {"a", "b"}};
  static serve::Packet packet = serve::makePacket(format);
  const auto bytes = std::as_bytes(std::span(data, size));
  readFrames(bytes);
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
