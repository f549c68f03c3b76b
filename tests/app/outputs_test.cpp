// Every output option of every command, given what stands where no plain file does: a directory, a device, a
// pipe, a link, the input itself, a full disk; and standard output that takes nothing.
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <fstream>

#include "tests/app/program.hpp"

namespace abstand::testing {
namespace {

namespace fs = std::filesystem;

const char* kScene = R"(abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    motion: slide.csv
    links: [{name: cart, frame: 1, shape: {sphere: {radius: 0.1}}}]
objects:
  - {name: wall, shape: {cuboid: {size: [0.2, 1, 1]}}, pose: {xyz: [-0.5, 0, 0]}}
)";
const char* kSlide = "chain\n    frame   1   0      0          d    0\nend_chain\n";
const char* kUrdf = R"(<robot name="pair">
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

/// An output option: what stands before it, and the file that the command reads.
struct Output {
  std::string name;
  std::string command;  ///< $IN stands for the input
  std::string option;   ///< empty: the output is a positional argument
  std::string input;    ///< file in the scratch folder
  std::string ending{};
};

const std::vector<Output> kFiles{
    {"skeleton out", "skeleton $IN", "--out", "person.csv"},
    {"skeleton write", "skeleton $IN", "--write", "person.csv"},
    {"run pairs", "run $IN", "--pairs-out", "scene.yaml"},
    {"run objects", "run $IN", "--objects-out", "scene.yaml"},
    {"run joints", "run $IN", "--joints-out", "scene.yaml"},
    {"run session", "run $IN", "--session", "scene.yaml"},
    {"check junit", "check $IN --min-distance 0.01", "--junit", "scene.yaml"},
    {"check report", "check $IN --min-distance 0.01", "--report", "scene.yaml"},
    {"pairs out", "pairs $IN --voxel 0.05 --samples 20 --searches 0", "--out", "pair.urdf"},
    {"pairs srdf", "pairs $IN --voxel 0.05 --samples 20 --searches 0", "--srdf", "pair.urdf"},
    {"convert", "convert $IN --postures 2", "", "pair.urdf", ".urdf"},
    {"dynamics", "dynamics pair.urdf --motion $IN", "--out", "slide.csv"},
    {"calibrate", "calibrate points.csv --camera $IN", "--out", "camera.yaml"},
    {"verify", "verify --only 'third law' --poses 20", "--report", ""},
};

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

  std::string commandOf(const Output& o, const std::string& to) const {
    std::string command = o.command;
    if (const auto at = command.find("$IN"); at != std::string::npos)
      command.replace(at, 3, "'" + o.input + "'");
    return command + " " + o.option + " '" + to + "'";
  }

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
};

bool isOneLine(const std::string& text) { return std::count(text.begin(), text.end(), '\n') == 1; }

TEST_F(Outputs, ADirectoryIsWrongUsageAndStays) {
  for (const Output& o : kFiles) {
    const std::string to = "folder" + o.ending;
    fs::create_directory(in(to));
    const auto before = names();
    const Answer a = run(commandOf(o, to));
    EXPECT_EQ(a.code, 2) << o.name << ": " << a.err;
    EXPECT_TRUE(isOneLine(a.err)) << o.name << ": " << a.err;
    EXPECT_EQ(names(), before) << o.name;
    const Answer nowhere = run(commandOf(o, "no/where" + o.ending));
    EXPECT_EQ(nowhere.code, 2) << o.name << nowhere.err;
    EXPECT_EQ(names(), before) << o.name;
  }
}

TEST_F(Outputs, TheInputItselfIsWrongUsageAndStays) {
  for (const Output& o : kFiles) {
    if (o.input.empty()) continue;
    const std::string before = readFile(in(o.input));
    fs::remove(in("alias" + o.ending));
    fs::create_symlink(o.input, in("alias" + o.ending));
    fs::remove(in("hard" + o.ending));
    fs::create_hard_link(in(o.input), in("hard" + o.ending));
    for (const std::string& to : {o.input, "./" + o.input, "alias" + o.ending, "hard" + o.ending}) {
      const Answer a = run(commandOf(o, to));
      EXPECT_EQ(a.code, 2) << o.name << " " << to << a.err;
      EXPECT_NE(a.err.find("input"), std::string::npos) << o.name << ": " << a.err;
      EXPECT_EQ(readFile(in(o.input)), before) << o.name << " " << to;
    }
  }
}

