// Every option that names a file, given what stands where no plain file does: a directory, a device, a pipe,
// a link, an input, a full disk.
#include "tests/app/outputs/output_options.hpp"

namespace abstand::testing {
namespace output_files_test {

TEST_F(OutputFiles, RejectsDirectoryAndKeepsIt) {
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

TEST_F(OutputFiles, RejectsInputFileAndKeepsIt) {
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

TEST_F(OutputFiles, FollowsSymbolicLink) {
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
      const std::string written = readFile(in(target), 1 << 28, true);
      EXPECT_GT(written.size(), 3u) << o.name;
      EXPECT_EQ(written.starts_with("old"), is_there && o.appends) << o.name;
      if (is_there) {
        EXPECT_EQ(fs::status(in(target)).permissions(), fs::perms::owner_read | fs::perms::owner_write);
      }
    }
  }
}

TEST_F(OutputFiles, WritesIntoDevice) {
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

TEST_F(OutputFiles, PipeGetsSameBytes) {
  for (const Output& o : kFiles) {
    const std::string pipe = "pipe" + o.ending, plain = "plain" + o.ending;
    ASSERT_EQ(::mkfifo(in(pipe).c_str(), 0600), 0);
    const Answer a = shell("timeout 20 cat '" + pipe + "' >got & \"$ABSTAND\" " + commandOf(o, pipe) +
                           "; code=$?; wait; exit $code");
    EXPECT_EQ(a.code, 0) << o.name << ": " << a.err;
    EXPECT_TRUE(fs::is_fifo(in(pipe))) << o.name;
    // An HDF5 file and a page hold the time at which they were made, benchmarks and cycles what was measured.
    if (o.option == "--session" || o.option == "--cycles-out" || o.option == "--report" || o.appends) {
      EXPECT_GT(fs::file_size(in("got")), 100u) << o.name;
    } else {
      EXPECT_EQ(run(commandOf(o, plain)).code, 0) << o.name;
      EXPECT_EQ(readFile(in("got")), readFile(in(plain))) << o.name;
    }
    for (const std::string& used : {pipe, plain, std::string("got")}) fs::remove(in(used));
  }
}

TEST_F(OutputFiles, FullDiskExitsWith4AndLeavesNothing) {
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
    if (!o.appends) continue;
    // What was in the file stays, and half a row is taken back.
    const std::string old = write(to, std::string(1000, 'x') + "\n");
    const Answer more =
        shell("text=$(ulimit -f 2; \"$ABSTAND\" " + commandOf(o, to) + " 2>&1); code=$?; exit $code");
    EXPECT_EQ(more.code, 4) << o.name;
    EXPECT_EQ(readFile(old), std::string(1000, 'x') + "\n") << o.name;
  }
}

TEST_F(OutputFiles, FullDeviceExitsWith4) {
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

}  // namespace output_files_test
}  // namespace abstand::testing
