// Every example of README.md and docs: its options are accepted, and where its files can be had it runs.
#include <algorithm>
#include <fstream>

#include "tests/app/program.hpp"

namespace abstand::testing {
namespace docs_examples_test {

namespace fs = std::filesystem;

/// A command line `abstand ...` of a block of code.
struct Example {
  std::string where;    ///< FILE:LINE
  std::string command;  ///< behind `abstand`
};

std::string trimmed(const std::string& s) {
  const auto begin = s.find_first_not_of(" \t&"), end = s.find_last_not_of(" \t&");
  return begin == std::string::npos ? "" : s.substr(begin, end - begin + 1);
}

/// Of one line, in a pipe perhaps several; without comments.
void addExamples(const std::string& line, const std::string& where, std::vector<Example>& out) {
  std::string rest = line.substr(0, line.find(" #"));
  while (!rest.empty()) {
    const auto bar = rest.find(" | ");
    const std::string one = trimmed(rest.substr(0, bar));
    rest = bar == std::string::npos ? "" : rest.substr(bar + 3);
    for (const std::string name : {"abstand ", "build/app/abstand "})
      if (one.compare(0, name.size(), name) == 0) out.push_back({where, one.substr(name.size())});
  }
}

/// Blocks between fences, and those that are indented by four spaces.
std::vector<Example> examplesOf(const fs::path& file) {
  std::vector<Example> out;
  std::ifstream in(file);
  bool fenced = false;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    const bool fence = trimmed(line).compare(0, 3, "```") == 0;
    if (fence) fenced = !fenced;
    if (!fence && (fenced || line.compare(0, 4, "    ") == 0))
      addExamples(line, file.filename().string() + ":" + std::to_string(number), out);
  }
  return out;
}

std::vector<Example> allExamples() {
  std::vector<fs::path> files{projectFile("README.md")};
  for (const auto& entry : fs::directory_iterator(projectFile("docs")))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin() + 1, files.end());
  std::vector<Example> all;
  for (const fs::path& file : files) {
    const auto some = examplesOf(file);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

bool begins(const std::string& s, const std::string& with) { return s.compare(0, with.size(), with) == 0; }

/// How an example is run here: with `added` arguments that make it short.
struct Plan {
  std::string prefix, added;
  int code{0};
  const char* not_run{nullptr};  ///< why not
};
const std::vector<Plan> kPlans{
    {"verify", "", 0, "minutes; test_verify checks it"},
    {"bench", "", 0, "minutes"},
    {"track live:kinect", "", 0, "needs a camera; test_fakenect has one"},
    {"check data/scenes/hug_boxing.yaml", "", 1},             // "exit code 1 when someone came closer"
    {"tune data/scenes/hug_reach.yaml --speed-rule", "", 1},  // "hands come too fast"
    {"run data/scenes/", " --end 0.02"},
    {"run ", " --end 0.1"},
    {"serve scene.yaml --stdin", " --duration 0.1 --bind 127.0.0.1:0 </dev/null"},
    {"serve ", " --duration 0.1 --bind 127.0.0.1:0"},
    {"render-depth ", " --end 0.7"},
    {"pairs ", " --samples 200"},
};
Plan planOf(const std::string& command) {
  for (const Plan& plan : kPlans)
    if (begins(command, plan.prefix)) return plan;
  return {};
}

/// A folder with the files that the examples name: the project's scenes with coarse bodies, which are built
/// in no time, and stand-ins for the user's files.
class DocsExamples : public Cli {
 protected:
  DocsExamples() {
    const fs::path home = folder_.path();
    fs::create_directories(home / "data");
    fs::create_directory_symlink(projectFile("data/robots"), home / "data/robots");
    fs::copy(projectFile("data/scenes"), home / "data/scenes", fs::copy_options::recursive);
    for (const auto& entry : fs::directory_iterator(home / "data/scenes"))
      if (entry.path().extension() == ".yaml") coarsen(entry.path());
    for (const char* name : {"a.bvh", "b.bvh", "boxing.bvh"})
      fs::copy(projectFile("data/scenes/hug_reach.bvh"), home / name);
    fs::copy(projectFile("data/robots/lwr/link1.stl"), home / "link1.stl");
    fs::copy(projectFile("data/robots/arm6"), home, fs::copy_options::recursive);
    fs::rename(home / "arm6.urdf", home / "robot.urdf");
    write("scene.yaml",
          "abstand: 1\ndefaults: {voxel: 0.02, point: 0.02}\nhumans:\n  - {name: operator, height: 1.75, "
          "recording: {file: a.bvh}}\nobjects:\n  - {name: ball, shape: {sphere: {radius: 0.1}}, "
          "pose: {xyz: [4, 4, 1]}}\npairs: {default: between_groups}\n");
    write("plan.yaml", "abstand_plan: 1\nscenes: [scene_with_robot.yaml]\nrecordings: [a.bvh, b.bvh]\n");
    write("reach_plan.yaml", "abstand_plan: 1\nscenes: [data/scenes/hug_reach.yaml]\nspeeds: [1, 1.5, 2]\n");
    write("scene_with_robot.yaml",
          "abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\nmechanisms:\n  - {name: arm, file: robot.urdf}\n"
          "humans:\n  - {name: operator, height: 1.75, recording: {file: a.bvh}}\n");
    write("kinect.yaml",
          "width: 640\nheight: 480\nfx: 580\nfy: 580\ncx: 319.5\ncy: 239.5\ndepth_scale: 1000\n");
    write("points.csv", "cx,cy,cz,wx,wy,wz\n0,0,1,2,2,3\n1,0,1,2,1,3\n0,1,1,2,2,2\n0,0,2,3,2,3\n");
    for (const char* name : {"gait.c3d", "walk.c3d"})
      if (const auto c3d = sharedData("mocap/c3d/sample09/PlugInC3D.c3d"); exists(c3d))
        fs::copy(c3d, home / name);
  }

  static void coarsen(const fs::path& scene) {
    std::string text = readFile(scene);
    for (const std::string fine : {"voxel: 0.005, point: 0.005", "voxel: 0.006, point: 0.006"})
      for (auto at = text.find(fine); at != std::string::npos; at = text.find(fine, at + 1))
        text.replace(at, fine.size(), "voxel: 0.04, point: 0.04");
    std::ofstream(scene) << text;
  }

  Answer here(const std::string& arguments) {
    const auto out = folder_.path() / "stdout", err = folder_.path() / "stderr";
    const std::string command = "cd '" + folder_.path().string() + "' && ABSTAND_CACHE='" +
                                (folder_.path() / "cache").string() + "' '" ABSTAND_PROGRAM "' " + arguments +
                                " >'" + out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out, 1 << 28, true),
            readFile(err, 1 << 20, true)};
  }
};

