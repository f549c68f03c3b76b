// Fuzzes the readers of Kinect texts; of UI-PRMD both files are the same text.
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/kinect/irds.hpp"
#include "tracking/kinect/ui_prmd.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  abstand::tracking::looksLikeIrdsCsv(bytes);
  if (abstand::tracking::looksLikeUiPrmd(bytes))
    abstand::testing::readAll([&] { return abstand::tracking::UiPrmdReader(bytes, "p", bytes, "a"); });
  else
    abstand::testing::readAll([&] { return abstand::tracking::IrdsReader(bytes, "fuzz"); });
  return 0;
}
