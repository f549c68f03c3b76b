// Project files: the same bytes, relative paths, errors with their place.
#include "ui/document/project_file.hpp"

#include <gtest/gtest.h>

#include <QDir>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/ui/document/sample_project.hpp"
#include "ui/document/json_text.hpp"

namespace abstand::ui {
namespace project_file_test {

TEST(ProjectFileTest, SaveLoadSaveIsByteIdentical) {
  for (const Project& project : {sampleProject(), Project()})
    for (const QString folder : {"/cell/projects", "/", ""}) {
      const std::string text = projectText(project, folder);
      const ProjectFile read = parseProject(text, "p.abstand", folder);
      EXPECT_EQ(read.project, project) << text;
      EXPECT_EQ(projectText(read.project, folder), text);
    }
}

TEST(ProjectFileTest, PathsAreRelativeToFile) {
  testing::ScratchFolder folder;
  Project project = sampleProject();
  const QString root = QString::fromStdString(folder.path().string());
  project.work.scene = root + "/scene.yaml";
  project.work.recording = root + "/people/walk.bvh";
  ASSERT_TRUE(QDir(root).mkpath("projects"));
  writeProject(project, root + "/projects/p.abstand");
  const std::string text = readFile(folder.path() / "projects" / "p.abstand");
  EXPECT_NE(text.find("\"../scene.yaml\""), std::string::npos) << text;
  EXPECT_EQ(text.find(folder.path().string()), std::string::npos) << text;
  // The folder as a whole may go elsewhere.
  testing::ScratchFolder other;
  std::filesystem::copy(folder.path() / "projects", other.path() / "projects");
  const Project moved = readProject(QString::fromStdString((other.path() / "projects/p.abstand").string()));
  EXPECT_EQ(moved.work.scene.toStdString(), (other.path() / "scene.yaml").string());
  EXPECT_EQ(moved.work.recording.toStdString(), (other.path() / "people/walk.bvh").string());
}

TEST(ProjectFileTest, AutosaveNamesItsProject) {
  const std::string text = projectText(sampleProject(), "", "/cell/p.abstand");
  EXPECT_EQ(parseProject(text, "a", "/elsewhere").saved_as, "/cell/p.abstand");
}

TEST(ProjectFileTest, ErrorsHavePositions) {
  struct Case {
    const char* text;
    const char* error;
  };
  const Case cases[] = {
      {"", "p.abstand:"},
      {"{", "p.abstand:"},
      {"[]", "p.abstand:1:1: error: "},
      {"{}", "abstand_project"},
      {"{\"abstand_project\": 2}", "p.abstand:1:21: error: found `2`, expected version 1 of project files"},
      {"{\"abstand_project\": 1,\n \"margin\": {}}", "p.abstand:2:2: error: "},
      {"{\"abstand_project\": 1,\n \"margins\": {\"a\": -1}}", "p.abstand:2:19: error: "},
      {"{\"abstand_project\": 1,\n \"margins\": {\"a\": 2.5}}", "p.abstand:2:19: error: "},
      {"{\"abstand_project\": 1,\n \"margins\": {\"a\": \"1\"}}", "p.abstand:2:19: error: "},
      {"{\"abstand_project\": 1,\n \"margins\": {\"a\": 0, \"a\": 1}}", "p.abstand:2:22: error: "},
      {"{\"abstand_project\": 1, \"margins\": []}", "expected a map"},
      {"{\"abstand_project\": 1,\n \"classes\": {\"person\": {\"margin\": 1}}}", "p.abstand:2:14: error: "},
      {"{\"abstand_project\": 1,\n \"classes\": {\"robot_robot\": {\"locked\": true}}}", "`margin`"},
      {"{\"abstand_project\": 1,\n \"classes\": {\"robot_robot\": {\"margin\": 3}}}", "`margin`"},
      {"{\"abstand_project\": 1, \"hidden\": [{}]}", "`hidden`"},
      {"{\"abstand_project\": 1, \"pair_groups\": {\"g\": \"off\"}}", "running"},
      {"{\"abstand_project\": 1, \"moved_pairs\": [{\"a\": \"x\"}]}", "`b`"},
      {"{\"abstand_project\": 1, \"range\": {\"in\": 2, \"out\": 1}}", "found `in` after `out`"},
      {"{\"abstand_project\": 1, \"camera\": {\"distance\": 0}}", "`distance`"},
      {"{\"abstand_project\": 1, \"camera\": {\"focus\": [1, 2, .nan]}}", "p.abstand:1:"},
      {"{\"abstand_project\": 1, \"view\": {\"forces\": 1}}", "`forces`"},
      {"{\"abstand_project\": 1, \"bookmarks\": [{\"note\": \"x\"}]}", "`time`"},
      {"{\"abstand_project\": 1, \"time\": 1e400}", "`time`"}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.text);
    try {
      parseProject(c.text, "p.abstand", "/");
      ADD_FAILURE() << "no error";
    } catch (const ParseError& e) {
      EXPECT_NE(std::string(e.what()).find(c.error), std::string::npos) << e.what();
    }
  }
}

TEST(ProjectFileTest, DamagedFileIsOnlyAParseError) {
  const std::string text = projectText(sampleProject(), "/cell");
  for (std::size_t length = 0; length < text.size(); length += 3) {
    if (text.find_first_not_of(" \n", length) == std::string::npos) break;
    EXPECT_THROW(parseProject(text.substr(0, length), "p", "/"), ParseError) << length;
  }
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string broken = text;
    broken[at] = static_cast<char>(broken[at] ^ 0x15);
    try {
      parseProject(broken, "p", "/");
    } catch (const ParseError&) {
    }
  }
}

TEST(JsonTextTest, EscapesSpecialCharacters) {
  EXPECT_EQ(jsonString("a\"b\\c\nd\te\x7f ü"), "\"a\\\"b\\\\c\\nd\\u0009e\\u007f ü\"");
}

}  // namespace project_file_test
}  // namespace abstand::ui
