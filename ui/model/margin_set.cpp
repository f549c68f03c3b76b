// Margins of the window's rows as a set of margins that the command line reads, and back.
#include "ui/model/margin_set.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/error.hpp"
#include "ui/model/groups.hpp"

namespace abstand::ui {

namespace {

constexpr double kSameMargin = 1e-6;       // m
constexpr double kMarginSteps = 1e9;       // a metre: away with the noise of sums
constexpr double kLargestSetMargin = 2.0;  // m, of a row

using Sums = std::vector<std::optional<double>>;

/// Shares the sums of connected parts and links out: to the parts what all links have in common, unless all
/// parts are alike.
void share(Sums& parts, Sums& links, const std::vector<std::size_t>& in_parts,
           const std::vector<std::size_t>& in_links) {
  const auto range = [](const Sums& sums, const std::vector<std::size_t>& of) {
    double least = *sums[of.front()], largest = least;
    for (const std::size_t i : of) least = std::min(least, *sums[i]), largest = std::max(largest, *sums[i]);
    return std::pair{least, largest};
  };
  const auto [part_least, part_largest] = range(parts, in_parts);
  const auto [link_least, link_largest] = range(links, in_links);
  const bool links_alike = link_largest - link_least < kSameMargin;
  const bool parts_alike = part_largest - part_least < kSameMargin;
  const double shift = !links_alike && parts_alike ? -part_least : link_least;
  const auto rounded = [](double metres) { return std::round(metres * kMarginSteps) / kMarginSteps; };
  for (const std::size_t i : in_parts) *parts[i] = rounded(*parts[i] + shift);
  for (const std::size_t i : in_links) *links[i] = rounded(*links[i] - shift);
}

}  // namespace

MarginSet::MarginSet(const view::SceneOutline& outline) {
  for (const auto& [a, b] : outline.pairs) {
    const bool a_is_part = outline.objects[static_cast<std::size_t>(a)].human;
    const int part = a_is_part ? a : b, link = a_is_part ? b : a;
    const auto& person = outline.objects[static_cast<std::size_t>(part)];
    const auto& robot = outline.objects[static_cast<std::size_t>(link)];
    if (!person.human || robot.human || isThing(robot)) continue;
    const std::size_t p = indexOf(parts_, shortName(person), part);
    pairs_.push_back({p, indexOf(links_, robot.name, link)});
  }
}

std::size_t MarginSet::indexOf(std::vector<Body>& bodies, const std::string& name, int object) {
  auto body = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  if (body == bodies.end()) body = bodies.insert(body, {name, {}});
  if (std::find(body->objects.begin(), body->objects.end(), object) == body->objects.end())
    body->objects.push_back(object);
  return static_cast<std::size_t>(body - bodies.begin());
}

std::vector<std::string> MarginSet::partNames() const {
  std::vector<std::string> names;
  for (const Body& part : parts_) names.push_back(part.name);
  return names;
}

margin::MarginRules MarginSet::rules(const std::vector<double>& margins) const {
  margin::MarginRules rules{"window", {}, {}, true};
  const auto largest = [&](const Body& body) {
    double margin = 0.0;
    for (const int object : body.objects)
      margin = std::max(margin, margins[static_cast<std::size_t>(object)]);
    return margin::PairMargin{margin, 0.0, 0.0};
  };
  for (const Body& part : parts_) rules.rules.push_back({part.name, "", largest(part)});
  for (const Body& link : links_) rules.rules.push_back({"", link.name, largest(link)});
  return rules;
}

bool MarginSet::differs(const std::vector<double>& margins) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Body& part) {
    return std::any_of(part.objects.begin(), part.objects.end(), [&](int object) {
      return margins[static_cast<std::size_t>(object)] !=
             margins[static_cast<std::size_t>(part.objects.front())];
    });
  });
}

