// What is said of bad inputs, whatever they hold.
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace messages_test {

/// Whether a terminal shows it as it is: no control character but the end of a line, no line without end.
::testing::AssertionResult isPlain(const std::string& text) {
  std::size_t line = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '\n')
      line = 0;
    else if (c < 0x20 || c == 0x7f)
      return ::testing::AssertionFailure() << "control character " << int{c} << " at " << i;
    else if (++line > 20'000)
      return ::testing::AssertionFailure() << "a line of more than 20000 bytes";
  }
  return ::testing::AssertionSuccess();
}

TEST_F(Outputs, RejectsPipesAsInput) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", in("pipe.stl"));
  fs::create_symlink("pipe", in("pipe.mech"));
  for (const char* command : {"skeleton pipe", "track pipe", "run pipe", "fk pipe.mech", "build pipe.stl",
                              "run scene.yaml --poses pipe", "dynamics pair.urdf --motion pipe",
                              "calibrate pipe --camera camera.yaml", "calibrate points.csv --camera pipe",
                              "render-depth --recording pipe --out clip"}) {
    const Answer a = run(command);
    EXPECT_EQ(a.code, 3) << command << a.err;
    EXPECT_NE(a.err.find("pipe"), std::string::npos) << command << a.err;
  }
}

TEST_F(Outputs, MessagesEscapeControlCharacters) {
  const std::string escape = "\x1b]0;title\x07\x1b[31m\xc2\x9b\xff", word = std::string(1 << 20, 'w');
  for (const std::string& bad : {escape, escape + word}) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"run", write("a.yaml", "abstand: 1\n" + bad + ": 1\n")},
        {"run", write("b.yaml", "abstand: 1\nobjects: [{name: \"a\", mesh: \"" + bad + "\"}]\n")},
        {"run", write("c.yaml", "abstand: 1\nobjects:\n  - {name: x, shape: {" + bad + ": {radius: 1}}}\n")},
        {"check --dry-run",
         write("d.yaml", "abstand: 1\nmechanisms: [{name: m, file: \"" + bad + ".mech\"}]\n")},
        {"fk", write("e.mech", "chain\n frame " + bad + " 0 0\nend_chain\n")},
        {"fk", write("f.mech", bad + "\n")},
        {"fk",
         write("g.urdf", "<robot name=\"" + bad + "\"><link name=\"" + bad + "\"/><joint name=\"j\" type=\"" +
                             bad + "\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>")},
        {"fk", write("h.urdf", "<robot name=\"r\"><" + bad + "></robot>")},
        {"build", write("i.obj", "v 0 0 " + bad + "\n")},
        {"build", write("j.stl", "solid " + bad + "\n facet " + bad + "\n")},
        {"build", write("k.ply", "ply\nformat " + bad + " 1.0\n")},
        {"build", write("l.off", "OFF\n" + bad + "\n")},
        {"build", write("m.dae", "<COLLADA><asset/><" + bad + "/></COLLADA>")},
        {"build", write("n." + escape.substr(2, 5), bad)},
        {"skeleton", write("o.bvh", "HIERARCHY\nROOT " + bad + "\n{\n OFFSET 0 0 " + bad + "\n")},
        {"skeleton", write("p.csv", "t," + bad + ".x," + bad + ".y," + bad + ".z\n0,1,2,3\n")},
        {"skeleton", write("q.trc", "PathFileType\t4\t(X/Y/Z)\t" + bad + "\nDataRate\t" + bad + "\n")},
        {"skeleton", write("r.json", "{\"" + bad + "\": [" + bad)},
        {"skeleton", write("s.amc", ":FULLY-SPECIFIED\n1\n" + bad + " 1 2 3\n")},
        {"skeleton", write("t.txt", bad)},
        {"calibrate points.csv --camera", write("u.yaml", "width: " + bad + "\n")},
        {"run scene.yaml --poses", write("v.csv", "t," + bad + ".r00\n0,1\n")},
        {"check scene.yaml --min-distance 0 --margins", write("w.yaml", bad + ": 0.1\n")},
        {"dynamics pair.urdf --motion", write("x.csv", "t,q0\n0," + bad + "\n")},
        {"pairs", write("y.yaml", "abstand: 1\npairs: {file: \"" + bad + "\"}\n")},
    };
    for (const auto& [command, file] : files) {
      const Answer a = run(command + " '" + file + "'");
      const std::string name = command + " " + fs::path(file).filename().string();
      EXPECT_TRUE(isPlain(a.err)) << name;
      EXPECT_TRUE(isPlain(a.out)) << name;
      EXPECT_LE(std::count(a.err.begin(), a.err.end(), '\n'), 3) << name << a.err.substr(0, 2000);
    }
  }
  for (const char* bad :
       {"fk \"$(printf '\\033[31m').mech\"", "run \"$(printf '\\033[31m')\"", "\"$(printf '\\033[31m')\""})
    EXPECT_TRUE(isPlain(run(bad).err)) << bad;
}

}  // namespace messages_test
}  // namespace abstand::testing
