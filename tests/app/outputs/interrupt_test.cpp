// Signals end a command like Ctrl-C: it reports what was done so far.
#include "app/hdf5/table_reader.hpp"
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace interrupt_test {

/// So long a motion that nothing ends by itself.
constexpr const char* kLongMotion = "t,q0\n0,0\n5000,0.002\n";

class Interrupts : public Outputs {
 protected:
  /// Runs the program until it has used this much processor time, in 1/100 s, and sends it the signal.
  Answer interrupt(const std::string& command, const char* signal = "INT", int ticks = 100) {
    // Shells let what runs in the background ignore SIGINT. Field 14 is the processor time in 1/100 s.
    return shell("sh -c 'trap - INT; exec \"$0\" \"$@\"' \"$ABSTAND\" " + command +
                 " & pid=$!; while [ \"$(cut -d' ' -f14 /proc/$pid/stat)\" -lt " + std::to_string(ticks) +
                 " ]; do sleep 0.05; done; kill -" + signal + " $pid; wait $pid; exit $?");
  }

  /// The same for a command that runs frames: later, where a slow build was still loading when the signal
  /// came.
  Answer interruptFrames(const std::string& command, const char* signal = "INT") {
    constexpr int kLongestLoad = 1600;
    for (int ticks = 100;; ticks *= 2) {
      Answer a = interrupt(command, signal, ticks);
      if (ticks >= kLongestLoad || a.code != 130 || a.out.find("before the first frame") == std::string::npos)
        return a;
    }
  }
};

TEST_F(Interrupts, SignalsActLikeCtrlC) {
  write("slide.csv", kLongMotion);
  const auto before = names();
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const Answer a =
        interruptFrames("run scene.yaml --rate 1000 --json --pairs-out pairs.csv --session log.h5", signal);
    EXPECT_EQ(a.code, 130) << signal << a.err;
    const json j = json::parse(a.out, nullptr, false);
    ASSERT_TRUE(j.is_object()) << signal << a.out;
    EXPECT_EQ(j["interrupted"], true);
    EXPECT_EQ(j["reservations"].back()["kind"], "interrupted") << j["reservations"];
    EXPECT_GT(j["frames"].get<long>(), 0);
    // What was done is readable.
    EXPECT_GT(readFile(in("pairs.csv")).size(), 100u);
    EXPECT_EQ(hdf5::TableReader(in("log.h5")).extents("t").rows, j["frames"].get<std::size_t>());
    for (const char* used : {"pairs.csv", "log.h5"}) fs::remove(in(used));
    EXPECT_EQ(names(), before) << signal;
  }
}

// timeout(1) signals its child and then its process group, so that the child gets the signal twice.
TEST_F(Interrupts, RepeatedSignalCountsOnce) {
  write("slide.csv", kLongMotion);
  const Answer a = interrupt("run scene.yaml --rate 1000 --json --pairs-out pairs.csv",
                             "TERM $pid; sleep 0.01; kill -TERM");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
  EXPECT_TRUE(fs::exists(in("pairs.csv")));
}

TEST_F(Interrupts, PipeWithoutReaderCanBeInterrupted) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  // The program is signalled once it handles the signal (bit 14 of SigCgt), and has had time to open the
  // pipe.
  const Answer a = shell(
      "\"$ABSTAND\" skeleton person.csv --json --out pipe & pid=$!; "
      "for i in $(seq 100); do grep -q 'SigCgt:.*[4-7c-f][0-9a-f]\\{3\\}$' /proc/$pid/status && break; "
      "sleep 0.1; done; sleep 0.5; kill -TERM $pid; wait $pid; exit $?");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_EQ(json::parse(a.out, nullptr, false)["interrupted"], true) << a.out;
}

// A gate that was not closed to the end is open nowhere, though all that it saw was far apart.
TEST_F(Interrupts, CheckReportsPartialResultAndDoesNotPass) {
  write("slide.csv", kLongMotion);
  const Answer a =
      interruptFrames("check scene.yaml --min-distance 0.01 --json --junit result.xml --report result.html");
  EXPECT_EQ(a.code, 130) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  ASSERT_TRUE(j.is_object()) << a.out;
  EXPECT_EQ(j["interrupted"], true);
  EXPECT_EQ(j["passed"], false);
  EXPECT_TRUE(j["violations"].empty());
  const long frames = j["frames"];
  EXPECT_GT(frames, 0);
  EXPECT_LT(frames, 5'000'001);
  EXPECT_NEAR(j["min_distance"]["value"].get<double>(), 0.3, 0.05);
  const json& r = j["reservations"].back();
  EXPECT_EQ(r["kind"], "interrupted") << j["reservations"];
  EXPECT_EQ(r["fails"], "always");
  EXPECT_NEAR(r["t0"].get<double>(), 1e-3 * static_cast<double>(frames - 1), 1e-6);
  EXPECT_NE(r["text"].get<std::string>().find(std::to_string(frames) + " of 5000001 frames"),
            std::string::npos)
      << r;
  EXPECT_NE(readFile(in("result.xml")).find("<failure type=\"interrupted\""), std::string::npos);
  EXPECT_NE(readFile(in("result.html")).find("Not passed"), std::string::npos);
  EXPECT_NE(readFile(in("result.html")).find("interrupted at"), std::string::npos);
}

