#include "app/cli/separation_csv.hpp"

#include "app/cli/csv_field.hpp"
#include "app/tune/frame_separation.hpp"
#include "app/tune/separation_table.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

constexpr const char* kHeader =
    "recording,t_s,part,link,clearance_m,robot_speed_m_per_s,person_speed_m_per_s,person_m,reaction_m,"
    "stopping_m,constant_m,protective_distance_m,missing_m,permitted_speed_m_per_s,largest_term\n";
constexpr const char* kNothingMoves = ",,,,,,,,,,,,\n";

void addRow(std::string& text, const tune::PassResult& pass, const tune::SeparationMoment& m) {
  text += ',' + csvField(pass.links[m.link]);
  for (const double v :
       {m.clearance, m.robot_speed, m.person_speed, m.needed.person, m.needed.reaction, m.needed.stopping,
        m.needed.constant, m.needed.sum(), m.missing(), m.permitted_speed})
    text += ',' + formatDouble(v);
  text += std::string(",") + tune::largestTerm(m.needed) + '\n';
}

}  // namespace

std::size_t writeSeparationTable(const tune::TuneAnswer& answer, const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << kHeader;
  std::size_t written = 0;
  std::string text;
  for (const tune::TunedRecording& r : answer.recordings) {
    const std::string name = csvField(r.recording);
    const tune::WholeBody body = tune::wholeBody(r, answer.options.margins());
    tune::PairRows rows(r, body.track);
    while (rows.next()) {
      const margin::PairFrame frame = rows.frame();
      const auto moments = tune::frameSeparation(r.pass, frame, answer.options.pass.separation);
      text.clear();
      for (std::size_t p = 0; p < moments.size(); ++p) {
        text += name + ',' + formatDouble(frame.t) + ',' + r.pass.parts[p].part;
        if (moments[p])
          addRow(text, r.pass, *moments[p]);
        else
          text += kNothingMoves;
      }
      out.stream() << text;
      written += moments.size();
    }
  }
  out.commit();
  return written;
}

}  // namespace abstand::cli
