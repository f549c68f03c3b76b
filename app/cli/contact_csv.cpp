#include "app/cli/contact_csv.hpp"

#include "app/cli/csv_field.hpp"
#include "app/tune/part_frames.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"

namespace abstand::cli {
namespace {

constexpr const char* kHeader =
    "recording,t_s,part,link,region,force_n,energy_j,pressure_n_per_cm2,share_of_limit\n";
constexpr double kPascal = 1e4;  // of 1 N/cm^2

std::string rowEnd(const tune::PassResult& pass, const tune::FrameContact& c) {
  if (!(c.share > 0.0)) return ",,,,,\n";
  if (c.region == tune::kNoRegion) return ",,,,," + formatDouble(c.share) + '\n';
  std::string text = csvField(pass.links[c.link]) + ',' + csvField(pass.regions[c.region]);
  for (const double v : {c.force, c.energy, c.pressure / kPascal, c.share}) text += ',' + formatDouble(v);
  return text + '\n';
}

}  // namespace

std::size_t writeContactTable(const tune::TuneAnswer& answer, const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << kHeader;
  std::size_t rows = 0;
  for (const tune::TunedRecording& r : answer.recordings) {
    const std::string name = csvField(r.recording);
    const tune::PartFrames frames(r);
    for (std::size_t i = 0; i < frames.times().size(); ++i)
      for (const tune::PartClearance& p : frames.parts()) {
        out.stream() << name << ',' << formatDouble(frames.times()[i]) << ',' << p.part << ','
                     << rowEnd(r.pass, p.contact[i]);
        ++rows;
      }
  }
  out.commit();
  return rows;
}

}  // namespace abstand::cli
