// What `abstand build` says of a structure, and of one that is not built yet.
#pragma once

#include "app/cli/command_line.hpp"
#include "core/store/build_report.hpp"
#include "core/store/resolution_estimate.hpp"

namespace abstand::cli {

/// One member of the document and a few lines.
struct Said {
  nlohmann::ordered_json json;
  std::string text;
};

/// Lines only for what is worth a thought.
Said sayReport(const store::BuildReport& report);

/// `--explain`: the asked resolution among coarser and finer ones.
Said explain(const std::string& name, std::shared_ptr<const geometry::Surface> surface,
             const structure::HapticOptions& asked, const structure::BuildMonitor& monitor);

/// How the numbers of explain() come about.
nlohmann::ordered_json explainRules();

}  // namespace abstand::cli
