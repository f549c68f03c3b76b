#include "app/cli/standard_texts.hpp"

#include <map>

#include "app/cli/json_values.hpp"
#include "app/tune/contact_row.hpp"
#include "app/tune/separation_table.hpp"
#include "app/tune/stored_limits.hpp"
#include "app/tune/stored_terms.hpp"

namespace abstand::cli {
namespace {

using Json = nlohmann::ordered_json;

Json citedJson(const contact::CitedValue& v) {
  return {{"value", numberOrNull(v.value)}, {"source", v.source}, {"to_be_checked", v.to_be_checked}};
}

Json regionsJson(const tune::TuneAnswer& answer) {
  Json rows = Json::array();
  for (const contact::RegionLimits& r : tune::occurringRegions(answer.recordings))
    rows.push_back({{"region", r.name},
                    {"excluded", r.excluded()},
                    {"force", citedJson(r.force)},
                    {"transient_factor", citedJson(r.transient)},
                    {"pressure", citedJson(r.pressures.front().pressure)},
                    {"place", r.pressures.front().place},
                    {"spring", citedJson(r.spring)},
                    {"body_mass", citedJson(r.body_mass)}});
  return rows;
}

/// The terms of the table, and what was used instead where a user stated it.
Json separationTermsJson(const tune::TuneAnswer& answer) {
  std::map<std::string, double> used;
  safety::SeparationOptions::eachNumber(
      answer.options.pass.separation,
      [&](const char* key, const double& value, const config::NumberRule&) { used[key] = value; });
  Json rows = Json::array();
  for (const tune::CitedTerm& term : answer.recordings.front().separation_terms) {
    Json row = citedJson({term.value, term.source, term.to_be_checked});
    row["term"] = term.key;
    row["used"] = used[term.key];
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The numbers of a contact; null for those of a part that is not seen.
Json momentJson(const tune::ContactRow& row) {
  if (!row.worst) return nullptr;
  const tune::FrameContact& c = row.worst->contact;
  const tune::PassResult& pass = row.worst_in->pass;
  const bool seen = c.region != tune::kNoRegion;
  const auto number = [seen](double v) { return seen ? numberOrNull(v) : Json(nullptr); };
  return {{"recording", row.worst_in->recording},
          {"t", row.worst->t},
          {"seen", seen},
          {"link", pass.links[c.link]},
          {"region", seen ? Json(pass.regions[c.region]) : Json(nullptr)},
          {"force", number(c.force)},
          {"energy", number(c.energy)},
          {"pressure", number(c.pressure)},
          {"share", numberOrNull(c.share)}};
}

}  // namespace

void addStandards(const tune::TuneAnswer& answer, Json& j) {
  const std::string& stamp = answer.recordings.front().contact_limits;
  j["contact_limits"] = stamp.empty() ? Json(nullptr) : Json(stamp);
  j["contact_regions"] = regionsJson(answer);
  j["standards"] = {{"protective_distance", safety::kSeparationEdition},
                    {"person_speed", tune::speedsEdition(answer.recordings.front())}};
  const std::string& table = answer.recordings.front().separation_table;
  j["separation_table"] = table.empty() ? Json(nullptr) : Json(table);
  j["separation_terms"] = separationTermsJson(answer);
}

Json separationJson(const tune::TuneAnswer& answer) {
  Json rows = Json::array();
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    const tune::SeparationRow row = tune::separationRow(answer.recordings, p.part);
    Json j{{"part", p.part}, {"broken_time", row.broken}, {"worst", nullptr}};
    if (const tune::SeparationMoment* worst = row.worst)
      j["worst"] = {{"recording", row.worst_in->recording},
                    {"t", worst->t},
                    {"link", row.worst_in->pass.links[worst->link]},
                    {"clearance", worst->clearance},
                    {"needed", worst->needed.sum()},
                    {"person", worst->needed.person},
                    {"reaction", worst->needed.reaction},
                    {"stopping", worst->needed.stopping},
                    {"constant", worst->needed.constant},
                    {"robot_speed", worst->robot_speed},
                    {"permitted_speed", worst->permitted_speed}};
    rows.push_back(std::move(j));
  }
  return rows;
}

Json contactsJson(const tune::TuneAnswer& answer) {
  Json rows = Json::array();
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    const tune::ContactRow row = tune::contactRow(answer.recordings, p.part);
    rows.push_back({{"part", p.part}, {"exceeded_time", row.exceeded}, {"worst", momentJson(row)}});
  }
  return rows;
}

}  // namespace abstand::cli
