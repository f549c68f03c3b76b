// The report on margins: a page for people, to be signed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

struct TuneReportOptions {
  std::string version;  ///< of the program
  std::string command;  ///< what was asked for: the scene or the plan
  /// A drawing of the moment of an approach (momentPicture), or nothing.
  std::function<std::string(const tune::TunedRecording&, const tune::Approach&)> picture;
};

/// One HTML page with tables, plots and drawings; no script, nothing from outside. It holds no date and no
/// machine: these are for whom signs it. Throws UsageError and WriteError.
void writeTuneReport(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file);

}  // namespace abstand::report
