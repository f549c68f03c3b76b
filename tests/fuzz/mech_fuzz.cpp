// Feeds the fuzzer's bytes to the reader of mechanism files: it reads or refuses them, and what it reads can
// move.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/robot_file/mech_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  try {
    const mechanism::Mechanism m =
        robot_file::parseMechanism(std::string(reinterpret_cast<const char*>(data), size), "fuzz.mech");
    mechanism::MechanismState state;
    mechanism::forward(m, std::vector<double>(static_cast<std::size_t>(m.dof), 0.5), state);
    for (const auto& X_BF : state.X_BF)
      if (!X_BF.matrix().allFinite()) std::abort();
  } catch (const ParseError&) {
  }
  return 0;
}
