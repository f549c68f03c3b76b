// Fuzzes the C3D reader.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/c3d/c3d_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::tracking::looksLikeC3d(bytes);
  abstand::testing::readAll([&] { return abstand::tracking::C3dReader(bytes, "fuzz"); });
  return 0;
}
