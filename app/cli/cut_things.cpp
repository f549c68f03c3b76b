// Options about the scene's robots and objects in depth images.
#include "app/cli/cut_things.hpp"

namespace abstand::cli {

void addCutThings(CLI::App& command, std::optional<bool>& cut_things) {
  auto* cut = command.add_flag_callback(
      "--cut-things", [&cut_things] { cut_things = true; },
      "remove the scene's robots and objects from the depth images, at their poses in the scene (default: if "
      "the images show them)");
  command
      .add_flag_callback(
          "--no-cut-things", [&cut_things] { cut_things = false; },
          "never remove the scene's robots and objects from the depth images")
      ->excludes(cut);
}

}  // namespace abstand::cli
