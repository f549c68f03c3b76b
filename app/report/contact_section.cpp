#include "app/report/contact_section.hpp"

#include <algorithm>
#include <cmath>

#include "app/report/page.hpp"
#include "app/tune/contact_row.hpp"
#include "app/tune/stored_limits.hpp"
#include "core/text/escaped_xml.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

constexpr double kPascal = 1e4;      // Pa of 1 N/cm^2
constexpr double kSpringUnit = 1e3;  // N/m of 1 N/mm
constexpr const char* kNotLimited = "contact excluded";

/// "210 of 280". `infinite`: what an infinite value means.
std::string ofLimit(double value, double limit, int digits, const char* infinite = "not bounded (wall)") {
  return (std::isfinite(value) ? text::rounded(value, digits) : infinite) + " of " +
         text::rounded(limit, digits);
}

std::string kilograms(double kg) { return std::isfinite(kg) ? text::rounded(kg, 1) : "wall"; }

/// "force, factor: SOURCE; spring: SOURCE", values of one source together.
std::string sourcesText(const contact::RegionLimits& r) {
  const std::pair<const char*, const contact::CitedValue*> values[] = {
      {"force", &r.force},   {"factor", &r.transient}, {"pressure", &r.pressures.front().pressure},
      {"spring", &r.spring}, {"mass", &r.body_mass},
  };
  std::vector<std::pair<std::string, std::string>> groups;  // source, names
  for (const auto& [name, value] : values) {
    const std::string& source = value->source;
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == source; });
    if (group == groups.end())
      groups.emplace_back(source, name);
    else
      group->second += std::string(", ") + name;
  }
  std::string text;
  for (const auto& [source, names] : groups) text += (text.empty() ? "" : "; ") + names + ": " + source;
  for (const auto& [name, value] : values)
    if (!value->to_be_checked.empty())
      text += std::string(". To be checked: ") + name + ", " + value->to_be_checked;
  return text;
}

}  // namespace

std::string contactTimeSection(const tune::TuneAnswer& answer) {
  if (answer.recordings.front().contact_limits.empty()) return {};
  std::vector<std::vector<std::string>> rows;
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    const tune::ContactRow row = tune::contactRow(answer.recordings, p.part);
    std::vector<std::string> cells{p.part, text::rounded(row.exceeded, 2) + " s"};
    if (!row.worst) {
      cells.insert(cells.end(), {"nothing near closed in", "", "", "", "", "", ""});
    } else {
      const tune::FrameContact& c = row.worst->contact;
      const tune::PassResult& pass = row.worst_in->pass;
      const bool seen = c.region != tune::kNoRegion;
      const std::string infinite = !seen ? "not seen" : c.pressure > 0.0 ? "area not certain" : kNotLimited;
      cells.insert(
          cells.end(),
          {std::isfinite(c.share) ? text::rounded(100.0 * c.share, 0) + " %" : infinite,
           seen ? pass.regions[c.region] : "", seen ? text::rounded(c.force, 0) : "",
           seen ? text::rounded(c.energy, 2) : "",
           seen && c.pressure > 0.0 && std::isfinite(c.pressure) ? text::rounded(c.pressure / kPascal, 0)
                                                                 : "",
           pass.links[c.link],
           (answer.recordings.size() > 1 ? row.worst_in->recording + " at " : std::string()) +
               text::rounded(row.worst->t, 3) + " s"});
    }
    rows.push_back(std::move(cells));
  }
  return "<h2>Contact limits over time</h2>\n<p>In every frame, the contact that each pair nearer than " +
         text::rounded(1e3 * answer.options.pass.near, 0) +
         " mm would have at its closing speed, with force, energy and pressure as below. For each part: the "
         "time in which "
         "such a contact would have exceeded a limit or been excluded, or could not be judged because the "
         "part was not "
         "seen or the contact area is not certain; and the hardest of them, with its share of the limit. A "
         "smaller "
         "--near, a lighter or slower robot and another table of limits change it. Table of limits: " +
         text::escapedXml(answer.recordings.front().contact_limits) + ".</p>\n" +
         htmlTable({"part", "beyond limits for", "share of limit", "region", "force (N)", "energy (J)",
                    "pressure (N/cm\u00b2)", "link", "at"},
                   rows);
}

