// Where meshes of robot files are found.
#include "core/robot_file/mesh_reference.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/paths.hpp"

namespace abstand::robot_file {
namespace mesh_reference_test {

namespace fs = std::filesystem;

class MeshReference : public ::testing::Test {
 protected:
  MeshReference() {
    for (const char* variable : {"ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"})
      ::unsetenv(variable);
  }
  ~MeshReference() override {
    for (const char* variable : {"ROS_PACKAGE_PATH", "AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH"})
      ::unsetenv(variable);
  }
  fs::path file(const std::string& name) const {
    fs::create_directories((folder_.path() / name).parent_path());
    return folder_.write(name, "x");
  }
  std::optional<fs::path> find(const std::string& reference,
                               const std::vector<fs::path>& folders = {}) const {
    return MeshFinder(folder_.path() / "ws/robot/urdf/robot.urdf", {folders, true}).find(reference);
  }

  testing::ScratchFolder folder_;
};

TEST_F(MeshReference, ResolvesRelativeAndAbsolutePaths) {
  const auto mesh = file("ws/robot/meshes/a b.stl");
  EXPECT_EQ(find("../meshes/a b.stl"), mesh);
  EXPECT_EQ(find(mesh.string()), mesh);
  EXPECT_EQ(find("file://" + mesh.string()), mesh);
  EXPECT_EQ(find("meshes/a b.stl"), mesh) << "found by walking up";
  EXPECT_EQ(find("a b.stl"), std::nullopt) << "a name alone is not looked for anywhere";
  EXPECT_EQ(find("/nowhere/a.stl"), std::nullopt);
  EXPECT_EQ(find(""), std::nullopt);
}

TEST_F(MeshReference, PackagePathComesFirst) {
  const auto near = file("ws/robot/pkg/m/a.stl");
  const auto far = file("elsewhere/pkg/m/a.stl");
  EXPECT_EQ(find("package://pkg/m/a.stl"), near);
  EXPECT_EQ(find("model://pkg/m/a.stl"), near);
  EXPECT_EQ(find("package://pkg/m/a.stl", {folder_.path() / "elsewhere"}), far);
  EXPECT_EQ(find("package://pkg/m/a.stl", {folder_.path() / "elsewhere/pkg"}), far) << "the package itself";
  EXPECT_EQ(find("package://pkg/m/b.stl"), std::nullopt);
  for (const char* broken : {"package://", "package:///a.stl", "package://pkg", "package://../a/b.stl"})
    EXPECT_EQ(find(broken), std::nullopt) << broken;
}

TEST_F(MeshReference, UsesRosVariables) {
  const auto nested = file("src/group/arm_description/m/a.stl");
  file("src/group/arm_description/package.xml");
  const auto installed = file("install/share/hand_description/m/a.stl");
  EXPECT_EQ(find("package://arm_description/m/a.stl"), std::nullopt);
  ::setenv("ROS_PACKAGE_PATH", (":/nowhere:" + (folder_.path() / "src").string()).c_str(), 1);
  EXPECT_EQ(find("package://arm_description/m/a.stl"), nested);
  ::setenv("AMENT_PREFIX_PATH", (folder_.path() / "install").c_str(), 1);
  EXPECT_EQ(find("package://hand_description/m/a.stl"), installed);
  EXPECT_EQ(MeshFinder(folder_.path() / "r.urdf", {{}, false}).find("package://hand_description/m/a.stl"),
            std::nullopt);
}

TEST_F(MeshReference, WalkingUpDropsLeadingFoldersWithRemark) {
  const auto mesh = file("ws/robot/meshes/arm/a.stl");
  MeshFinder finder(folder_.path() / "ws/robot/urdf/robot.urdf", {});
  EXPECT_EQ(finder.find("package://vendor/robots/robot_v2/meshes/arm/a.stl"), mesh);
  EXPECT_EQ(finder.find("package://vendor/robots/robot_v2/meshes/arm/a.stl"), mesh);
  ASSERT_EQ(finder.remarks().size(), 1u);
  EXPECT_NE(finder.remarks()[0].find("package://vendor"), std::string::npos);
}

}  // namespace mesh_reference_test
}  // namespace abstand::robot_file
