// Fuzzes the reader of plans: only ParseError may come out, and every run has a name of its own.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "app/tune/plan.hpp"
#include "core/base/error.hpp"

namespace {

/// A folder with one file that the corpus names for every scene, recording and motion.
std::filesystem::path planFile() {
  const auto folder = std::filesystem::temp_directory_path() / "abstand-plan-fuzz";
  std::filesystem::create_directories(folder);
  for (const char* name : {"f", "g"}) std::ofstream(folder / name) << "t,q0\n0,0\n";
  return folder / "plan.yaml";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file = planFile();
  try {
    const auto items = abstand::tune::parsePlan(std::string(reinterpret_cast<const char*>(data), size), file);
    ABSTAND_CHECK(!items.empty());
    std::set<std::string> names;
    for (const auto& item : items) {
      ABSTAND_CHECK(names.insert(item.name).second && !item.scene.empty() && item.speed > 0.0);
      abstand::humanmodel::HumanOptions body;
      item.person.apply(body);
    }
  } catch (const abstand::ParseError&) {
  }
  return 0;
}