TEST_F(Outputs, AFileThatASceneReadsIsAnInputToo) {
  const std::string before = readFile(in("slide.csv"));
  for (const char* option : {"--pairs-out", "--session"}) {
    const Answer a = run(std::string("run scene.yaml ") + option + " slide.csv");
    EXPECT_EQ(a.code, 2) << a.err;
  }
  EXPECT_EQ(run("check scene.yaml --min-distance 0.01 --junit slide.csv").code, 2);
  EXPECT_EQ(readFile(in("slide.csv")), before);
}

TEST_F(Outputs, TwoOutputsOfOneNameAreWrongUsage) {
  const auto before = names();
  for (const char* both :
       {"run scene.yaml --pairs-out a --objects-out a", "run scene.yaml --pairs-out a --session ./a",
        "check scene.yaml --min-distance 0.01 --junit a --report a", "skeleton person.csv --out a --write a",
        "pairs pair.urdf --out a --srdf a",
        "build sphere:0.1 sphere:0.1 --voxel 0.05 --point 0.05 --out a"}) {
    const Answer a = run(both);
    EXPECT_EQ(a.code, 2) << both << a.err;
    EXPECT_EQ(names(), before) << both;
  }
}

TEST_F(Outputs, ALinkIsFollowed) {
  fs::create_directory(in("else"));
  for (const Output& o : kFiles) {
    const std::string link = "link" + o.ending, target = "else/target" + o.ending;
    for (const bool is_there : {false, true}) {
      fs::remove(in(link));
      fs::remove(in(target));
      fs::create_symlink(target, in(link));
      if (is_there) {
        if (o.option == "--srdf") continue;  // what is there must be an SRDF
        write(target, "old");
        fs::permissions(in(target), fs::perms::owner_read | fs::perms::owner_write);
      }
      const Answer a = run(commandOf(o, link));
      EXPECT_EQ(a.code, 0) << o.name << ": " << a.err;
      EXPECT_TRUE(fs::is_symlink(in(link))) << o.name;
      EXPECT_GT(fs::file_size(in(target)), 3u) << o.name;
      if (is_there) {
        EXPECT_EQ(fs::status(in(target)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
      }
    }
  }
}

TEST_F(Outputs, ADeviceIsWrittenInto) {
  for (const Output& o : kFiles) {
    const std::string device = "device" + o.ending;
    fs::remove(in(device));
    if (!makeDevice(in(device), kNull)) GTEST_SKIP() << "no device can be made here";
    const auto before = names();
    const Answer a = run(commandOf(o, device));
    EXPECT_EQ(a.code, 0) << o.name << ": " << a.err;
    EXPECT_TRUE(fs::is_character_file(in(device))) << o.name;
    EXPECT_EQ(names(), before) << o.name;
  }
}

TEST_F(Outputs, APipeGetsTheSameBytes) {
  for (const Output& o : kFiles) {
    const std::string pipe = "pipe" + o.ending, plain = "plain" + o.ending;
    ASSERT_EQ(::mkfifo(in(pipe).c_str(), 0600), 0);
    const Answer a = shell("timeout 20 cat '" + pipe + "' >got & \"$ABSTAND\" " + commandOf(o, pipe) +
                           "; code=$?; wait; exit $code");
    EXPECT_EQ(a.code, 0) << o.name << ": " << a.err;
    EXPECT_TRUE(fs::is_fifo(in(pipe))) << o.name;
    EXPECT_EQ(run(commandOf(o, plain)).code, 0) << o.name;
    // An HDF5 file and a page hold the time at which they were made.
    if (o.option == "--session" || o.option == "--report") {
      EXPECT_GT(fs::file_size(in("got")), 100u) << o.name;
    } else {
      EXPECT_EQ(readFile(in("got")), readFile(in(plain))) << o.name;
    }
    for (const std::string& used : {pipe, plain, std::string("got")}) fs::remove(in(used));
  }
}

TEST_F(Outputs, StandardOutputAndDescriptorsOfTheShell) {
  ASSERT_EQ(run("skeleton person.csv --out plain").code, 0);
  const std::string plain = readFile(in("plain"));
  // The report goes to stderr, so that what comes through is the file alone.
  const Answer out = run("skeleton person.csv --out /dev/stdout");
  EXPECT_EQ(out.code, 0);
  EXPECT_EQ(out.out, plain);
  EXPECT_NE(out.err.find("stature"), std::string::npos);
  EXPECT_EQ(shell("\"$ABSTAND\" skeleton person.csv --out /dev/stdout | cat").out, plain);
  EXPECT_EQ(run("skeleton person.csv --out /dev/fd/7 7>seven").code, 0);
  EXPECT_EQ(readFile(in("seven")), plain);
  EXPECT_EQ(run("skeleton person.csv --json --out /dev/stdout").code, 2);
}

TEST_F(Outputs, AFullDiskIsFourAndNothingIsLeft) {
  for (const Output& o : kFiles) {
    const auto before = names();
    const std::string to = "out" + o.ending;
    // Files may have no byte; stderr is a pipe, which has no such limit.
    const Answer a = shell("text=$(ulimit -f 0; \"$ABSTAND\" " + commandOf(o, to) +
                           " --quiet 2>&1); code=$?; echo \"$text\"; exit $code");
    EXPECT_EQ(a.code, 4) << o.name << ": " << a.out;
    EXPECT_TRUE(isOneLine(a.out)) << o.name << ": " << a.out;
    EXPECT_NE(a.out.find(to), std::string::npos) << o.name << ": " << a.out;
    EXPECT_EQ(names(), before) << o.name;
  }
}

TEST_F(Outputs, AFullDeviceIsFour) {
  for (const Output& o : kFiles) {
    const std::string device = "full" + o.ending;
    fs::remove(in(device));
    if (!makeDevice(in(device), kFull)) GTEST_SKIP() << "no device can be made here";
    const auto before = names();
    const Answer a = run(commandOf(o, device) + " --quiet");
    EXPECT_EQ(a.code, 4) << o.name << ": " << a.err;
    EXPECT_TRUE(isOneLine(a.err)) << o.name << ": " << a.err;
    EXPECT_TRUE(fs::is_character_file(in(device))) << o.name;
    EXPECT_EQ(names(), before) << o.name;
  }
}

TEST_F(Outputs, ASessionLogSurvivesADiskThatFillsUp) {
  // Limits within the header, within the data, and shortly before the end.
  ASSERT_EQ(run("run scene.yaml --session whole.h5").code, 0);
  const auto bytes = fs::file_size(in("whole.h5"));
  for (std::uintmax_t blocks = 1; blocks * 512 < bytes; blocks += 3) {
    const Answer a = shell(
        "text=$(ulimit -f " + std::to_string(blocks) +
        "; \"$ABSTAND\" run scene.yaml --quiet --session x.h5 2>&1); code=$?; echo \"$text\"; exit $code");
    EXPECT_EQ(a.code, 4) << blocks << a.out;
    EXPECT_TRUE(isOneLine(a.out)) << a.out;
    EXPECT_FALSE(fs::exists(in("x.h5")));
  }
}

TEST_F(Outputs, SetsOfFilesAppearWholeOrNotAtAll) {
  const std::vector<std::string> sets{
      "human --height 1.8", "build sphere:0.1 cuboid:0.2,0.2,0.2 --voxel 0.05 --point 0.05",
      "render-depth scene.yaml --width 320 --noise none --eye 2,0,0.5 --look 0,0,0"};
  for (const std::string& set : sets) {
    const auto before = names();
    // Enough for the first files of the set, not for all.
    for (const int blocks : {0, 1}) {
      const Answer a = shell("text=$(ulimit -f " + std::to_string(blocks) + "; \"$ABSTAND\" " + set +
                             " --quiet --out deep/set 2>&1); code=$?; echo \"$text\"; exit $code");
      EXPECT_EQ(a.code, 4) << set << a.out;
      EXPECT_TRUE(isOneLine(a.out)) << set << a.out;
      EXPECT_EQ(names(), before) << set;
    }
    const Answer file = run(set + " --out person.csv");
    EXPECT_EQ(file.code, 2) << set << file.err;
    EXPECT_EQ(names(), before) << set;
    // A folder that is there keeps its other files; one behind a link is that folder.
    fs::create_directory(in("real"));
    write("real/mine", "kept");
    fs::create_symlink("real", in("linked"));
    EXPECT_EQ(run(set + " --out linked").code, 0) << set;
    EXPECT_TRUE(fs::is_symlink(in("linked")));
    EXPECT_EQ(readFile(in("real/mine")), "kept");
    EXPECT_GT(std::distance(fs::directory_iterator(in("real")), fs::directory_iterator()), 2) << set;
    EXPECT_EQ(run(set + " --out deep/set").code, 0) << set;
    EXPECT_EQ(std::distance(fs::directory_iterator(in("deep/set")), fs::directory_iterator()),
              std::distance(fs::directory_iterator(in("real")), fs::directory_iterator()) - 1)
        << set;
    for (const char* used : {"real", "linked", "deep"}) fs::remove_all(in(used));
  }
}

TEST_F(Outputs, AMeshIsNotReplacedByItsOwnStructures) {
  ASSERT_EQ(run("build sphere:0.1 --voxel 0.05 --point 0.05 --out set").code, 0);
  const std::string before = readFile(in("set/sphere_0.1.stl"));
  const Answer a = run("build set/sphere_0.1.stl --scale 2 --voxel 0.05 --point 0.05 --out set");
  EXPECT_EQ(a.code, 2) << a.err;
  EXPECT_EQ(readFile(in("set/sphere_0.1.stl")), before);
}

TEST_F(Outputs, FullStandardOutputIsFour) {
  for (const char* command :
       {"fk slide.mech", "build sphere:0.1 --voxel 0.05 --point 0.05", "human --height 1.8",
        "skeleton person.csv", "run scene.yaml", "check scene.yaml --min-distance 0.01",
        "check scene.yaml --dry-run", "pairs pair.urdf --voxel 0.05 --samples 20 --searches 0",
        "convert pair.urdf new.urdf --postures 2", "dynamics pair.urdf",
        "calibrate points.csv --camera camera.yaml", "verify --only 'third law' --poses 20", "bench fk",
        "serve scene.yaml --layout", "serve scene.yaml --bind 127.0.0.1:0 --duration 0",
        "render-depth scene.yaml --width 320 --noise none --eye 2,0,0.5 --look 0,0,0 --out clip"}) {
    for (const char* json : {"", " --json"}) {
      const Answer a = run(std::string(command) + json + " >/dev/full");
      EXPECT_EQ(a.code, 4) << command << json << a.err;
      EXPECT_NE(a.err.find("standard output"), std::string::npos) << command << json << a.err;
    }
  }
  for (const char* command : {"--help", "--version", "run --help"})
    EXPECT_EQ(run(std::string(command) + " >/dev/full").code, 4) << command;
  EXPECT_EQ(run("fk slide.mech >&-").code, 4);
  EXPECT_EQ(run("fk slide.mech --quiet >&-").code, 0);
  // No output file gets the number of a closed standard output, and with it the report.
  EXPECT_EQ(run("skeleton person.csv --out plain").code, 0);
  EXPECT_EQ(run("skeleton person.csv --out closed >&- 2>&-").code, 4);
  EXPECT_EQ(readFile(in("closed")), readFile(in("plain")));
}

TEST_F(Outputs, SignalsEndLikeCtrlC) {
  // So long a motion that nothing ends by itself.
  write("slide.csv", "t,q0\n0,0\n100000,0.002\n");
  const auto before = names();
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const Answer a =
        shell(std::string("sh -c 'trap - INT; exec \"$0\" run scene.yaml --rate 1000 --json --pairs-out "
                          "pairs.csv --session log.h5' \"$ABSTAND\" & pid=$!; while [ -z \"$(ls | grep "
                          "part)\" ]; do sleep 0.05; done; sleep 0.5; kill -") +
              signal + " $pid; wait $pid; exit $?");
    EXPECT_EQ(a.code, 130) << signal << a.err;
    const json j = json::parse(a.out, nullptr, false);
    ASSERT_TRUE(j.is_object()) << signal << a.out;
    EXPECT_EQ(j["interrupted"], true);
    EXPECT_GT(j["frames"].get<long>(), 0);
    // What was done is readable.
    EXPECT_GT(readFile(in("pairs.csv")).size(), 100u);
    EXPECT_EQ(readFile(in("log.h5")).substr(1, 3), "HDF");
    for (const char* used : {"pairs.csv", "log.h5"}) fs::remove(in(used));
    EXPECT_EQ(names(), before) << signal;
  }
}

// timeout(1) signals its child and then its process group, so that the child gets the signal twice.
TEST_F(Outputs, ASignalSentTwiceAtOnceIsOne) {
  write("slide.csv", "t,q0\n0,0\n100000,0.002\n");
  const Answer a = shell(
      "\"$ABSTAND\" run scene.yaml --rate 1000 --json --pairs-out pairs.csv & pid=$!; while [ -z \"$(ls | "
      "grep part)\" ]; do sleep 0.05; done; sleep 0.2; kill -TERM $pid; sleep 0.01; kill -TERM $pid; wait "
      "$pid; exit $?");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
  EXPECT_TRUE(fs::exists(in("pairs.csv")));
}

TEST_F(Outputs, APipeWithoutAReaderCanBeInterrupted) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  const Answer a = shell(
      "\"$ABSTAND\" skeleton person.csv --json --out pipe & pid=$!; sleep 0.5; kill -TERM $pid; wait $pid; "
      "exit $?");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
}

