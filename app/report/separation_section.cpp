#include "app/report/separation_section.hpp"

#include <cmath>

#include "app/report/page.hpp"
#include "app/tune/separation_table.hpp"
#include "app/tune/stored_terms.hpp"
#include "core/text/message_text.hpp"

namespace abstand::report {
namespace {

std::string wholeMm(double metres) {
  return std::isfinite(metres) ? text::rounded(1e3 * metres, 0) : "not seen";
}

}  // namespace

std::string separationSection(const tune::TuneAnswer& answer) {
  std::vector<std::vector<std::string>> rows;
  for (const tune::ProposedMargin& p : answer.table.proposed) {
    const tune::SeparationRow row = tune::separationRow(answer.recordings, p.part);
    if (!row.worst) {
      rows.push_back({p.part, "0 s", "kept", "", "", "", "", "", "", "", "", ""});
      continue;
    }
    const tune::SeparationMoment& m = *row.worst;
    rows.push_back({p.part, text::rounded(row.broken, 2) + " s", wholeMm(m.clearance),
                    wholeMm(m.needed.sum()), wholeMm(m.needed.person), wholeMm(m.needed.reaction),
                    wholeMm(m.needed.stopping), wholeMm(m.needed.constant), tune::largestTerm(m.needed),
                    text::rounded(m.robot_speed, 2) + ", " + text::rounded(m.permitted_speed, 2),
                    row.worst_in->pass.links[m.link],
                    (answer.recordings.size() > 1 ? row.worst_in->recording + " at " : std::string()) +
                        text::rounded(m.t, 3) + " s"});
  }
  return "<h2>Protective distance</h2>\n<p>Speed and separation monitoring (" +
         std::string(safety::kSeparationEdition) +
         "; speeds of people: " + tune::speedsEdition(answer.recordings.front()) +
         "): S_p = "
         "S_h + S_r + S_s + C + Z_d + Z_r against the certified clearance, for each link that moves towards "
         "a "
         "part. Of each part the time for which it was violated, and its worst moment in mm with every term: "
         "the "
         "distance travelled by the person (S_h) and by the robot until it brakes (S_r) and while it brakes "
         "(S_s), and the constants "
         "(C + Z_d + Z_r); then the robot's speed towards the part and the permitted one (m/s). The "
         "assumptions "
         "behind each term are listed below.</p>\n" +
         htmlTable({"part", "violated for", "clearance", "S_p", "S_h", "S_r", "S_s", "constants", "largest",
                    "speed, permitted", "link", "at"},
                   rows);
}

}  // namespace abstand::report
