// Options for what people wear and hold.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/tune/plan.hpp"

namespace abstand::cli {

/// `--clothing`: "work_clothes,gloves,head=0.02": presets and PART=m; the thickest counts. Throws UsageError.
humanmodel::Clothing clothingOf(const std::string& text);

/// `--tool`: "right=cylinder:0.01,0.3", "left=drill.stl@0.1,0,0" or with ",roll,pitch,yaw" (m, rad) behind:
/// hand, shape or mesh (m), and its pose in the frame of the hand. Its name is that of the shape or the file.
/// Throws UsageError.
scene_file::ToolDescription toolOf(const std::string& text);

/// Both, for commands that run plans.
struct WornArguments {
  std::string clothing;
  std::vector<std::string> tools;

  void add(CLI::App& command);
  /// Throws UsageError, also for two tools of one name in one hand.
  tune::WornVariant worn() const;
};

}  // namespace abstand::cli
