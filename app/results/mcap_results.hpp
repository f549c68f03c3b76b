// Exports results of `tune --out` as MCAP.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/tune/tune_answer.hpp"

namespace abstand::results {

struct McapOptions {
  std::string library;           ///< name and version of the program
  std::optional<double> margin;  ///< m: also export events at this margin
};

struct McapCounts {
  std::size_t topics{0}, messages{0};
};

/// One topic for each recording and body part (docs/margins.md, "MCAP"), one for approaches, and with a
/// margin one for its events; in order of time. Throws UsageError, also for times that do not fit 64 bits of
/// ns, and WriteError.
McapCounts writeMcap(const tune::TuneAnswer& answer, const McapOptions& options,
                     const std::filesystem::path& file);

/// A unique topic for each recording, in order: its name without the common folders, limited to letters,
/// digits, `_`, `-` and `/`: "/data/a/reach.bvh, f" becomes "/reach_bvh_f". Foxglove requires quotation marks
/// around other names.
std::vector<std::string> topicNames(const std::vector<std::string>& recordings);

}  // namespace abstand::results
