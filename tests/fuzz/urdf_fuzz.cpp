// Feeds the fuzzer's bytes to the readers of URDF and SRDF: they read or refuse them, and what is read can
// move and be written.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/robot_file/dh_mechanism.hpp"
#include "core/robot_file/robot_writer.hpp"
#include "core/robot_file/srdf_file.hpp"
#include "core/robot_file/urdf_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    robot_file::parseSrdf(robot_file::srdfText(robot_file::parseSrdf(text, "fuzz.srdf")), "again.srdf");
  } catch (const ParseError&) {
  }
  try {
    const robot_file::Robot robot = robot_file::parseUrdf(text, "fuzz.urdf");
    mechanism::MechanismState state;
    mechanism::forward(robot.mechanism,
                       std::vector<double>(static_cast<std::size_t>(robot.mechanism.dof), 0.5), state);
    for (const auto& X_BF : state.X_BF)
      if (!X_BF.matrix().allFinite()) std::abort();
    // Sums of large numbers may be too large for a file; anything else reads back.
    if (robot_file::mechText(robot_file::toDh(robot)).empty()) std::abort();
    robot_file::parseUrdf(robot_file::urdfText(robot).text, "again.urdf");
  } catch (const ParseError&) {
  }
  return 0;
}
