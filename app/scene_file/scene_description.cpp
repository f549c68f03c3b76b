#include "app/scene_file/scene_description.hpp"

#include <algorithm>
#include <set>

#include "app/scene_file/body_fields.hpp"
#include "app/scene_file/scene_body_reader.hpp"
#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"
#include "core/study/pairs_file.hpp"

namespace abstand::scene_file {
namespace {

namespace fs = std::filesystem;

constexpr config::YamlRange kStiffnessRange{0.0, 1e15, "N/m^3", true};
constexpr config::YamlRange kShareRange{0.0, 1.0};
constexpr config::YamlRange kToleranceRange{0.0, query::kMaxFarTolerance};
constexpr config::YamlRange kHorizonRange{0.0, 1e4, "m"};
constexpr config::YamlRange kBudgetRange{0.0, 1e3, "s"};

using NamePair = std::pair<std::string, std::string>;

SceneDefaults defaults(const config::YamlNode& node, const std::string& file) {
  const config::YamlFields fields(node, file, "`defaults`",
                                  {"voxel", "point", "outer_layers", "field", "margin", "stiffness", "law"});
  SceneDefaults d;
  d.haptic.voxel_size = fields.number("voxel", kVoxelRange).value_or(d.haptic.voxel_size);
  d.haptic.point_spacing = fields.number("point", kVoxelRange).value_or(d.haptic.point_spacing);
  d.haptic.outer_layers = fields.integer("outer_layers", 0, kMaxOuterLayers).value_or(d.haptic.outer_layers);
  if (const auto field = fields.choice("field", {"layered", "float", "mixed"}))
    d.haptic.field = *structure::parseFieldKind(*field);
  d.margin = fields.number("margin", kMarginRange).value_or(d.margin);
  d.stiffness = fields.number("stiffness", kStiffnessRange).value_or(d.stiffness);
  d.thesis_law = fields.choice("law", {"volume", "thesis"}).value_or("volume") == "thesis";
  return d;
}

/// [a, b]: names of two different bodies of the scene.
NamePair namePair(const config::YamlNode& node, const std::string& file, const std::string& label,
                  const std::vector<std::string>& bodies) {
  const SourcePos pos{file, node.line, node.column};
  const auto& names = config::yamlList(node, file, "a pair of " + label);
  if (names.size() != 2)
    throw ParseError(
        pos, "found a list of " + std::to_string(names.size()) + " in " + label + ", expected two names");
  for (const auto& name : names) {
    const std::string text = config::yamlText(name, file, "a name in " + label);
    if (std::find(bodies.begin(), bodies.end(), text) == bodies.end())
      throw ParseError(
          {file, name.line, name.column},
          "found " + config::yamlFound(name) + " in " + label + ", expected the name of a body of this scene",
          config::nearestHint(text, bodies));
  }
  if (names[0].text == names[1].text)
    throw ParseError(pos, "found a pair of " + config::yamlFound(names[0]) + " with itself in " + label +
                              ", expected two different bodies");
  return {names[0].text, names[1].text};
}

/// Unknown names are ignored: a file may cover more bodies than the scene has.
void dropByFile(PairsDescription& p, const std::vector<std::string>& bodies) {
  const std::set<std::string> known(bodies.begin(), bodies.end());
  bool any = false;
  for (const auto& row : study::loadPairs(p.file)) {
    const bool both = known.contains(row.a) && known.contains(row.b);
    any = any || both;
    if (both && row.verdict != study::PairVerdict::kSometimes)
      p.dropped.push_back(
          {row.a, row.b,
           study::verdictName(row.verdict) + (row.evidence.empty() ? "" : ": " + row.evidence)});
  }
  if (!any)
    throw ParseError({p.file.string()}, "found no pair of bodies of this scene, expected their names",
                     "`abstand pairs SCENE` names them like the scene");
}

PairsDescription pairRules(const config::YamlNode& node, const std::string& file,
                           const SceneBodyReader& reader) {
  const config::YamlFields fields(node, file, "`pairs`",
                                  {"default", "adjacent", "within_people", "file", "exclude", "include"});
  const auto& bodies = reader.bodies();
  PairsDescription p;
  if (const auto* pairs_file = fields.find("file")) {
    p.file = reader.existingFile(*pairs_file, "`file`", "a file of `abstand pairs`");
    dropByFile(p, bodies);
  }
  const auto standard = fields.choice("default", {"all", "between_groups", "none"}).value_or("all");
  p.standard = standard == "all"    ? PairDefault::kAll
               : standard == "none" ? PairDefault::kNone
                                    : PairDefault::kBetweenGroups;
  p.exclude_adjacent = fields.choice("adjacent", {"exclude", "include"}).value_or("exclude") == "exclude";
  p.within_people = fields.choice("within_people", {"exclude", "include"}).value_or("exclude") == "include";
  for (const auto& pair : fields.list("exclude")) {
    p.exclude.push_back(namePair(pair, file, "`exclude`", bodies));
    p.exclude_pos.push_back(fields.pos(pair));
  }
  for (const auto& pair : fields.list("include")) {
    p.include.push_back(namePair(pair, file, "`include`", bodies));
    p.include_pos.push_back(fields.pos(pair));
  }
  return p;
}

ThreadGroups threadGroups(const config::YamlNode& node, const std::string& file,
                          const std::vector<std::string>& bodies) {
  if (node.kind == config::YamlNode::Kind::kScalar && node.text == "auto") return {};
  if (node.kind != config::YamlNode::Kind::kList)
    throw ParseError(
        {file, node.line, node.column},
        "found " + config::yamlFound(node) + " for `threads`, expected `auto` or a list of groups of pairs");
  ThreadGroups groups;
  std::set<NamePair> seen;
  for (const auto& group : node.items) {
    auto& pairs = groups.emplace_back();
    for (const auto& item : config::yamlList(group, file, "a group of `threads`")) {
      const auto pair = namePair(item, file, "`threads`", bodies);
      if (!seen.insert(std::minmax(pair.first, pair.second)).second)
        throw ParseError({file, item.line, item.column},
                         "found the pair `" + pair.first + "`, `" + pair.second +
                             "` a second time in `threads`, expected it once");
      pairs.push_back(pair);
    }
    if (pairs.empty())
      throw ParseError({file, group.line, group.column}, "found an empty group in `threads`, expected pairs");
  }
  return groups;
}

scene::QueryCulling skippingRules(const config::YamlNode& node, const std::string& file) {
  const config::YamlFields fields(node, file, "`skipping`",
                                  {"rest", "horizon", "budget", "remember", "tolerance"});
  scene::QueryCulling s;
  s.rest = fields.number("rest", kShareRange).value_or(s.rest);
  s.horizon = fields.number("horizon", kHorizonRange).value_or(s.horizon);
  s.budget = fields.number("budget", kBudgetRange).value_or(s.budget);
  s.remember = fields.choice("remember", {"true", "false"}).value_or("true") == "true";
  s.far_tolerance = fields.number("tolerance", kToleranceRange).value_or(s.far_tolerance);
  return s;
}

}  // namespace

void BodySettings::fillFrom(const BodySettings& other) {
  if (!voxel) voxel = other.voxel;
  if (!point) point = other.point;
  if (!margin) margin = other.margin;
  if (!max_speed) max_speed = other.max_speed;
  if (!outer_layers) outer_layers = other.outer_layers;
}

SceneDescription parseScene(const std::string& text, const fs::path& path,
                            const robot_file::PackagePaths& packages) {
  const std::string file = path.string();
  const config::YamlNode root = config::parseYaml(text, file);
  const config::YamlFields fields(
      root, file, "the scene",
      {"abstand", "defaults", "mechanisms", "humans", "objects", "pairs", "threads", "skipping"});
  if (!fields.find("abstand"))
    throw ParseError(fields.pos(),
                     "found no `abstand` in the scene, expected the format version `abstand: 1`");
  const config::YamlNode& version = fields.need("abstand");
  if (version.kind != config::YamlNode::Kind::kScalar || version.quoted || version.text != "1")
    throw ParseError(fields.pos(version),
                     "found " + config::yamlFound(version) + " for `abstand`, expected format version 1");

  SceneDescription scene;
  std::error_code ec;
  scene.file = fs::absolute(path, ec).lexically_normal();
  SceneBodyReader bodies(file, scene.file.parent_path(), packages);
  if (const auto* node = fields.find("defaults")) scene.defaults = defaults(*node, file);
  for (const auto& node : fields.list("mechanisms")) scene.mechanisms.push_back(bodies.mechanism(node));
  for (const auto& node : fields.list("humans")) scene.humans.push_back(bodies.human(node));
  for (const auto& node : fields.list("objects")) scene.objects.push_back(bodies.object(node));
  if (const auto* node = fields.find("pairs")) scene.pairs = pairRules(*node, file, bodies);
  scene.pairs.dropped.insert(scene.pairs.dropped.begin(), bodies.dropped().begin(), bodies.dropped().end());
  scene.remarks = bodies.remarks();
  if (const auto* node = fields.find("threads")) scene.threads = threadGroups(*node, file, bodies.bodies());
  if (const auto* node = fields.find("skipping")) scene.culling = skippingRules(*node, file);
  return scene;
}

SceneDescription loadScene(const fs::path& file, const robot_file::PackagePaths& packages) {
  return parseScene(readFile(file, config::kMaxYamlBytes), file, packages);
}

}  // namespace abstand::scene_file