TEST_F(DocsExamples, UseKnownOptions) {
  const std::vector<Example> examples = allExamples();
  EXPECT_GE(examples.size(), 30u) << "are they found?";
  // An option that there cannot be is complained of last, after all else was understood, and alone.
  const std::string unknown = "--there-is-no-such-option";
  for (const Example& e : examples) {
    const Answer a = here(e.command + " " + unknown);
    EXPECT_EQ(a.code, 2) << e.where << ": abstand " << e.command;
    EXPECT_NE(a.err.find("not expected: " + unknown + "\n"), std::string::npos)
        << e.where << ": abstand " << e.command << "\n"
        << a.err;
  }
}

TEST_F(DocsExamples, RunAsWritten) {
  std::size_t ran = 0;
  for (const Example& e : allExamples()) {
    const Plan plan = planOf(e.command);
    if (plan.not_run) continue;
    // The help of the commands, whose files are inventions; that its options are right is tested above.
    if (begins(e.where, "reference.md:")) continue;
    if (e.command.find(".c3d") != std::string::npos && !exists(folder_.path() / "gait.c3d")) continue;
    // Placeholders of the text, like CLIP.
    if (e.command.find("CLIP") != std::string::npos) continue;
    const Answer a = here(e.command + plan.added);
    EXPECT_EQ(a.code, plan.code) << e.where << ": abstand " << e.command << plan.added << "\n" << a.err;
    ++ran;
  }
  EXPECT_GE(ran, 20u);
}

}  // namespace docs_examples_test
}  // namespace abstand::testing
