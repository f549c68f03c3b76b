// abstand build: haptic structures of meshes and shapes.
#include <iostream>
#include <optional>

#include "app/cli/build_texts.hpp"
#include "app/cli/mesh_argument.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/base/output_folder.hpp"
#include "core/mesh_file/mesh_file.hpp"
#include "core/store/structure_cache.hpp"
#include "core/store/structure_file.hpp"

namespace abstand::cli {
namespace {

constexpr double kDrawingSagitta = 2e-4;  // m, of the written mesh of a shape

struct BuildArguments {
  std::vector<std::string> meshes;
  std::string voxel{"0.005"}, point{"0.005"}, scale{"1"}, field{"mixed"}, out;
  int outer_layers{20};
  bool explain{false};
  robot_file::PackagePaths packages;
};

struct Body {
  std::string name;
  std::shared_ptr<const geometry::Surface> surface;
  std::vector<std::string> remarks;
};

Body load(const std::string& text, double scale, const robot_file::PackagePaths& packages,
          store::StructureCache& cache) {
  if (const auto shape = geometry::parseShape(text)) return {text, geometry::makeSurface(*shape), {}};
  const std::filesystem::path file = meshArgument(text, packages);
  mesh_file::LoadedMesh mesh = mesh_file::loadMesh(file, scale);
  Body body{file.stem().string(), nullptr, mesh.report.remarks};
  body.surface = store::makeSurface(cache, std::move(mesh.mesh));
  return body;
}

/// Shell points with inward normals and areas, as PLY.
void writeShell(const shell::Pointshell& shell, const std::filesystem::path& file) {
  OutputFile out(file);
  out.stream() << "ply\nformat ascii 1.0\ncomment pointshell: inward normals, area in m^2\nelement vertex "
               << shell.size();
  for (const char* p : {"x", "y", "z", "nx", "ny", "nz", "area"}) out.stream() << "\nproperty float " << p;
  out.stream() << "\nend_header\n";
  for (std::size_t i = 0; i < shell.size(); ++i) {
    for (float v : {shell.x[i], shell.y[i], shell.z[i], shell.nx[i], shell.ny[i], shell.nz[i]})
      out.stream() << formatDouble(v) << ' ';
    out.stream() << formatDouble(shell.area[i]) << '\n';
  }
  out.commit();
}

void writeStructure(const structure::HapticStructure& s, OutputFolder& folder) {
  std::string stem = s.name;
  for (char& c : stem)
    if (c == ':' || c == ',' || c == '/') c = '_';
  mesh_file::saveMesh(s.surface->mesh(kDrawingSagitta), folder.place(stem + ".stl"));
  writeShell(s.shell, folder.place(stem + ".shell.ply"));
  store::saveStructure(s, folder.place(stem + ".structure"));
}

nlohmann::ordered_json structureJson(const store::MadeStructure& made, const Body& body) {
  const structure::HapticStructure& s = *made.structure;
  return {{"name", s.name},
          {"triangles", s.triangles},
          {"watertight", s.surface->watertight()},
          {"voxels", {s.grid.size.x(), s.grid.size.y(), s.grid.size.z()}},
          {"surface_voxels", s.surface_voxels},
          {"solid_voxels", s.solid_voxels},
          {"points", s.shell.size()},
          {"levels", s.tree.levels},
          {"memory_bytes", s.memoryBytes()},
          {"build_ms", s.build_ms},
          {"cached", made.cached},
          {"made_ms", made.made_ms},
          {"error_bound", s.errorBound()},
          {"covering_radius", s.shell.covering_radius},
          {"field", structure::fieldName(s.options.field)},
          {"volume", s.mass_properties.volume},
          {"remarks", body.remarks}};
}

std::string timeText(const store::MadeStructure& made) {
  if (!made.cached) return format("built in %.0f ms", made.structure->build_ms);
  return format("from the cache in %.0f ms (building took %.0f ms)", made.made_ms, made.structure->build_ms);
}

/// A body of unusual size may be in another unit: gives that hint if it cannot be built.
store::MadeStructure build(const CommandLine& line, const Body& body, const structure::HapticOptions& options,
                           store::StructureCache& cache) {
  try {
    return store::makeHapticStructure(cache, body.name, body.surface, options, 0, buildMonitor(line));
  } catch (const UsageError& e) {
    for (const auto& remark : body.remarks)
      if (remark.find("probably") != std::string::npos)
        throw UsageError(body.name + ": " + e.what() + "\nhint: " + remark + " (--scale)");
    throw UsageError(body.name + ": " + e.what());
  }
}

/// Output of the command.
struct BuildOutput {
  nlohmann::ordered_json document;
  std::string text;
  std::optional<OutputFolder> folder;  ///< of structures
};

/// Builds or explains one body; both add to the output.
void make(const CommandLine& line, const BuildArguments& args, const structure::HapticOptions& options,
          const std::string& name, store::StructureCache& cache, BuildOutput& output) {
  auto& [document, text, folder] = output;
  const Body body = load(name, number(args.scale, "--scale"), args.packages, cache);
  Said said;
  if (args.explain) {
    said = explain(body.name, body.surface, options, buildMonitor(line));
    document["explained"].push_back(said.json);
    text += said.text;
  } else {
    const store::MadeStructure made = build(line, body, options, cache);
    const structure::HapticStructure& s = *made.structure;
    if (folder) writeStructure(s, *folder);
    said = sayReport(store::reportOn(s));
    document["structures"].push_back(structureJson(made, body));
    document["structures"].back()["report"] = said.json;
    text += format("%s: %d x %d x %d voxels, %zu points, %zu triangles%s, error bound %.2f mm, %.1f MB, %s\n",
                   s.name.c_str(), s.grid.size.x(), s.grid.size.y(), s.grid.size.z(), s.shell.size(),
                   s.triangles, s.surface->watertight() ? "" : " (not watertight)", 1e3 * s.errorBound(),
                   static_cast<double>(s.memoryBytes()) * 1e-6, timeText(made).c_str());
    text += said.text;
  }
  for (const auto& remark : body.remarks) text += "  " + remark + "\n";
}

int runBuild(const CommandLine& line, const BuildArguments& args) {
  structure::HapticOptions options;
  options.voxel_size = number(args.voxel, "--voxel");
  options.point_spacing = number(args.point, "--point");
  options.outer_layers = args.outer_layers;
  options.field = *structure::parseFieldKind(args.field);
  options.validate();

  store::StructureCache cache(line.cache ? store::userCacheFolder() : std::filesystem::path());
  BuildOutput output;
  auto& [document, text, folder] = output;
  document[args.explain ? "explained" : "structures"] = nlohmann::ordered_json::array();
  if (args.explain) document["rules"] = explainRules();
  auto failed = nlohmann::ordered_json::array();
  if (!args.out.empty() && !args.explain) folder.emplace(args.out);
  for (const auto& name : args.meshes) {
    try {
      make(line, args, options, name, cache, output);
    } catch (const ParseError& e) {
      if (args.meshes.size() == 1) throw;
      std::cerr << e.what() << std::endl;
      failed.push_back({{"name", name}, {"error", e.what()}});
    }
    for (const auto& warning : cache.takeWarnings()) line.warn(warning);
  }
  if (folder && failed.size() < args.meshes.size()) folder->commit();
  if (!failed.empty()) document["failed"] = failed;
  if (args.explain)
    text += "* requested resolution. Predicted, nothing was built; method: abstand build --explain --json\n";
  line.print(document, text);
  if (failed.empty()) return kDone;
  return failed.size() == args.meshes.size() ? kBadInput : kPartly;
}

}  // namespace

void addBuild(CLI::App& root, CommandLine& line) {
  auto* command =
      addCommand(root, line, "build", "haptic structures (voxelmap, field, pointshell) of meshes and shapes",
                 "abstand build sphere:0.05 link1.stl --voxel 0.005 --point 0.005 --out structures");
  auto args = std::make_shared<BuildArguments>();
  command
      ->add_option("MESH", args->meshes,
                   "mesh files, or sphere:r, cuboid:x,y,z, ellipsoid:a,b,c, cylinder:r,l, capsule:r,l (m)")
      ->required();
  command->add_option("--voxel", args->voxel, "voxel size in m");
  command->add_option("--point", args->point, "pitch of the pointshell in m");
  command->add_option("--outer-layers", args->outer_layers, "layers of voxels outside the surface")
      ->check(CLI::Range(0, 10000));
  command->add_option("--field", args->field, "layered, float or mixed")
      ->check(CLI::IsMember({"layered", "float", "mixed"}));
  command->add_option("--scale", args->scale, "metres per unit of the mesh files");
  line.output(
      command->add_option("--out", args->out,
                          "folder for the mesh (STL), the pointshell (PLY) and the structure of each"),
      OutputKind::kFolder);
  command->add_flag("--explain", args->explain,
                    "predict error, memory, points, build time and query time of this and other resolutions, "
                    "without building");
  addPackagePath(command, args->packages);
  addCacheFlag(command, line);
  command->callback([&line, args] { line.run = [&line, args] { return runBuild(line, *args); }; });
}

}  // namespace abstand::cli
