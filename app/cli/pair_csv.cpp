#include "app/cli/pair_csv.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "app/cli/csv_field.hpp"
#include "app/tune/part_frames.hpp"
#include "app/tune/stored_pairs.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

constexpr std::size_t kFramesAtOnce = 512;
constexpr const char* kPairHeader =
    "recording,t_s,part,link,distance_m,bound_m,uncertainty_m,clearance_m,robot_speed_m_per_s,"
    "person_speed_m_per_s,closing_speed_m_per_s,part_x_m,part_y_m,part_z_m,link_x_m,link_y_m,link_z_m,tool\n";

/// A comma, and a length (m) in the digits that result files have; nothing behind the comma for NaN.
void addLength(std::string& line, double value, int digits) {
  line += ',';
  if (std::isnan(value)) return;
  if (std::isinf(value)) {
    line += formatDouble(value);
    return;
  }
  std::array<char, 64> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  line.append(text.data(), end.ptr);
}

void addRow(std::string& line, const tune::StoredPairs& rows, std::size_t i) {
  for (const double v : {rows.distance[i], rows.bound[i], rows.uncertainty[i], rows.clearance[i]})
    addLength(line, v, 5);
  for (const double v :
       {rows.robot_speed[i], rows.person_speed[i], rows.robot_speed[i] + rows.person_speed[i]})
    line += ',' + formatDouble(v);
  for (const std::vector<double>* points : {&rows.on_part, &rows.on_link})
    for (std::size_t k = 0; k < 3; ++k) addLength(line, (*points)[3 * i + k], 3);
}

}  // namespace

std::size_t writePairTable(const std::vector<tune::TunedRecording>& recordings,
                           const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << kPairHeader;
  std::size_t written = 0;
  std::string text;
  for (const tune::TunedRecording& r : recordings) {
    const tune::StoredPairReader reader(r);
    const std::string name = csvField(r.recording);
    std::vector<std::string> names, tools;
    for (const auto& pair : r.pass.pairs)
      names.push_back("," + r.pass.parts[pair.part].part + "," + csvField(r.pass.links[pair.link]));
    for (const auto& pair : r.pass.pairs) tools.push_back(csvField(r.pass.toolName(pair.tool)));
    const tune::PartFrames frames(r);
    const std::vector<double>& t = frames.times();
    for (std::size_t first = 0; first < r.frames; first += kFramesAtOnce) {
      const std::size_t count = std::min(kFramesAtOnce, r.frames - first);
      const tune::StoredPairs rows = reader.rows(first, count);
      for (std::size_t f = 0; f < count; ++f) {
        const std::string begin = name + ',' + formatDouble(t[first + f]);
        text.clear();
        for (std::size_t p = 0; p < names.size(); ++p) {
          text += begin + names[p];
          addRow(text, rows, f * names.size() + p);
          text += ',' + tools[p] + '\n';
        }
        out.stream() << text;
        written += names.size();
      }
    }
  }
  out.commit();
  return written;
}

}  // namespace abstand::cli
