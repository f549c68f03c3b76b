// Options that name a folder of files.
#include "tests/app/outputs/outputs.hpp"

namespace abstand::testing {
namespace output_sets_test {

TEST_F(Outputs, FileSetsAreWrittenAtomically) {
  makeClip();
  // Two images, so two pictures.
  fs::copy_file(in("clip/depth_000000.png"), in("clip/depth_000001.png"));
  write("clip/depth.txt", "0 depth_000000.png\n0.03 depth_000001.png\n");
  const std::vector<std::string> sets{
      "human --height 1.8 --out", "build sphere:0.1 cuboid:0.2,0.2,0.2 --voxel 0.05 --point 0.05 --out",
      "render-depth scene.yaml --width 320 --noise none --eye 2,0,0.5 --look 0,0,0 --out",
      "track clip --height 1.75 --usual-body --facing camera --pictures"};
  for (const std::string& set : sets) {
    const auto before = names();
    // Enough for the first files of the set, not for all.
    for (const int blocks : {0, 1}) {
      const Answer a = shell("text=$(ulimit -f " + std::to_string(blocks) + "; \"$ABSTAND\" " + set +
                             " deep/set --quiet 2>&1); code=$?; echo \"$text\"; exit $code");
      EXPECT_EQ(a.code, 4) << set << a.out;
      EXPECT_TRUE(isOneLine(a.out)) << set << a.out;
      EXPECT_EQ(names(), before) << set;
    }
    const Answer file = run(set + " person.csv");
    EXPECT_EQ(file.code, 2) << set << file.err;
    EXPECT_EQ(names(), before) << set;
    // A folder that is there keeps its other files; one behind a link is that folder.
    fs::create_directory(in("real"));
    write("real/mine", "kept");
    fs::create_symlink("real", in("linked"));
    EXPECT_EQ(run(set + " linked").code, 0) << set;
    EXPECT_TRUE(fs::is_symlink(in("linked")));
    EXPECT_EQ(readFile(in("real/mine")), "kept");
    EXPECT_GT(std::distance(fs::directory_iterator(in("real")), fs::directory_iterator()), 2) << set;
    EXPECT_EQ(run(set + " deep/set").code, 0) << set;
    EXPECT_EQ(std::distance(fs::directory_iterator(in("deep/set")), fs::directory_iterator()),
              std::distance(fs::directory_iterator(in("real")), fs::directory_iterator()) - 1)
        << set;
    for (const char* used : {"real", "linked", "deep"}) fs::remove_all(in(used));
  }
}

TEST_F(Outputs, BuildDoesNotOverwriteInputMesh) {
  ASSERT_EQ(run("build sphere:0.1 --voxel 0.05 --point 0.05 --out set").code, 0);
  const std::string before = readFile(in("set/sphere_0.1.stl"));
  const Answer a = run("build set/sphere_0.1.stl --scale 2 --voxel 0.05 --point 0.05 --out set");
  EXPECT_EQ(a.code, 2) << a.err;
  EXPECT_EQ(readFile(in("set/sphere_0.1.stl")), before);
}

TEST_F(Outputs, RejectsInputFolderForImages) {
  makeClip();
  const auto before = names();
  for (const char* to : {"clip", "./clip/", "linked"}) {
    if (std::string(to) == "linked") fs::create_symlink("clip", in("linked"));
    const Answer a = run(std::string("track clip --pictures ") + to);
    EXPECT_EQ(a.code, 2) << to << a.err;
    EXPECT_NE(a.err.find("input"), std::string::npos) << a.err;
  }
  fs::remove(in("linked"));
  EXPECT_EQ(names(), before);
}

// The joints and the pictures of one run.
TEST_F(Outputs, NoJointsFileIfImagesFail) {
  makeClip();
  const auto before = names();
  // The joints of one image take less than the picture.
  const Answer a = shell(
      "text=$(ulimit -f 8; \"$ABSTAND\" track clip --height 1.75 --usual-body --facing camera --out "
      "joints.csv "
      "--pictures deep/set --quiet 2>&1); code=$?; echo \"$text\"; exit $code");
  EXPECT_EQ(a.code, 4) << a.out;
  EXPECT_TRUE(isOneLine(a.out)) << a.out;
  EXPECT_EQ(names(), before);
}

}  // namespace output_sets_test
}  // namespace abstand::testing
