// Results of `tune --out` as messages with times.
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
  std::optional<double> margin;  ///< m: events at this margin are told, too
};

struct McapCounts {
  std::size_t topics{0}, messages{0};
};

/// One topic for each recording and body part (docs/margins.md, "MCAP"), one of approaches, and with a margin
/// one of its events; in order of time. Throws UsageError, WriteError, and UsageError for times that do not
/// fit 64 bits of ns.
McapCounts writeMcap(const tune::TuneAnswer& answer, const McapOptions& options,
                     const std::filesystem::path& file);

/// A topic for each recording, in order: its name without the folders that all share, letters, digits, `_`,
/// `-` and `/` alone, each once: "/data/a/reach.bvh, f" is "/reach_bvh_f". Foxglove asks for quotation marks
/// about other names.
std::vector<std::string> topicNames(const std::vector<std::string>& recordings);

}  // namespace abstand::results