std::string contactTable(const tune::TuneAnswer& answer,
                         const std::vector<tune::RankedApproach>& approaches) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < approaches.size(); ++i) {
    const tune::Approach& a = *approaches[i].approach;
    const auto judged = tune::judgedContact(*approaches[i].recording, a);
    if (!judged) continue;
    const tune::ContactShare& c = a.contact;
    const contact::PredictedContact& p = judged->contact;
    const bool excluded = c.excluded || p.excluded;
    rows.push_back(
        {std::to_string(i + 1), c.region, std::string(contact::kindText(c.kind)), text::rounded(c.closing, 2),
         kilograms(c.robot_mass), text::rounded(judged->region.body_mass.value, 1), kilograms(p.reduced_mass),
         text::rounded(judged->region.spring.value / kSpringUnit, 0),
         excluded ? kNotLimited : ofLimit(p.force, p.allowed_force, 0),
         excluded ? kNotLimited : ofLimit(p.energy, p.allowed_energy, 2),
         excluded ? kNotLimited
                  : ofLimit(c.pressure / kPascal, judged->allowed_pressure / kPascal, 0, "not certain")});
  }
  if (rows.empty()) return {};
  return "<h3>Predicted contacts</h3>\n<p>Of the approaches with a closing speed, by their numbers: the "
         "contact at the highest closing speed v of the approach, each value beside its limit. Peak force F "
         "= v sqrt(mu k); energy E = mu v^2 / 2, its limit F_limit^2 / (2 k); pressure: peak under the "
         "surface of the link at the indentation F / k. mu is the reduced mass of the robot (m_R, effective "
         "mass at that point in that posture, but at least half of its moving mass) and of the body region "
         "(m_H); of a clamped part, m_R. A higher closing speed raises the force in proportion and the "
         "energy with "
         "its square, a heavier robot both; the pressure depends on the shape of the link, and an edge or a "
         "corner may exceed its limit at a small force. Table of limits: " +
         text::escapedXml(answer.recordings.front().contact_limits) + ".</p>\n" +
         htmlTable({"no.", "region", "kind", "v (m/s)", "m_R (kg)", "m_H (kg)", "mu (kg)", "k (N/mm)",
                    "force (N)", "energy (J)", "pressure (N/cm\u00b2)"},
                   rows);
}

std::string limitTable(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const contact::RegionLimits& r : tune::occurringRegions(answer.recordings)) {
    const contact::PressurePlace& place = r.pressures.front();
    rows.push_back(
        {r.name, r.excluded() ? kNotLimited : text::rounded(r.force.value, 0),
         r.excluded() ? "none" : text::rounded(r.transient.value, 2),
         r.excluded() ? kNotLimited : text::rounded(r.pressure() / kPascal, 0) + ", " + place.place,
         text::rounded(r.spring.value / kSpringUnit, 0), text::rounded(r.body_mass.value, 1),
         sourcesText(r)});
  }
  if (rows.empty()) return {};
  return "<h3>Contact limits used</h3>\n<p>Of the regions of all predicted contacts: quasi-static limits, "
         "which the factor multiplies for transient contact; of several places of a region the smallest "
         "pressure. Another edition may have other values: --contact-limits loads its table. Table: " +
         text::escapedXml(answer.recordings.front().contact_limits) + ".</p>\n" +
         htmlTable({"region", "force (N)", "transient factor", "pressure (N/cm\u00b2), place", "k (N/mm)",
                    "m_H (kg)", "sources"},
                   rows);
}

}  // namespace abstand::report
