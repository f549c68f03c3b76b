// Fuzzes the reader of compact recordings.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/compact/compact_recording.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::testing::readAll([&] { return abstand::tracking::CompactReader(bytes, "fuzz"); });
  return 0;
}
