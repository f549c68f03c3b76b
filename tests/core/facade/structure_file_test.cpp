// Structures in files of their own: the same bits come back, and whatever is wrong with a file is said.
#include <gtest/gtest.h>

#include <fstream>

#include "abstand/query.hpp"
#include "core/base/content_hash.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand {
namespace structure_file_test {

namespace fs = std::filesystem;

constexpr StructureOptions kCoarse{.voxel_size = 0.02, .point_spacing = 0.02, .outer_layers = 3};
// Magic, version; then the first section's tag and length.
constexpr std::size_t kHead = 12, kSection = 12;

std::string slurp(const fs::path& file) { return readFile(file, 1u << 30); }

void spit(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// With a checksum that fits, as somebody would write it who forges a file.
std::string sealed(std::string bytes) {
  bytes.resize(bytes.size() - 16);
  ContentHash hash;
  hash.add(bytes.data(), bytes.size());
  const ContentKey key = hash.value();
  bytes.append(reinterpret_cast<const char*>(&key.low), 8);
  bytes.append(reinterpret_cast<const char*>(&key.high), 8);
  return bytes;
}

std::string errorOf(const fs::path& file, Origin origin) {
  try {
    Structure::load(file, origin);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "nothing";
}

/// One line, and perhaps a second one with a hint.
bool isOneLine(const std::string& error, const fs::path& file) {
  const std::string first = error.substr(0, error.find("\nhint: "));
  return first.starts_with(file.string()) && first.find('\n') == std::string::npos &&
         first.find("error: ") != std::string::npos;
}

void expectSame(const Structure& l, const Structure& r) {
  EXPECT_EQ(l.name(), r.name());
  EXPECT_EQ(l.points(), r.points());
  EXPECT_EQ(l.errorBound(), r.errorBound());
  EXPECT_EQ(l.memoryBytes(), r.memoryBytes());
  for (int i = 0; i < 20; ++i) {
    const Pose X{Transform(testing::randomPose(i, 0.15))};
    const PairResult a = queryPair(l, Pose::Identity(), l, X, {.margin = 0.01});
    const PairResult b = queryPair(r, Pose::Identity(), r, X, {.margin = 0.01});
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.bound, b.bound);
    EXPECT_EQ(a.force_a, b.force_a);
    EXPECT_EQ(a.torque_b, b.torque_b);
    EXPECT_EQ(a.contacts, b.contacts);
  }
}

TEST(StructureFile, RoundTripsBitExactly) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "body.structure";
  for (const auto field : {StructureOptions::Field::kLayered, StructureOptions::Field::kFloat,
                           StructureOptions::Field::kMixed}) {
    StructureOptions options = kCoarse;
    options.field = field;
    const Mesh mesh = Structure::build(Shape::capsule(0.05, 0.1), kCoarse).mesh(4e-3);
    std::vector<Structure> bodies{Structure::build(mesh, options, "a mesh"),
                                  Structure::build(Shape::cylinder(0.05, 0.1), options)};
    if (field == StructureOptions::Field::kMixed)
      for (const Shape& shape : {Shape::sphere(0.05), Shape::ellipsoid({0.05, 0.06, 0.07}),
                                 Shape::cuboid({0.05, 0.06, 0.07}), Shape::capsule(0.05, 0.0)})
        bodies.push_back(Structure::build(shape, options, "ball"));
    for (const Structure& made : bodies) {
      made.save(file);
      expectSame(made, Structure::load(file, Origin::kOwn));
      expectSame(made, Structure::load(file));
    }
  }
}

TEST(StructureFile, ReportsDamagedFiles) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "body.structure";
  Structure::build(Shape::sphere(0.05), kCoarse).save(file);
  const std::string good = slurp(file);
  for (const Origin origin : {Origin::kUnknown, Origin::kOwn}) {
    // Damaged anywhere, cut anywhere, longer, empty, something else, not there.
    for (std::size_t i = 0; i < good.size(); i += 1 + good.size() / 31) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ 0x10);
      spit(file, bad);
      EXPECT_TRUE(isOneLine(errorOf(file, origin), file)) << i << ": " << errorOf(file, origin);
      spit(file, good.substr(0, i));
      EXPECT_TRUE(isOneLine(errorOf(file, origin), file)) << i << ": " << errorOf(file, origin);
    }
    spit(file, good + "x");
    EXPECT_NE(errorOf(file, origin).find("damaged"), std::string::npos);
    spit(file, "solid no\nendsolid\n");
    EXPECT_NE(errorOf(file, origin).find("no structure file"), std::string::npos);
    EXPECT_TRUE(isOneLine(errorOf(folder.path() / "none", origin), folder.path() / "none"));
    EXPECT_TRUE(isOneLine(errorOf(folder.path(), origin), folder.path()));
    std::string newer = good;
    newer[8] = 2;
    spit(file, sealed(newer));
    EXPECT_NE(errorOf(file, origin).find("version 2"), std::string::npos);
  }
}

TEST(StructureFile, RejectsForgedContent) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "body.structure";
  Mesh tetrahedron;
  for (const auto& p : {Eigen::Vector3d(0, 0, 0), {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}})
    tetrahedron.vertices.push_back(p);
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  Structure::build(tetrahedron, kCoarse, "t").save(file);
  const std::string good = slurp(file);
  // The body: a name of one letter with its length, the kind, the number of vertices, the vertices, ...
  const std::size_t kind = kHead + kSection + 9, vertices = kind + 1, first = vertices + 8;
  const std::size_t triangles = first + 4 * 24 + 8;
  const auto forge = [&](std::size_t place, const auto& value) {
    std::string bad = good;
    std::memcpy(&bad[place], &value, sizeof value);
    spit(file, sealed(bad));
    return errorOf(file, Origin::kUnknown);
  };
  EXPECT_TRUE(isOneLine(forge(kind, std::uint8_t{9}), file));
  EXPECT_TRUE(isOneLine(forge(vertices, std::uint64_t{1} << 61), file));
  EXPECT_TRUE(isOneLine(forge(first, std::numeric_limits<double>::quiet_NaN()), file));
  EXPECT_TRUE(isOneLine(forge(first, 1e9), file));
  EXPECT_TRUE(isOneLine(forge(triangles, std::uint32_t{4}), file));
  // The options follow: voxel size, point spacing, layers, field.
  const std::size_t options = triangles + 4 * 12 + kSection;
  EXPECT_TRUE(isOneLine(forge(options, -1.0), file));
  EXPECT_TRUE(isOneLine(forge(options + 16, std::int32_t{-1}), file));
  EXPECT_TRUE(isOneLine(forge(options + 20, std::int32_t{7}), file));
}

TEST(StructureFile, IsWrittenAtomically) {
  const testing::ScratchFolder folder;
  const Structure ball = Structure::build(Shape::sphere(0.05), kCoarse);
  EXPECT_THROW(ball.save(folder.path() / "no" / "such" / "folder"), std::runtime_error);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace structure_file_test
}  // namespace abstand