TEST_F(Outputs, PipesAreNoInputs) {
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

TEST_F(Outputs, MessagesArePlainWhateverAFileHolds) {
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

TEST_F(Outputs, AnSrdfKeepsWhatOthersWrote) {
  const std::string hand_made = R"(<?xml version="1.0"?>
<!-- made by hand -->
<robot name="pair">
  <group name="arm"><chain base_link="a" tip_link="c"/></group>
  <group_state name="home" group="arm"><joint name="ab" value="0.5"/></group_state>
  <disable_collisions link1="a" link2="b" reason="Default"/>
  <disable_collisions link1="c" link2="a" reason="User"/>
</robot>
)";
  write("pair.srdf", hand_made);
  const Answer a = run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf pair.srdf");
  ASSERT_EQ(a.code, 0) << a.err;
  const std::string text = readFile(in("pair.srdf"));
  for (const char* kept :
       {"<!-- made by hand -->", "<group name=\"arm\"><chain base_link=\"a\" tip_link=\"c\"/></group>",
        "<group_state name=\"home\"", "<disable_collisions link1=\"c\" link2=\"a\" reason=\"User\"/>"})
    EXPECT_NE(text.find(kept), std::string::npos) << text;
  EXPECT_EQ(text.find("Default"), std::string::npos) << text;
  EXPECT_NE(text.find("link1=\"a\" link2=\"b\" reason=\"Adjacent\""), std::string::npos) << text;
  // Once more changes nothing.
  ASSERT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf pair.srdf").code, 0);
  EXPECT_EQ(readFile(in("pair.srdf")), text);
  write("other.srdf", "<robot name=\"other\">\n</robot>\n");
  EXPECT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf other.srdf").code, 3);
  write("none.srdf", "my notes\n");
  EXPECT_EQ(run("pairs pair.urdf --voxel 0.05 --samples 20 --searches 0 --srdf none.srdf").code, 3);
  EXPECT_EQ(readFile(in("none.srdf")), "my notes\n");
}

}  // namespace
}  // namespace abstand::testing
