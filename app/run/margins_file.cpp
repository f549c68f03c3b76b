// Parses `NAME: metres` lines, the simplest YAML map, without a library, so that names with slashes need no
// quotes.
#include <sstream>

#include "app/run/distance_check.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"

namespace abstand::run {
namespace {

constexpr std::uintmax_t kMaxBytes = 1 << 20;

std::string bare(std::string_view s) { return std::string(text::trimmed(s, " \t\r\"'")); }

}  // namespace

void applyMargins(scene::Scene& scene, const std::filesystem::path& file) {
  std::istringstream in(readFile(file, kMaxBytes));
  std::vector<std::string> names;
  for (const scene::Object& o : scene.objects()) names.push_back(o.spec.name);
  int line = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    text = text.substr(0, text.find('#'));
    if (bare(text).empty()) continue;
    const auto colon = text.rfind(':');
    if (colon == std::string::npos)
      throw ParseError({file.string(), line, 1}, "found '" + bare(text) + "', expected NAME: METRES");
    const std::string name = bare(text.substr(0, colon)), value = bare(text.substr(colon + 1));
    ObjectId id(0);
    if (!scene.find(name, &id)) {
      const std::string near = nearestName(name, names);
      throw ParseError({file.string(), line, 1},
                       "found '" + name + "', expected the name of an object of the scene",
                       near.empty() ? "" : "did you mean '" + near + "'?");
    }
    const auto margin = parseDouble(value);
    if (!margin || *margin < 0.0)
      throw ParseError({file.string(), line, static_cast<int>(colon) + 2},
                       "found '" + value + "', expected a margin in metres, not negative");
    scene.setMargin(id, *margin);
  }
}

}  // namespace abstand::run
