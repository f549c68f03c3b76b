// Fuzzes the reader of terms of the protective distance: only ParseError may come out, and no options that
// are out of range.
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/error.hpp"
#include "core/safety/separation_standard.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace abstand;
  try {
    const auto table =
        safety::parseSeparationStandard(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
    table.options().validate();
    for (const char* key : {"person_speed", "person_speed_near", "near"})
      ABSTAND_CHECK(table.term(key) && !table.term(key)->cited.source.empty());
  } catch (const ParseError&) {
  }
  return 0;
}
