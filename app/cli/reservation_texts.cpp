#include "app/cli/reservation_texts.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/json_values.hpp"

namespace abstand::cli {

nlohmann::ordered_json reservationsJson(const std::vector<run::Reservation>& reservations) {
  auto list = nlohmann::ordered_json::array();
  for (const run::Reservation& r : reservations) {
    nlohmann::ordered_json j{{"kind", r.kind},           {"text", r.text},
                             {"t0", orNull(r.t0)},       {"t1", orNull(r.t1)},
                             {"share", orNull(r.share)}, {"fails", run::severityName(r.fails)}};
    if (!r.recording.empty()) j["recording"] = r.recording;
    list.push_back(std::move(j));
  }
  return list;
}

std::string reservationsText(const std::vector<run::Reservation>& reservations) {
  std::string text;
  for (const run::Reservation& r : reservations)
    text += "reservation (" + r.kind + "): " + r.text +
            (r.recording.empty() ? "" : " [" + r.recording + "]") + "\n";
  return text;
}

nlohmann::ordered_json extremeJson(const std::optional<run::RunSummary::Extreme>& e) {
  if (!e) return nullptr;
  return {{"a", e->a}, {"b", e->b}, {"t", e->t}, {"value", e->value}};
}

nlohmann::ordered_json byClassJson(const ByClass& least) {
  nlohmann::ordered_json j;
  for (std::size_t i = 0; i < least.size(); ++i)
    j[run::pairClassKey(run::kPairClasses[i])] = extremeJson(least[i]);
  return j;
}

std::string closestText(const ByClass& least) {
  std::string text;
  for (std::size_t i = 0; i < least.size(); ++i)
    if (const auto& e = least[i])
      text +=
          format("minimum distance %s: %.1f mm, %s to %s at %.3f s\n",
                 run::pairClassText(run::kPairClasses[i]), 1e3 * e->value, e->a.c_str(), e->b.c_str(), e->t);
  return text;
}

}  // namespace abstand::cli
