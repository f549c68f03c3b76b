#include "app/tune/plan.hpp"

#include <algorithm>
#include <set>

#include "app/scene_file/worn_reader.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/config/yaml_reader.hpp"

namespace abstand::tune {
namespace {

namespace fs = std::filesystem;

constexpr config::YamlRange kHeightRange{0.5, 2.5, "m"};
constexpr config::YamlRange kMassRange{10.0, 300.0, "kg"};
constexpr config::YamlRange kPercentileRange{1.0, 99.0, "%"};
constexpr config::YamlRange kShiftRange{-100.0, 100.0, "m"};
constexpr config::YamlRange kTurnRange{-10.0, 10.0, "rad"};
constexpr config::YamlRange kPlanSpeedRange{0.0, 100.0, "", true};
constexpr std::size_t kMaxItems = 1000000;

/// Reads one plan; paths are relative to its folder.
class PlanReader {
 public:
  explicit PlanReader(const fs::path& path) : file_(path.string()), folder_(path.parent_path()) {}

  std::vector<PlanItem> read(const std::string& text) {
    const config::YamlNode root = config::parseYaml(text, file_);
    const config::YamlFields fields(root, file_, "the plan",
                                    {"abstand_plan", "scenes", "recordings", "people", "mirror", "places",
                                     "speeds", "programs", "clothing", "tools"});
    const config::YamlNode& version = fields.need("abstand_plan");
    if (version.kind != config::YamlNode::Kind::kScalar || version.text != "1")
      throw ParseError(fields.pos(version), "found " + config::yamlFound(version) +
                                                " for `abstand_plan`, expected format version 1");
    fields.need("scenes");
    const std::vector<fs::path> scenes = files(fields, "scenes", [this](const auto& node, const auto& label) {
      return scene_file::existingFile(node, in(), label, "a scene file");
    });
    if (scenes.empty())
      throw ParseError(fields.keyPos("scenes"), "found no scene in `scenes`, expected one or more");
    std::vector<fs::path> recordings =
        files(fields, "recordings", [this](const auto& node, const auto& label) {
          return scene_file::existingRecording(node, in(), label);
        });
    if (recordings.empty()) recordings.emplace_back();
    std::vector<PersonVariant> people = peopleOf(fields);
    const std::vector<RecordingVariant> variants = variantsOf(fields);
    std::vector<double> speeds = speedsOf(fields);
    const auto programs = programsOf(fields);
    const std::vector<NamedWorn> worn = wornOf(fields);
    const double all = static_cast<double>(scenes.size()) * static_cast<double>(recordings.size()) *
                       static_cast<double>(people.size()) * static_cast<double>(variants.size()) *
                       static_cast<double>(speeds.size()) * static_cast<double>(programs.size()) *
                       static_cast<double>(worn.size());
    if (all > static_cast<double>(kMaxItems))
      throw ParseError(fields.pos(), "found more than a million runs in the plan, expected fewer");
    std::vector<PlanItem> items;
    for (const fs::path& scene : scenes)
      for (std::size_t program = 0; program < programs.size(); ++program)
        for (const fs::path& recording : recordings)
          for (const PersonVariant& person : people)
            for (const RecordingVariant& variant : variants)
              for (const double speed : speeds)
                for (const NamedWorn& w : worn) {
                  PlanItem item{scene, recording, person, variant, speed, programs[program], "", w.worn};
                  item.name = nameOf(item, scenes.size() > 1, programs.size() > 1 ? program + 1 : 0) + w.name;
                  if (!names_.insert(item.name).second)
                    throw ParseError(fields.pos(),
                                     "found the run `" + item.name + "` twice, expected each once");
                  items.push_back(std::move(item));
                }
    return items;
  }

