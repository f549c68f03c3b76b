#include "app/tune/variant_band.hpp"

#include <algorithm>

#include "app/tune/part_frames.hpp"
#include "core/margin/safe_margin.hpp"

namespace abstand::tune {
namespace {

void takeRun(const PartClearance& part, std::size_t run, const margin::MarginOptions& options,
             VariantBand& band) {
  margin::SafeMarginWatch watch(options);
  double least = kInfinity;
  for (std::size_t i = 0; i < part.track.frames(); ++i) {
    watch.add(part.track.clearance[i], part.track.between[i], part.track.braking[i]);
    least = std::min({least, part.track.clearance[i], part.track.between[i]});
  }
  band.runs.push_back(run);
  band.margin.take(watch.judged() ? watch.value().margin : kInfinity, run);
  band.clearance.take(least, run);
}

}  // namespace

void Band::take(double value, std::size_t run) {
  if (value < least) least = value, of_smallest = run;
  if (value > largest) largest = value, of_largest = run;
}

std::vector<VariantBand> variantBands(const std::vector<TunedRecording>& recordings,
                                      const margin::MarginOptions& options) {
  std::vector<VariantBand> all;
  std::vector<bool> taken(recordings.size(), false);
  for (std::size_t first = 0; first < recordings.size(); ++first) {
    if (taken[first] || recordings[first].content.empty()) continue;
    std::vector<std::size_t> runs;
    for (std::size_t r = first; r < recordings.size(); ++r)
      if (recordings[r].content == recordings[first].content) runs.push_back(r), taken[r] = true;
    if (runs.size() < 2) continue;
    std::vector<VariantBand> bands;
    for (const PartClearance& part : recordings[first].pass.parts) bands.push_back({part.part, {}, {}, {}});
    for (const std::size_t r : runs) {
      PartByPart parts(recordings[r]);
      for (std::size_t p = 0; p < parts.size(); ++p) {
        const auto band = std::find_if(bands.begin(), bands.end(), [&](const VariantBand& b) {
          return b.part == recordings[r].pass.parts[p].part;
        });
        if (band != bands.end()) takeRun(parts.part(p), r, options, *band);
      }
    }
    std::move(bands.begin(), bands.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace abstand::tune
