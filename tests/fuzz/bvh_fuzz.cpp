// Fuzzes the BVH reader, its kinematics, the repair of lost bones, and the guess of joints: only ParseError
// may come out, only finite positions, and only joints that exist.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.hpp"
#include "tests/fuzz/read_all.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/shape_guess.hpp"

namespace {

using namespace abstand::tracking;

void checkJoints(const JointMatch& match, std::size_t joints) {
  for (const int i : match.joint) ABSTAND_CHECK(i >= -1 && i < static_cast<int>(joints));
}

void guess(const std::string& text) {
  try {
    BvhPoints points(text, "fuzz", true);
    const auto names = points.names();
    const auto parents = points.parents();
    const auto rest = points.rest();
    PointFrame frame;
    const bool has_frame = points.next(frame);
    checkJoints(guessByNames(names, true), names.size());
    checkJoints(guessByShape({names, parents, rest, {&frame, has_frame ? 1u : 0u}}).match, names.size());
  } catch (const abstand::ParseError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const bool repair : {false, true})
    abstand::testing::readAll([&] { return BvhPoints(text, "fuzz", repair); });
  guess(text);
  return 0;
}