 private:
  struct NamedWorn {
    WornVariant worn;
    std::string name;  ///< ", clothing torso 0.015, tool hand_right/driver"; empty for nothing
  };
  /// The product of `clothing` and `tools`.
  std::vector<NamedWorn> wornOf(const config::YamlFields& fields) const {
    std::vector<NamedWorn> worn;
    for (const config::YamlNode& node : fields.list("clothing")) {
      NamedWorn w{{scene_file::readClothing(node, file_), {}}, ""};
      for (const auto& [part, thickness] : w.worn.clothing)
        w.name += (w.name.empty() ? ", clothing " : " ") + std::string(humanmodel::partName(part)) + " " +
                  formatDouble(thickness);
      worn.push_back(std::move(w));
    }
    if (worn.empty()) worn.emplace_back();
    if (fields.list("tools").empty()) return worn;
    std::vector<NamedWorn> all;
    for (const NamedWorn& clothed : worn)
      for (const config::YamlNode& node : fields.list("tools")) {
        NamedWorn w = clothed;
        for (const config::YamlNode& tool : config::yamlList(node, file_, "an item of `tools`")) {
          w.worn.tools.push_back(
              scene_file::readTool(tool, file_, [&](const auto& n, const auto& label, const char* expected) {
                return scene_file::existingFile(n, in(), label, expected);
              }));
          w.name += ", tool " + w.worn.tools.back().bodyName("").substr(1);
        }
        all.push_back(std::move(w));
      }
    return all;
  }
  scene_file::NamedIn in() const { return {file_, folder_, "plan"}; }
  template <typename Find>  // from a node and its label
  static std::vector<fs::path> files(const config::YamlFields& fields, const std::string& key, Find find) {
    std::vector<fs::path> list;
    for (const config::YamlNode& node : fields.list(key)) list.push_back(find(node, "`" + key + "`"));
    return list;
  }
  std::vector<PersonVariant> peopleOf(const config::YamlFields& fields) const {
    std::vector<PersonVariant> people;
    for (const config::YamlNode& node : fields.list("people")) {
      const config::YamlFields p(node, file_, "a person", {"height", "mass", "percentile", "sex"});
      PersonVariant person{p.number("height", kHeightRange),
                           p.number("mass", kMassRange),
                           p.number("percentile", kPercentileRange),
                           {}};
      if (const auto sex = p.choice("sex", {"f", "m"}))
        person.sex = *sex == "f" ? humanmodel::Sex::kFemale : humanmodel::Sex::kMale;
      if (const auto* percentile = p.find("percentile")) check(person, *percentile);
      people.push_back(person);
    }
    if (people.empty()) people.emplace_back();
    return people;
  }
  /// Throws ParseError at `place` for an impossible person.
  void check(const PersonVariant& person, const config::YamlNode& place) const {
    humanmodel::HumanOptions body;
    person.apply(body);
    try {
      humanmodel::makeHuman(body);
    } catch (const UsageError& e) {
      throw ParseError({file_, place.line, place.column}, e.what());
    }
  }
  /// The product of `mirror` and `places`.
  std::vector<RecordingVariant> variantsOf(const config::YamlFields& fields) const {
    std::vector<RecordingVariant> places;
    for (const config::YamlNode& node : fields.list("places")) {
      const config::YamlFields p(node, file_, "a place", {"shift", "turn"});
      places.push_back({false, p.vector("shift", kShiftRange).value_or(Vector3d::Zero()),
                        p.number("turn", kTurnRange).value_or(0.0)});
    }
    if (places.empty()) places.emplace_back();
    std::vector<bool> mirrors;
    for (const config::YamlNode& node : fields.list("mirror"))
      mirrors.push_back(config::yamlChoice(node, file_, "`mirror`", {"false", "true"}) == "true");
    if (mirrors.empty()) mirrors.push_back(false);
    std::vector<RecordingVariant> variants;
    for (const bool mirrored : mirrors)
      for (const RecordingVariant& place : places) variants.push_back({mirrored, place.shift, place.turn});
    return variants;
  }
  std::vector<double> speedsOf(const config::YamlFields& fields) const {
    std::vector<double> speeds;
    for (const config::YamlNode& node : fields.list("speeds"))
      speeds.push_back(config::yamlNumber(node, file_, "`speeds`", kPlanSpeedRange));
    if (speeds.empty()) speeds.push_back(1.0);
    return speeds;
  }
  std::vector<std::map<std::string, fs::path>> programsOf(const config::YamlFields& fields) const {
    std::vector<std::map<std::string, fs::path>> programs;
    for (const config::YamlNode& node : fields.list("programs")) {
      if (node.kind != config::YamlNode::Kind::kMap)
        throw ParseError(
            {file_, node.line, node.column},
            "found " + config::yamlFound(node) + " for a program, expected {MECHANISM: motion.csv}");
      std::map<std::string, fs::path> motions;
      for (std::size_t i = 0; i < node.keys.size(); ++i)
        motions[node.keys[i].text] =
            scene_file::existingFile(node.items[i], in(), "a motion", "a CSV of joint values");
      programs.push_back(std::move(motions));
    }
    if (programs.empty()) programs.emplace_back();
    return programs;
  }
  static std::string nameOf(const PlanItem& item, bool with_scene, std::size_t program) {
    std::string name = (item.recording.empty() ? item.scene : item.recording).string();
    if (with_scene && !item.recording.empty()) name += " in " + item.scene.filename().string();
    if (program > 0) name += ", program " + std::to_string(program);
    if (item.person.percentile) name += ", percentile " + formatDouble(*item.person.percentile);
    if (item.person.height) name += ", height " + formatDouble(*item.person.height);
    if (item.person.mass) name += ", mass " + formatDouble(*item.person.mass);
    if (item.person.sex)
      name += std::string(", ") + (*item.person.sex == humanmodel::Sex::kFemale ? "f" : "m");
    const RecordingVariant& v = item.variant;
    if (v.mirrored) name += ", mirrored";
    if (!v.shift.isZero())
      name += ", shift " + formatDouble(v.shift.x()) + " " + formatDouble(v.shift.y()) + " " +
              formatDouble(v.shift.z());
    if (v.turn != 0.0) name += ", turn " + formatDouble(v.turn);
    if (item.speed != 1.0) name += ", speed " + formatDouble(item.speed);
    return name;
  }

