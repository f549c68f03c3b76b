#include "app/tune/margin_rules.hpp"

#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {

MarginRules loadMarginRules(const std::filesystem::path& path) {
  const auto parts = humanmodel::partNames();
  return margin::parseMarginRules(readFile(path, config::kMaxYamlBytes), path.string(),
                                  {parts.begin(), parts.end()});
}

}  // namespace abstand::tune
