// Fuzzes the TRC reader.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/trc/trc_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::tracking::looksLikeTrc(bytes);
  abstand::testing::readAll([&] { return abstand::tracking::TrcReader(bytes, "fuzz"); });
  return 0;
}
