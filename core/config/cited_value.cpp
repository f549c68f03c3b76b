#include "core/config/cited_value.hpp"

namespace abstand::config {
namespace {

std::string sourceOf(const YamlFields& fields, const CitedSources& sources) {
  const std::string key = neededText(fields, "source");
  const auto found = sources.texts.find(key);
  if (found != sources.texts.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [name, text] : sources.texts) known.push_back(name);
  throw ParseError(fields.pos(fields.need("source")),
                   "found the source " + ticked(key) + ", which is not in `sources`",
                   nearestHint(key, known));
}

}  // namespace

std::string ticked(const std::string& text) { return "`" + text + "`"; }

std::string neededText(const YamlFields& fields, const char* key) {
  return yamlText(fields.need(key), fields.file(), ticked(key));
}

std::vector<std::string> textList(const YamlFields& fields, const char* key) {
  std::vector<std::string> all;
  for (const YamlNode& item : fields.list(key)) all.push_back(yamlText(item, fields.file(), ticked(key)));
  return all;
}

CitedSources citedSources(const YamlFields& table) {
  const YamlNode& node = table.need("sources");
  if (node.kind != YamlNode::Kind::kMap)
    throw ParseError(table.pos(node), "found " + yamlFound(node) + " for `sources`, expected a map");
  CitedSources sources{table.file(), {}};
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const YamlFields fields(node.items[i], table.file(), "a source", {"edition", "table"});
    sources.texts[node.keys[i].text] = neededText(fields, "edition") + ", " + neededText(fields, "table");
  }
  return sources;
}

CitedValue citedValue(const YamlFields& fields, const CitedSources& sources) {
  CitedValue value;
  value.source = sourceOf(fields, sources);
  value.to_be_checked = fields.text("to_be_checked").value_or("");
  return value;
}

CitedValue citedNumber(const YamlFields& row, const char* name, const char* unit, const YamlRange& range,
                       double si, const CitedSources& sources) {
  const YamlFields fields(row.need(name), sources.file, ticked(name), {unit, "source", "to_be_checked"});
  CitedValue value = citedValue(fields, sources);
  value.value = si * yamlNumber(fields.need(unit), sources.file, ticked(unit), range);
  return value;
}

}  // namespace abstand::config