TEST_F(Interrupts, CheckKeepsViolationsFoundBefore) {
  write("slide.csv", kLongMotion);
  const Answer a = interruptFrames("check scene.yaml --min-distance 0.5");
  EXPECT_EQ(a.code, 130) << a.err;
  EXPECT_NE(a.out.find("violated: cart to wall"), std::string::npos) << a.out;
  EXPECT_NE(a.out.find("reservation (interrupted)"), std::string::npos) << a.out;
  EXPECT_NE(a.out.find("not passed: 1 limit violated, 1 reservation (interrupted)"), std::string::npos)
      << a.out;
}

TEST_F(Interrupts, PairsStayUndecidedAndWriteNothing) {
  const auto before = names();
  const std::string command =
      "pairs pair.urdf --voxel 0.05 --samples 100000000 --out pair.pairs --srdf pair.srdf";
  const Answer a = interrupt(command + " --json");
  EXPECT_EQ(a.code, 130) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  ASSERT_TRUE(j.is_object()) << a.out;
  EXPECT_EQ(j["interrupted"], true);
  EXPECT_EQ(j["undecided"], 1);
  EXPECT_EQ(j["never"], 0);
  EXPECT_EQ(j["adjacent"], 2);
  for (const json& row : j["list"]) {
    if (row["verdict"] != "undecided") continue;
    EXPECT_GT(row["samples"].get<long>(), 0);
    EXPECT_LT(row["samples"].get<long>(), 100000000);
    EXPECT_GT(row["distance"].get<double>(), 0.1);
  }
  EXPECT_EQ(names(), before);
  const Answer text = interrupt(command);
  EXPECT_EQ(text.code, 130) << text.err;
  EXPECT_NE(text.out.find("1 pair is undecided, nothing was written"), std::string::npos) << text.out;
  EXPECT_EQ(names(), before);
}

/// "clip", so long that nobody sees its end: as many images as `count`, the last one at `end` s.
std::string manyImages(int count, double end) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(end * i / count) + " depth_000000.png\n";
  return text;
}

TEST_F(Interrupts, TrackDuringSearchReportsNoPeople) {
  makeClip();
  // All in the first seconds, which are looked through before anybody is followed.
  write("clip/depth.txt", manyImages(20'000, 4.0));
  const auto before = names();
  const Answer a = interrupt("track clip --json --out person_found.csv --pictures pictures");
  EXPECT_EQ(a.code, 130) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  ASSERT_TRUE(j.is_object()) << a.out;
  EXPECT_EQ(j["interrupted"], true);
  EXPECT_EQ(j["frames"], 0);
  EXPECT_EQ(j["tracked"], 0);
  EXPECT_TRUE(j["people"].empty());
  EXPECT_EQ(names(), before);
}

TEST_F(Interrupts, TrackWhileFollowingWritesFrames) {
  makeClip();
  write("clip/depth.txt", manyImages(1'000, 5e3));
  // In 1/100 s: later where the first pass, which finds the people, was still under way.
  constexpr int kLongestFirstPass = 3200;
  Answer a;
  json j;
  for (int ticks = 100; ticks <= kLongestFirstPass; ticks *= 2) {
    a = interrupt("track clip --height 1.75 --usual-body --facing camera --json --out person_found.csv",
                  "INT", ticks);
    j = json::parse(a.out, nullptr, false);
    if (a.code != 130 || !j.is_object() || j["frames"] != 0) break;
  }
  EXPECT_EQ(a.code, 130) << a.err;
  ASSERT_TRUE(j.is_object()) << a.out;
  EXPECT_EQ(j["interrupted"], true);
  const long frames = j["frames"];
  EXPECT_GT(frames, 0);
  EXPECT_LT(frames, 1'000);
  EXPECT_EQ(j["tracked"], frames);
  EXPECT_EQ(runJson("skeleton '" + in("person_found.csv").string() + "'")["frames"], frames);
}

TEST_F(Interrupts, RunDuringTrackingHasNoFrames) {
  makeClip();
  write("clip/depth.txt", manyImages(20'000, 4.0));
  write("person.yaml",
        "abstand: 1\ndefaults: {voxel: 0.1, point: 0.1}\nhumans: [{name: p, height: 1.75}]\nobjects:\n"
        "  - {name: ball, shape: {sphere: {radius: 0.1}}, pose: {xyz: [9, 0, 0]}}\n");
  const Answer a =
      interrupt("check person.yaml --min-distance 0.01 --json --recording clip --recording person.csv");
  EXPECT_EQ(a.code, 130) << a.err;
  const json j = json::parse(a.out, nullptr, false);
  ASSERT_TRUE(j.is_object()) << a.out;
  EXPECT_EQ(j["interrupted"], true);
  EXPECT_EQ(j["passed"], false);
  EXPECT_EQ(j["frames"], 0);
  ASSERT_EQ(j["reservations"].size(), 2u) << j["reservations"];
  EXPECT_EQ(j["reservations"].at(0)["recording"], "clip");
  EXPECT_EQ(j["reservations"].at(1)["recording"], "person.csv");
}

}  // namespace interrupt_test
}  // namespace abstand::testing
