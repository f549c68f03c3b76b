// Texts of `abstand build` about a structure, and about one not built yet.
#pragma once

#include "app/cli/command_line.hpp"
#include "core/store/build_report.hpp"
#include "core/store/resolution_estimate.hpp"

namespace abstand::cli {

/// One member of the JSON document, and lines of text.
struct Said {
  nlohmann::ordered_json json;
  std::string text;
};

/// Text lines only for anomalies.
Said sayReport(const store::BuildReport& report);

/// `--explain`: the requested resolution compared with coarser and finer ones.
Said explain(const std::string& name, std::shared_ptr<const geometry::Surface> surface,
             const structure::HapticOptions& asked, const structure::BuildMonitor& monitor);

/// Explanation of how explain() computes its numbers.
nlohmann::ordered_json explainRules();

}  // namespace abstand::cli
