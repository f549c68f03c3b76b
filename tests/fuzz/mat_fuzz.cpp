// Fuzzes the reader of MATLAB skeletons.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/kinect/utd_mhad.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::testing::readAll([&] { return abstand::tracking::UtdMhadReader(bytes, "fuzz"); });
  return 0;
}
