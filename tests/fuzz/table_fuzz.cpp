// Fuzzes the readers of tables and JSON lines.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "tracking/table/skeleton_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::tracking::looksLikeSkeletonCsv(bytes);
  if (abstand::tracking::looksLikeSkeletonJson(bytes))
    abstand::testing::readAll([&] { return abstand::tracking::SkeletonJsonReader(bytes, "fuzz"); });
  else
    abstand::testing::readAll([&] { return abstand::tracking::SkeletonCsvReader(bytes, "fuzz"); });
  return 0;
}
