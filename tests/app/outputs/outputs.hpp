// A folder with a small input of every kind, in which the program runs from a shell.
#pragma once

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>
#include <set>

#include "tests/app/program.hpp"

namespace abstand::testing {

namespace fs = std::filesystem;

inline const char* const kScene = R"(abstand: 1
defaults: {voxel: 0.05, point: 0.05}
mechanisms:
  - name: slide
    file: slide.mech
    motion: slide.csv
    links: [{name: cart, frame: 1, shape: {sphere: {radius: 0.1}}}]
objects:
  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-0.5, 0, 0]}}
)";
inline const char* const kSlide = "chain\n    frame   1   0      0          d    0\nend_chain\n";
inline const char* const kUrdf = R"(<robot name="pair">
  <link name="a"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="b"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="c"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="ab" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="9" velocity="1"/></joint>
  <joint name="bc" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0 0 0.5"/></joint>
</robot>
)";

class Outputs : public Cli {
 protected:
  Outputs() {
    write("scene.yaml", kScene);
    write("slide.mech", kSlide);
    write("slide.csv", "t,q0\n0,0\n0.01,0.001\n0.02,0.002\n");
    write("pair.urdf", kUrdf);
    write("camera.yaml",
          "width: 640\nheight: 480\nfx: 580\nfy: 580\ncx: 319.5\ncy: 239.5\ndepth_scale: 1000\n");
    write("points.csv", "cx,cy,cz,wx,wy,wz\n0,0,1,0,0,1\n1,0,1,1,0,1\n0,1,2,0,1,2\n1,1,1,1,1,1\n");
    write("person.csv",
          "t,pelvis.x,pelvis.y,pelvis.z,pelvis.confidence,neck.x,neck.y,neck.z,neck.confidence\n"
          "0,0,0,1,1,0,0,1.5,1\n0.1,0,0,1,1,0,0,1.5,1\n");
  }

  fs::path in(const std::string& name) const { return folder_.path() / name; }

  /// Runs lines of the shell in the scratch folder; $ABSTAND is the program.
  Answer shell(const std::string& script) {
    const auto out = in("shell.out"), err = in("shell.err");
    const std::string text =
        "cd '" + folder_.path().string() + "' && ABSTAND='" ABSTAND_PROGRAM "'; " + script;
    std::ofstream(in("script.sh")) << text;
    const int status = std::system(
        ("sh '" + in("script.sh").string() + "' >'" + out.string() + "' 2>'" + err.string() + "'").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out, 1 << 28, true),
            readFile(err, 1 << 20, true)};
  }
  Answer run(const std::string& command) { return shell("\"$ABSTAND\" " + command); }

  /// A device of the test's own, so that a fault does not break the machine; skips where only root may make
  /// one.
  static bool makeDevice(const fs::path& file, unsigned minor_number) {
    return ::mknod(file.c_str(), S_IFCHR | 0666, makedev(1, minor_number)) == 0 &&
           std::ofstream(file).is_open();
  }
  static constexpr unsigned kNull = 3, kFull = 7;

  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& e : fs::recursive_directory_iterator(folder_.path())) {
      const std::string name = e.path().filename().string();
      if (!name.starts_with("shell.") && name != "script.sh") found.insert(name);
    }
    return found;
  }

  static bool isOneLine(const std::string& text) { return std::count(text.begin(), text.end(), '\n') == 1; }

  /// The folder "clip" of one depth image of a person, as small as a person is found in.
  void makeClip() {
    const Answer a = run("render-depth --recording '" + projectFile("data/scenes/hug_reach.bvh").string() +
                         "' --out clip --width 320 --end 0 --noise none");
    ASSERT_EQ(a.code, 0) << a.err;
  }

  /// The folder "study" of `tune --out` with one result, made once.
  void makeStudy() {
    static std::string result;
    if (result.empty()) {
      write("study.yaml", std::string(kScene) + "humans: [{name: person, recording: {file: person.csv}}]\n");
      const Answer a = run("tune study.yaml --out made");
      ASSERT_EQ(a.code, 0) << a.err;
      for (const auto& entry : fs::directory_iterator(in("made/results"))) result = readFile(entry.path());
      fs::remove_all(in("made"));
    }
    fs::create_directories(in("study/results"));
    write("study/results/one.h5", result);
  }

  /// The folder "peer" of a scene of the peer benchmark: two tetrahedra in one frame.
  void makePeerScene() {
    fs::create_directory(in("peer"));
    write(
        "peer/scenario.json",
        R"({"objects": [{"name": "a", "mesh": "a.obj"}, {"name": "b", "mesh": "a.obj"}], "pairs": [[0, 1]]})");
    write("peer/a.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    write("peer/poses.csv", "1,0,0,0,0,1,0,0,0,0,1,0,1,0,0,0.2,0,1,0,0,0,0,1,0\n");
  }
};

}  // namespace abstand::testing
