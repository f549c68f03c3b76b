// abstand human: the parametric human from the stature.
#include "app/cli/command_line.hpp"
#include "app/cli/worn_arguments.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_folder.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "humanmodel/enclosed_share.hpp"
#include "humanmodel/human_model.hpp"

namespace abstand::cli {
namespace {

constexpr double kMeshSagitta = 2e-4;  // m, of the written meshes

struct HumanArguments {
  std::string height, mass, percentile, sex, preset{"anthropometric"}, out, clothing;
  std::vector<std::string> set;
};

/// PART.KEY=VALUE
void applyOverride(humanmodel::HumanOptions& options, const std::string& text) {
  const std::size_t dot = text.find('.'), equals = text.find('=');
  if (dot == std::string::npos || equals == std::string::npos || equals < dot)
    throw UsageError("--set: found '" + text +
                     "', expected PART.contour=VALUE (or length, breadth, depth, shape)");
  const std::string part_name = text.substr(0, dot), key = text.substr(dot + 1, equals - dot - 1);
  const std::string value = text.substr(equals + 1);
  humanmodel::PartOverride& o = options.overrides[bodyPart(part_name, "--set")];
  if (key == "shape")
    o.shape = value;
  else if (key == "length")
    o.length = number(value, "--set " + text);
  else if (key == "contour")
    o.contour = number(value, "--set " + text);
  else if (key == "breadth")
    o.breadth = number(value, "--set " + text);
  else if (key == "depth")
    o.depth = number(value, "--set " + text);
  else
    throw UsageError("--set: found '" + key + "', expected contour, length, breadth, depth or shape");
}

nlohmann::ordered_json partJson(const humanmodel::HumanModel& human, const humanmodel::HumanPart& p,
                                const humanmodel::EnclosedShare& enclosed) {
  nlohmann::ordered_json j{{"name", humanmodel::partName(p.part)},
                           {"shape", geometry::shapeName(p.shape)},
                           {"length", p.length},
                           {"contour", p.contour}};
  if (const auto* e = std::get_if<geometry::Ellipsoid>(&p.shape)) j["semi_axes"] = toJson(e->semi_axes);
  if (const auto* c = std::get_if<geometry::Cuboid>(&p.shape)) j["size"] = toJson(c->size);
  const auto worn = human.options.clothing.find(p.part);
  j["clothing"] = worn == human.options.clothing.end() ? 0.0 : worn->second;
  j["mass"] = p.mass;
  j["com"] = toJson(p.com);
  j["inertia"] = toJson(p.inertia);
  j["proximal"] = toJson(p.p_proximal);
  j["distal"] = toJson(p.p_distal);
  j["proximal_joint"] = humanmodel::jointName(p.proximal);
  j["distal_joint"] = humanmodel::jointName(p.distal);
  j["enclosed_share"] = enclosed.at_stature;
  j["enclosed_share_all_statures"] = enclosed.all_statures;
  return j;
}

int runHuman(const CommandLine& line, const HumanArguments& args) {
  humanmodel::HumanOptions options;
  if (args.height.empty() && args.percentile.empty())
    throw UsageError("found neither --height nor --percentile, expected one");
  if (!args.height.empty()) options.height = number(args.height, "--height");
  if (!args.percentile.empty()) options.percentile = number(args.percentile, "--percentile");
  if (!args.mass.empty()) options.mass = number(args.mass, "--mass");
  if (!args.sex.empty()) options.sex = args.sex == "f" ? humanmodel::Sex::kFemale : humanmodel::Sex::kMale;
  options.preset =
      args.preset == "thesis" ? humanmodel::HumanPreset::kThesis : humanmodel::HumanPreset::kAnthropometric;
  for (const auto& s : args.set) applyOverride(options, s);
  options.clothing = clothingOf(args.clothing);
  const humanmodel::HumanModel human = humanmodel::makeHuman(options);

  const auto enclosed = humanmodel::enclosedShare(human, options.sex);

  nlohmann::ordered_json document{
      {"height", human.height},
      {"mass", human.mass},
      {"preset", args.preset},
      {"percentile",
       options.percentile ? nlohmann::ordered_json(*options.percentile) : nlohmann::ordered_json()},
      {"parts", nlohmann::ordered_json::array()}};
  std::string text = format("%.3f m, %.1f kg, preset %s", human.height, human.mass, args.preset.c_str());
  if (options.percentile) text += ", percentile " + formatDouble(*options.percentile);
  text += format("\n%-14s %-10s %9s %9s %8s %10s\n", "part", "shape", "length m", "contour m", "mass kg",
                 "encloses %");
  for (const humanmodel::HumanPart& p : human.parts) {
    const humanmodel::EnclosedShare& share = enclosed[humanmodel::index(p.part)];
    document["parts"].push_back(partJson(human, p, share));
    text +=
        format("%-14s %-10s %9.4f %9.4f %8.2f %10.1f\n", std::string(humanmodel::partName(p.part)).c_str(),
               std::string(geometry::shapeName(p.shape)).c_str(), p.length, p.contour, p.mass,
               100.0 * share.at_stature);
  }
  if (!args.out.empty()) {
    OutputFolder folder(args.out);
    for (const humanmodel::HumanPart& p : human.parts)
      mesh_file::saveMesh(geometry::tessellate(p.shape, kMeshSagitta),
                          folder.place(std::string(humanmodel::partName(p.part)) + ".stl"));
    folder.commit();
    text += "meshes: " + args.out + "\n";
  }
  line.print(document, text);
  return kDone;
}

}  // namespace

void addHuman(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(
      root, line, "human", "generates the parametric human: fourteen parts from stature or percentile",
      "abstand human --height 1.8 --mass 80 --sex m --set hand_left.contour=0.25 --out parts");
  auto args = std::make_shared<HumanArguments>();
  command->add_option("--height", args->height, "stature in m (0.5 to 2.5); default: that of --percentile");
  command->add_option(
      "--mass", args->mass,
      "body mass in kg; default: body mass index of --percentile, else of the mean person, at --height");
  command->add_option("--percentile", args->percentile,
                      "1 to 99: stature and mass of that percentile, and girths not exceeded by "
                      "that percentage of people of that stature (ANSUR II)");
  command
      ->add_option("--sex", args->sex,
                   "f or m (default: the mean of both; with --percentile: of both together)")
      ->check(CLI::IsMember({"f", "m"}));
  command->add_option("--preset", args->preset, "thesis or anthropometric")
      ->check(CLI::IsMember({"thesis", "anthropometric"}));
  command->add_option("--set", args->set, "PART.contour=m, also length, breadth, depth, shape");
  command->add_option("--clothing", args->clothing,
                      "PRESET,PART=m,...: what the person wears; widens the shapes (docs/human.md)");
  line.output(command->add_option("--out", args->out, "folder for one mesh per part"), OutputKind::kFolder);
  command->callback([&line, args] { line.run = [&line, args] { return runHuman(line, *args); }; });
}

}  // namespace abstand::cli
