#include "app/tune/margin_strategy.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/tune/pair_rows.hpp"
#include "core/base/error.hpp"

namespace abstand::tune {
namespace {

/// By part and link in the order in which the recordings name them; the largest of all recordings.
template <class NeedsOf>
std::vector<GroupNeed> largestNeeds(const std::vector<TunedRecording>& recordings, const NeedsOf& needs_of) {
  std::vector<GroupNeed> groups;
  for (std::size_t r = 0; r < recordings.size(); ++r)
    for (GroupNeed& found : needs_of(recordings[r])) {
      auto group = std::find_if(groups.begin(), groups.end(), [&](const GroupNeed& g) {
        return g.part == found.part && g.link == found.link;
      });
      if (group == groups.end()) group = groups.insert(group, {found.part, found.link, 0.0, {}, {}});
      if (!found.need.decided || (group->recording && !(found.need.margin > group->need.margin))) continue;
      group->need = found.need;
      group->recording = r;
      group->margin = roundedUpMargin(found.need.margin);
    }
  return groups;
}

MarginRules rulesOf(const std::string& name, const std::vector<GroupNeed>& needs) {
  MarginRules rules{name, {}, {}};
  for (const GroupNeed& need : needs) rules.rules.push_back({need.part, need.link, {need.margin, 0.0, 0.0}});
  return rules;
}

bool wouldDo(const MarginRules& rules) {
  return std::all_of(rules.rules.begin(), rules.rules.end(),
                     [](const MarginRule& r) { return std::isfinite(r.margin.margin); });
}

/// True if a margin of any set depends on speeds.
bool growWithSpeed(const std::vector<std::vector<margin::PairMargin>>& sets) {
  return std::any_of(sets.begin(), sets.end(), [](const auto& margins) {
    return std::any_of(margins.begin(), margins.end(), [](const margin::PairMargin& m) {
      return m.robot_time != 0.0 || m.person_time != 0.0;
    });
  });
}

}  // namespace

std::vector<margin::PairMargin> marginsOf(const TunedRecording& recording, const MarginRules& rules) {
  std::vector<margin::PairMargin> margins;
  for (const PassResult::PairOfNames& pair : recording.pass.pairs) {
    const std::string &part = recording.pass.parts[pair.part].part, &link = recording.pass.links[pair.link];
    const auto margin = rules.of(part, link);
    if (!margin)
      throw UsageError(rules.name + ": found no margin for " + part + " and " + link +
                       ", expected a margin for every pair, or `default`");
    margins.push_back(*margin);
  }
  return margins;
}

void checkNames(const std::vector<TunedRecording>& recordings, const MarginRules& rules) {
  std::set<std::string> parts, links;
  for (const TunedRecording& r : recordings) {
    for (const PartClearance& p : r.pass.parts) parts.insert(p.part);
    links.insert(r.pass.links.begin(), r.pass.links.end());
  }
  for (const MarginRule& rule : rules.rules) {
    if (!rule.part.empty() && !parts.count(rule.part))
      throw UsageError(rules.name + ": found the part `" + rule.part + "`, expected one of the recordings");
    if (!rule.link.empty() && !links.count(rule.link))
      throw UsageError(rules.name + ": found the link `" + rule.link + "`, expected one of the recordings");
  }
}

std::vector<GroupNeed> linkNeeds(const std::vector<TunedRecording>& recordings) {
  return largestNeeds(recordings, [](const TunedRecording& r) {
    std::vector<GroupNeed> needs;
    for (std::size_t l = 0; l < r.pass.links.size(); ++l)
      needs.push_back({"", r.pass.links[l], 0.0, {}, r.pass.link_needs[l]});
    return needs;
  });
}

std::vector<GroupNeed> pairNeeds(const std::vector<TunedRecording>& recordings) {
  return largestNeeds(recordings, [](const TunedRecording& r) {
    std::vector<GroupNeed> needs;
    for (std::size_t p = 0; p < r.pass.pairs.size(); ++p)
      needs.push_back({r.pass.parts[r.pass.pairs[p].part].part,
                       r.pass.links[r.pass.pairs[p].link],
                       0.0,
                       {},
                       r.pass.pair_needs[p]});
    return needs;
  });
}

std::vector<MarginRules> proposedRules(const std::vector<TunedRecording>& recordings,
                                       const MarginTable& table) {
  MarginRules uniform{"uniform", {}, margin::PairMargin{}}, per_part{"per_part", {}, {}};
  for (const ProposedMargin& p : table.proposed) {
    uniform.other->margin = std::max(uniform.other->margin, p.margin);
    per_part.rules.push_back({p.part, "", {p.margin, 0.0, 0.0}});
  }
  std::vector<MarginRules> sets;
  if (std::isfinite(uniform.other->margin)) sets.push_back(uniform);
  for (const MarginRules& rules :
       {per_part, rulesOf("per_link", linkNeeds(recordings)), rulesOf("per_pair", pairNeeds(recordings))})
    if (wouldDo(rules)) sets.push_back(rules);
  return sets;
}

std::vector<StrategyOutcome> strategyOutcomes(const std::vector<TunedRecording>& recordings,
                                              const std::vector<MarginRules>& sets,
                                              const margin::MarginOptions& options) {
  std::vector<StrategyOutcome> outcomes;
  for (const MarginRules& rules : sets) {
    checkNames(recordings, rules);
    outcomes.push_back({rules, {}});
  }
  if (sets.empty()) return outcomes;
  for (const TunedRecording& recording : recordings) {
    const WholeBody body = wholeBody(recording, options);
    if (body.first >= recording.frames) continue;
    std::vector<std::vector<margin::PairMargin>> margins;
    for (const MarginRules& rules : sets) margins.push_back(marginsOf(recording, rules));
    const bool grow = growWithSpeed(margins);
    margin::PairMarginSets judged(std::move(margins), options);
    PairRows rows(recording, body.track, grow);
    while (rows.next())
      if (rows.index() >= body.first) judged.add(rows.frame());
    const std::vector<margin::MarginOutcome> of_recording = judged.finish();
    for (std::size_t s = 0; s < sets.size(); ++s) outcomes[s].outcome.add(of_recording[s]);
  }
  return outcomes;
}

}  // namespace abstand::tune
