#include "app/cli/output_check.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/output_place.hpp"

namespace abstand::cli {
namespace {

namespace fs = std::filesystem;

struct Named {
  std::string option, value;
};

bool isFolder(const std::string& value) {
  std::error_code ec;
  return fs::is_directory(value, ec);
}

void checkPlace(const Named& output, OutputKind kind, bool json) {
  if (kind == OutputKind::kFolder) {
    std::error_code ec;
    if (fs::exists(output.value, ec) && !fs::is_directory(output.value, ec))
      throw UsageError(output.option + ": found the file " + output.value +
                       ", expected a directory or a name for a new one");
    return;
  }
  const OutputPlace place = placeOfOutput(output.value);
  if (json && isStandardOutput(place))
    throw UsageError(output.option + ": found standard output with --json, expected one of them there");
}

/// True if writing `output` would replace `input`.
bool replaces(const Named& output, OutputKind kind, const std::string& input) {
  std::error_code ec;
  if (kind == OutputKind::kFolder) return isFolder(input) && fs::equivalent(output.value, input, ec);
  if (!fs::is_regular_file(input, ec)) return false;
  return fs::exists(output.value, ec) && fs::equivalent(output.value, input, ec);
}

/// True if both outputs go to the same place.
bool isOneName(const std::string& a, OutputKind a_kind, const std::string& b, OutputKind b_kind) {
  if (a_kind == OutputKind::kFile && b_kind == OutputKind::kFile) return isSameOutput(a, b);
  std::error_code ec;
  const auto absolute = [&ec](const std::string& name) {
    const fs::path path = fs::weakly_canonical(fs::absolute(name, ec), ec);
    return path.has_filename() ? path : path.parent_path();
  };
  return absolute(a) == absolute(b);
}

}  // namespace

void checkOutputs(const CLI::App& root, const CommandLine& line) {
  const auto chosen = root.get_subcommands();
  if (chosen.empty()) return;
  std::vector<std::pair<Named, OutputKind>> outputs;
  std::vector<Named> inputs;
  for (const CLI::Option* option : chosen.front()->get_options()) {
    const auto known = std::find_if(line.outputs.begin(), line.outputs.end(),
                                    [option](const auto& o) { return o.first == option; });
    for (const std::string& value : option->results()) {
      if (value.empty()) continue;
      if (known == line.outputs.end())
        inputs.push_back({option->get_name(), value});
      else
        outputs.push_back({{option->get_name(), value}, known->second});
    }
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [output, kind] = outputs[i];
    checkPlace(output, kind, line.json);
    for (const Named& input : inputs)
      if (replaces(output, kind, input.value))
        throw UsageError(output.option + ": found " + output.value + ", which is also an input (" +
                         input.option + "), expected a different file");
    for (std::size_t k = 0; k < i; ++k)
      if (isOneName(outputs[k].first.value, outputs[k].second, output.value, kind))
        throw UsageError(output.option + ": found " + output.value + ", which " + outputs[k].first.option +
                         " also writes, expected different names");
  }
}

}  // namespace abstand::cli
