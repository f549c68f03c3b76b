// Fuzzes the readers of Acclaim files: the skeleton, a zero byte, the motion.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/acclaim/acclaim_recording.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto zero = std::min(bytes.find('\0'), bytes.size());
  const std::string asf = bytes.substr(0, zero), amc = bytes.substr(std::min(zero + 1, bytes.size()));
  abstand::tracking::looksLikeAsf(asf);
  abstand::tracking::looksLikeAmc(amc);
  abstand::testing::readAll([&] { return abstand::tracking::AcclaimPoints(asf, "asf", amc, "amc"); });
  return 0;
}
