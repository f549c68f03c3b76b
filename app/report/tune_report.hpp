// HTML page of the margin report, to be signed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/tune/tune_answer.hpp"

namespace abstand::report {

struct TuneReportOptions {
  std::string version;  ///< of the program
  std::string command;  ///< the scene or the plan
  /// Drawing of an approach (momentPicture); may be empty.
  std::function<std::string(const tune::TunedRecording&, const tune::Approach&)> picture;
};

/// One HTML page with tables, plots and drawings; self-contained, no scripts. Without date and machine, which
/// the signer adds. Throws UsageError and WriteError.
void writeTuneReport(const tune::TuneAnswer& answer, const TuneReportOptions& options,
                     const std::filesystem::path& file);

}  // namespace abstand::report
