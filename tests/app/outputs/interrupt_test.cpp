// Signals end a command like Ctrl-C: it reports what was done so far.
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace {

/// So long a motion that nothing ends by itself.
constexpr const char* kLongMotion = "t,q0\n0,0\n5000,0.002\n";

class Interrupts : public Outputs {
 protected:
  /// Runs the program until it has worked for a while, and sends it the signal.
  Answer interrupt(const std::string& command, const char* signal = "INT") {
    // Shells let what runs in the background ignore SIGINT. Field 14 is the processor time in 1/100 s.
    return shell("sh -c 'trap - INT; exec \"$0\" \"$@\"' \"$ABSTAND\" " + command +
                 " & pid=$!; while [ \"$(cut -d' ' -f14 /proc/$pid/stat)\" -lt 100 ]; do sleep 0.05; done; "
                 "kill -" +
                 signal + " $pid; wait $pid; exit $?");
  }
};

TEST_F(Interrupts, SignalsEndLikeCtrlC) {
  write("slide.csv", kLongMotion);
  const auto before = names();
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const Answer a =
        interrupt("run scene.yaml --rate 1000 --json --pairs-out pairs.csv --session log.h5", signal);
    EXPECT_EQ(a.code, 130) << signal << a.err;
    const json j = json::parse(a.out, nullptr, false);
    ASSERT_TRUE(j.is_object()) << signal << a.out;
    EXPECT_EQ(j["interrupted"], true);
    EXPECT_GT(j["frames"].get<long>(), 0);
    // What was done is readable.
    EXPECT_GT(readFile(in("pairs.csv")).size(), 100u);
    EXPECT_EQ(readFile(in("log.h5"), 1 << 30).substr(1, 3), "HDF");
    for (const char* used : {"pairs.csv", "log.h5"}) fs::remove(in(used));
    EXPECT_EQ(names(), before) << signal;
  }
}

// timeout(1) signals its child and then its process group, so that the child gets the signal twice.
TEST_F(Interrupts, ASignalSentTwiceAtOnceIsOne) {
  write("slide.csv", kLongMotion);
  const Answer a = interrupt("run scene.yaml --rate 1000 --json --pairs-out pairs.csv",
                             "TERM $pid; sleep 0.01; kill -TERM");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
  EXPECT_TRUE(fs::exists(in("pairs.csv")));
}

TEST_F(Interrupts, APipeWithoutAReaderCanBeInterrupted) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  const Answer a = shell(
      "\"$ABSTAND\" skeleton person.csv --json --out pipe & pid=$!; sleep 0.5; kill -TERM $pid; wait $pid; "
      "exit $?");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
}

}  // namespace
}  // namespace abstand::testing
