// Standard output as the place of a file, and standard output that takes nothing.
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace standard_output_test {

TEST_F(Outputs, WritesToStandardOutputAndDescriptors) {
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

TEST_F(Outputs, FullStandardOutputExitsWith4) {
  for (const char* command :
       {"fk slide.mech", "build sphere:0.1 --voxel 0.05 --point 0.05", "human --height 1.8",
        "skeleton person.csv", "run scene.yaml", "check scene.yaml --min-distance 0.01",
        "check scene.yaml --dry-run", "pairs pair.urdf --voxel 0.05 --samples 20 --searches 0",
        "convert pair.urdf new.urdf --postures 2", "dynamics pair.urdf",
        "calibrate points.csv --camera camera.yaml", "verify --quick --only continuity --poses 1", "bench fk",
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

}  // namespace standard_output_test
}  // namespace abstand::testing