void MarginSet::checkNames(const margin::MarginRules& rules) const {
  const auto check = [&](const std::vector<Body>& bodies, const std::string& name, const char* what) {
    if (name.empty() ||
        std::any_of(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; }))
      return;
    throw UsageError(rules.name + ": found the " + what + " `" + name + "`, expected one of the scene");
  };
  for (const margin::MarginRule& rule : rules.rules) {
    check(parts_, rule.part, "part");
    check(links_, rule.link, "link");
  }
}

double MarginSet::marginOf(const margin::MarginRules& rules, const Pair& pair) const {
  const std::string &part = parts_[pair.part].name, &link = links_[pair.link].name;
  const auto margin = rules.of(part, link);
  if (!margin)
    throw UsageError(rules.name + ": found no margin for " + part + " and " + link +
                     ", expected a margin for every pair, or `default`");
  if (margin->robot_time > 0.0 || margin->person_time > 0.0)
    throw UsageError(rules.name + ": found a margin of " + part + " and " + link +
                     " that grows with speeds, expected one that does not: the window has no such margins");
  return margin->margin;
}

QMap<int, double> MarginSet::margins(const margin::MarginRules& set) const {
  checkNames(set);
  if (set.rules.empty() && !set.other) return {};
  margin::MarginRules rules = set;
  rules.classes.clear();
  std::vector<double> wanted;
  for (const Pair& pair : pairs_) wanted.push_back(marginOf(rules, pair));
  Sums parts(parts_.size()), links(links_.size());
  if (!takeOwn(rules, parts, links)) solve(wanted, parts, links);
  QMap<int, double> margins;
  const auto take = [&](const std::vector<Body>& bodies, const Sums& sums) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const double margin = *sums[i];
      if (margin > kLargestSetMargin)
        throw UsageError(rules.name + ": found a margin for " + bodies[i].name +
                         " above 2 m, expected at most 2 m");
      for (const int object : bodies[i].objects) margins[object] = std::max(0.0, margin);
    }
  };
  take(parts_, parts);
  take(links_, links);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const Body &part = parts_[pairs_[p].part], &link = links_[pairs_[p].link];
    if (std::abs(margins[part.objects.front()] + margins[link.objects.front()] - wanted[p]) > kSameMargin)
      throw UsageError(rules.name + ": found a margin of " + part.name + " and " + link.name +
                       " of its own, expected one for each part and each link: the window adds these two");
  }
  return margins;
}

/// The rows that the set was made of, where it says them.
bool MarginSet::takeOwn(const margin::MarginRules& rules, Sums& parts, Sums& links) const {
  if (!rules.sum) return false;
  const auto take = [&](const std::vector<Body>& bodies, bool are_parts, Sums& sums) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (const margin::MarginRule& rule : rules.rules)
        if ((are_parts ? rule.link : rule.part).empty() &&
            (are_parts ? rule.part : rule.link) == bodies[i].name)
          sums[i] = rule.margin.margin;
    return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.has_value(); });
  };
  if (take(parts_, true, parts) && take(links_, false, links)) return true;
  std::fill(parts.begin(), parts.end(), std::nullopt);
  std::fill(links.begin(), links.end(), std::nullopt);
  return false;
}

void MarginSet::solve(const std::vector<double>& wanted, Sums& parts, Sums& links) const {
  for (std::size_t first = 0; first < parts_.size(); ++first) {
    if (parts[first]) continue;
    parts[first] = 0.0;
    std::set<std::size_t> in_parts{first}, in_links;
    for (bool grown = true; std::exchange(grown, false);)
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const auto [part, link] = pairs_[p];
        if (parts[part].has_value() == links[link].has_value()) continue;
        grown = true;
        if (parts[part])
          links[link] = wanted[p] - *parts[part];
        else
          parts[part] = wanted[p] - *links[link];
        in_parts.insert(part);
        in_links.insert(link);
      }
    share(parts, links, {in_parts.begin(), in_parts.end()}, {in_links.begin(), in_links.end()});
  }
}

}  // namespace abstand::ui