  std::string file_;
  fs::path folder_;
  std::set<std::string> names_;
};

}  // namespace

void PersonVariant::apply(humanmodel::HumanOptions& body) const {
  if (percentile) {
    body.percentile = percentile;
    body.height.reset();
    body.mass.reset();
  }
  if (height) body.height = height;
  if (mass) body.mass = mass;
  if (sex) body.sex = sex;
}

void RecordingVariant::apply(scene_file::RecordingDescription& recording) const {
  recording.mirrored = recording.mirrored != mirrored;
  recording.place_xyz += shift;
  recording.place_yaw += turn;
}

void WornVariant::apply(scene_file::HumanDescription& human) const {
  humanmodel::addClothing(clothing, human.body.clothing);
  for (const scene_file::ToolDescription& tool : tools) {
    const std::string name = tool.bodyName(human.name);
    for (const scene_file::ToolDescription& other : human.tools)
      if (other.bodyName(human.name) == name)
        throw UsageError("found the tool `" + name + "` twice, expected another name for one of them");
    human.tools.push_back(tool);
  }
}

void PlanItem::apply(scene_file::SceneDescription& description) const {
  for (auto& human : description.humans) {
    person.apply(human.body);
    human.recording.speed *= speed;
    variant.apply(human.recording);
    worn.apply(human);
    worn_always.apply(human);
  }
  for (const auto& [mechanism, motion] : motions) {
    const auto it = std::find_if(description.mechanisms.begin(), description.mechanisms.end(),
                                 [&, &wanted = mechanism](const auto& m) { return m.name == wanted; });
    if (it == description.mechanisms.end())
      throw UsageError(description.file.string() + ": found no mechanism `" + mechanism +
                       "`, expected the one of the program");
    it->motion = motion;
  }
}

std::vector<PlanItem> parsePlan(const std::string& text, const fs::path& file) {
  return PlanReader(file).read(text);
}

std::vector<PlanItem> loadPlan(const fs::path& file) {
  return parsePlan(readFile(file, config::kMaxYamlBytes), file);
}

bool isPlan(const fs::path& file) {
  std::error_code ec;
  if (!fs::is_regular_file(file, ec)) return false;
  try {
    const config::YamlNode root = config::parseYaml(readFile(file, config::kMaxYamlBytes), file.string());
    return std::any_of(root.keys.begin(), root.keys.end(),
                       [](const auto& key) { return key.text == "abstand_plan"; });
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace abstand::tune
