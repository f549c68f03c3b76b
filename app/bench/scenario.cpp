#include "app/bench/scenario.hpp"

#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"

namespace abstand::bench {
namespace {

void readScenarioJson(const std::filesystem::path& folder, Scenario& scenario) {
  const auto file = folder / "scenario.json";
  const std::string text = readFile(file);
  try {
    const auto j = nlohmann::json::parse(text);
    scenario.name = j.value("name", folder.filename().string());
    scenario.dt = j.value("dt", 0.001);
    for (const auto& o : j.at("objects"))
      scenario.bodies.push_back(
          {o.at("name"), folder / o.at("mesh").get<std::string>(), o.value("scale", 1.0)});
    for (const auto& p : j.at("pairs")) scenario.pairs.emplace_back(p.at(0), p.at(1));
  } catch (const nlohmann::json::exception& e) {
    throw ParseError({file.string()}, std::string("is no scenario: ") + e.what());
  }
  const int count = static_cast<int>(scenario.bodies.size());
  for (const auto& [a, b] : scenario.pairs)
    if (a < 0 || b < 0 || a >= count || b >= count || a == b)
      throw ParseError({file.string()}, "found a pair [" + std::to_string(a) + ", " + std::to_string(b) +
                                            "], expected two different numbers of objects");
  if (scenario.bodies.empty() || scenario.pairs.empty())
    throw ParseError({file.string()}, "found no object or no pair");
}

void readPoses(const std::filesystem::path& folder, Scenario& scenario) {
  const auto file = folder / "poses.csv";
  const std::string text = readFile(file);
  int line = 1;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::size_t at = begin;
    for (std::size_t o = 0; end > begin && o < scenario.bodies.size(); ++o) {
      Transform X = Transform::Identity();
      for (int k = 0; k < 12; ++k) {
        const std::size_t comma = std::min(text.find(',', at), end);
        const auto v = parseDouble(std::string_view(text).substr(at, comma - at));
        if (!v)
          throw ParseError(
              {file.string(), line, static_cast<int>(at - begin) + 1},
              "expected a number, 12 for each of " + std::to_string(scenario.bodies.size()) + " objects");
        X.matrix()(k / 4, k % 4) = *v;
        at = std::min(comma + 1, end);
      }
      scenario.X_WB.push_back(X);
    }
    begin = end + 1;
    ++line;
  }
  if (scenario.X_WB.empty()) throw ParseError({file.string()}, "found no frame");
}

}  // namespace

Scenario loadScenario(const std::filesystem::path& folder) {
  Scenario scenario;
  readScenarioJson(folder, scenario);
  readPoses(folder, scenario);
  return scenario;
}

}  // namespace abstand::bench
