// What is listed of a scene that was opened.
#include "app/run/scene_notes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/paths.hpp"

namespace abstand::run {
namespace scene_notes_test {

std::vector<scene::SceneNote> notesOfScene(const testing::ScratchFolder& folder, const std::string& text) {
  session::SessionOptions options;
  options.threads = 1;
  options.cache = false;
  const session::Session session(
      scene_file::parseScene("abstand: 1\ndefaults: {voxel: 0.05, point: 0.05}\n" + text,
                             folder.path() / "scene.yaml"),
      options);
  return notesOf(session);
}

const scene::SceneNote* noteOf(const std::vector<scene::SceneNote>& notes, const std::string& kind) {
  const auto it =
      std::find_if(notes.begin(), notes.end(), [&](const scene::SceneNote& n) { return n.kind == kind; });
  return it == notes.end() ? nullptr : &*it;
}

TEST(SceneNotes, ListReservationsLimitsAndRemarksWorstFirst) {
  const testing::ScratchFolder folder;
  folder.write("slide.mech",
               "chain\n frame 1 0 0 d 0\nend_chain\nlimits\n limit 1 -1 1 0.5 21\nend_limits\n");
  folder.write("fast.csv", "t,q0\n0,0\n0.1,0.06\n");
  folder.write("two.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
               "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
  const auto notes = notesOfScene(folder,
                                  "mechanisms:\n"
                                  "  - {name: bare, file: slide.mech, base: {xyz: [0, 9, 0]}, links: []}\n"
                                  "  - {name: m, file: slide.mech, motion: fast.csv, links: [{name: cart, "
                                  "frame: 1, shape: {sphere: {radius: "
                                  "0.1}}}]}\n"
                                  "objects:\n  - {name: two, mesh: two.obj, pose: {xyz: [-9, 0, 0]}}\n");
  const scene::SceneNote* unknown = noteOf(notes, "no_body");
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->fails, scene::Severity::kAlways);
  EXPECT_EQ(unknown, &notes.front());
  const scene::SceneNote* limit = noteOf(notes, "joint_limit");
  ASSERT_TRUE(limit);
  EXPECT_EQ(limit->fails, scene::Severity::kStrict);
  EXPECT_NE(limit->text.find("m joint 1: planned velocity 0.6 m/s, limit 0.5"), std::string::npos)
      << limit->text;
  const scene::SceneNote* remark = noteOf(notes, "remark");
  ASSERT_TRUE(remark) << "a mesh in pieces";
  EXPECT_EQ(remark->fails, scene::Severity::kNote);
  EXPECT_TRUE(
      std::is_sorted(notes.begin(), notes.end(),
                     [](const scene::SceneNote& a, const scene::SceneNote& b) { return a.fails > b.fails; }));
}

TEST(SceneNotes, SoundSceneHasNone) {
  const testing::ScratchFolder folder;
  const auto notes = notesOfScene(folder,
                                  "objects:\n  - {name: a, shape: {sphere: {radius: 0.1}}}\n"
                                  "  - {name: b, shape: {sphere: {radius: 0.1}}, pose: {xyz: [1, 0, 0]}}\n");
  EXPECT_TRUE(notes.empty()) << notes.front().text;
}

}  // namespace scene_notes_test
}  // namespace abstand::run
