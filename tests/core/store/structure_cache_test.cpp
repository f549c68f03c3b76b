// Structures kept on disk: the same bits come back, and whatever is wrong with a file is noticed.
#include "core/store/structure_cache.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/base/parallel.hpp"
#include "core/base/text_file.hpp"
#include "core/query/pair_query.hpp"
#include "core/store/structure_archive.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"

namespace abstand::store {
namespace structure_cache_test {

namespace fs = std::filesystem;
using testing::ScratchFolder;

constexpr structure::HapticOptions kCoarse{.voxel_size = 0.02, .point_spacing = 0.02, .outer_layers = 2};
const geometry::Shape kBall = geometry::Sphere{0.05};

std::shared_ptr<const geometry::Surface> ball() { return geometry::makeSurface(kBall); }
geometry::TriangleMesh bodyMesh() { return geometry::tessellate(geometry::Capsule{0.04, 0.08}, 2e-4); }

/// All that is kept of a structure.
std::string bytesOf(const structure::HapticStructure& s) {
  std::ostringstream out;
  ArchiveWriter writer(&out);
  writer(const_cast<structure::HapticStructure&>(s));
  return out.str();
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void spit(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// A cache with one kept structure.
struct Kept {
  ScratchFolder folder;
  StructureCache cache{folder.path()};
  ContentKey key = structureKey(*ball(), kCoarse);
  std::shared_ptr<const structure::HapticStructure> made =
      makeHapticStructure(cache, "ball", ball(), kCoarse, 1).structure;
  fs::path file = cache.structureFile(key);

  std::shared_ptr<const structure::HapticStructure> find() {
    return cache.findStructure(key, "ball", ball());
  }
};

TEST(StructureCache, IsBitIdenticalForEveryFieldKind) {
  ScratchFolder folder;
  StructureCache cache(folder.path());
  const std::shared_ptr<const geometry::Surface> body = geometry::makeSurface(bodyMesh());
  for (const structure::FieldKind kind :
       {structure::FieldKind::kLayered, structure::FieldKind::kFloat, structure::FieldKind::kMixed}) {
    const structure::HapticOptions options{
        .voxel_size = 0.01, .point_spacing = 0.01, .outer_layers = 4, .field = kind};
    const MadeStructure first = makeHapticStructure(cache, "a", body, options, 2);
    const MadeStructure second = makeHapticStructure(cache, "b", body, options, 2);
    EXPECT_FALSE(first.cached);
    ASSERT_TRUE(second.cached);
    const structure::HapticStructure &built = *first.structure, &found = *second.structure;
    EXPECT_EQ(bytesOf(found), bytesOf(built));
    EXPECT_EQ(found.name, "b");
    EXPECT_EQ(found.surface, body);
    EXPECT_EQ(found.memoryBytes(), built.memoryBytes());
    EXPECT_EQ(found.errorBound(), built.errorBound());
    EXPECT_EQ(found.build_ms, built.build_ms);
    // Both are asked against a third, from near and far and inside.
    kernels::PairScratch scratch;
    for (int i = 0; i < 200; ++i) {
      const Transform X(testing::randomPose(i, 0.1));
      query::PairResult r[2];
      query::queryPair({built, Transform::Identity()}, {built, X}, {.margin = 0.01}, scratch, r[0]);
      query::queryPair({found, Transform::Identity()}, {found, X}, {.margin = 0.01}, scratch, r[1]);
      EXPECT_EQ(r[0].distance, r[1].distance);
      EXPECT_EQ(r[0].bound, r[1].bound);
      EXPECT_EQ(r[0].force_a, r[1].force_a);
      EXPECT_EQ(r[0].contacts, r[1].contacts);
    }
  }
  EXPECT_TRUE(cache.takeWarnings().empty());
}

TEST(StructureCache, KeepsPiecesOfBody) {
  ScratchFolder folder;
  StructureCache cache(folder.path());
  // Two balls as one body. One of them lies within another body, away from its points.
  geometry::TriangleMesh mesh = geometry::tessellate(kBall, 2e-3);
  const geometry::TriangleMesh other = mesh;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3d& p : other.vertices) mesh.vertices.push_back(p + Vector3d::UnitX());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const std::shared_ptr<const geometry::Surface> balls = geometry::makeSurface(mesh);
  const MadeStructure built = makeHapticStructure(cache, "balls", balls, kCoarse, 1);
  const MadeStructure found = makeHapticStructure(cache, "balls", balls, kCoarse, 1);
  ASSERT_TRUE(found.cached);
  EXPECT_EQ(built.structure->pieces.size(), 2u);
  EXPECT_EQ(found.structure->pieces, built.structure->pieces);
}

TEST(StructureCache, RestoresSameSurface) {
  ScratchFolder folder;
  StructureCache cache(folder.path());
  const geometry::TriangleMesh mesh = bodyMesh();
  ASSERT_GT(mesh.triangles.size(), 1000u);
  const auto made = makeSurface(cache, mesh);
  EXPECT_EQ(filesIn(folder.path()), 1u);
  const auto found = cache.findSurface(surfaceKey(mesh));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->watertight(), made->watertight());
  EXPECT_EQ(found->bounds().lower, made->bounds().lower);
  EXPECT_EQ(found->area(), made->area());
  EXPECT_EQ(structureKey(*found, kCoarse), structureKey(*made, kCoarse));
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p = testing::randomPose(i, 0.2).translation();
    const geometry::SurfacePoint a = made->closest(p), b = found->closest(p);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(made->inside(p), found->inside(p));
    EXPECT_EQ(made->inside(p, a), found->inside(p, b));
  }
  EXPECT_TRUE(cache.takeWarnings().empty());
}

TEST(StructureCache, DetectsAnyFlippedBit) {
  Kept k;
  const std::string good = readFile(k.file);
  ASSERT_TRUE(k.find());
  // Every bit of the header and the checksum, and bits all over what lies between.
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < good.size(); i += i < 64 || i + 32 > good.size() ? 1 : 197) places.push_back(i);
  for (std::size_t i = good.size() - 32; i < good.size(); ++i) places.push_back(i);
  for (const std::size_t i : places) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
    spit(k.file, bad);
    ASSERT_EQ(k.find(), nullptr) << "byte " << i;
    ASSERT_EQ(k.cache.takeWarnings().size(), 1u) << "byte " << i;
  }
  // Made anew, it is whole again.
  const MadeStructure again = makeHapticStructure(k.cache, "ball", ball(), kCoarse, 1);
  EXPECT_FALSE(again.cached);
  EXPECT_EQ(k.cache.takeWarnings().size(), 1u);
  EXPECT_TRUE(k.find());
  EXPECT_TRUE(k.cache.takeWarnings().empty());
}

TEST(StructureCache, DetectsTruncatedExtendedAndForeignFiles) {
  Kept k;
  const std::string good = readFile(k.file);
  std::vector<std::string> bad{good + "x", "something else", std::string(1000, '\0')};
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 300)
    bad.push_back(good.substr(0, size));
  const structure::HapticOptions other{.voxel_size = 0.03, .point_spacing = 0.02, .outer_layers = 2};
  makeHapticStructure(k.cache, "other", ball(), other, 1);
  bad.push_back(readFile(k.cache.structureFile(structureKey(*ball(), other))));
  for (const std::string& bytes : bad) {
    spit(k.file, bytes);
    EXPECT_EQ(k.find(), nullptr) << bytes.size();
    const auto warnings = k.cache.takeWarnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].find(k.file.string()), 0u) << warnings[0];
  }
  fs::remove(k.file);
  EXPECT_EQ(k.find(), nullptr);
  EXPECT_TRUE(k.cache.takeWarnings().empty()) << "a file that is not there is nothing to warn of";
}

TEST(StructureCache, ReportsOtherVersion) {
  Kept k;
  std::string bytes = readFile(k.file);
  bytes[8] = static_cast<char>(bytes[8] + 1);  // format, after the magic
  spit(k.file, bytes);
  EXPECT_EQ(k.find(), nullptr);
  EXPECT_NE(k.cache.takeWarnings().at(0).find("another version"), std::string::npos);
}

TEST(StructureCache, KeysAreDistinct) {
  geometry::TriangleMesh mesh = bodyMesh();
  std::vector<ContentKey> keys;
  const auto add = [&](const geometry::Shape& shape, const structure::HapticOptions& o) {
    keys.push_back(structureKey(*geometry::makeSurface(shape), o));
  };
  add(kBall, kCoarse);
  add(geometry::Sphere{std::nextafter(0.05, 1.0)}, kCoarse);
  add(geometry::Cylinder{0.05, 0.1}, kCoarse);
  add(geometry::Capsule{0.05, 0.1}, kCoarse);
  add(geometry::Cuboid{{0.1, 0.2, 0.3}}, kCoarse);
  add(geometry::Ellipsoid{{0.1, 0.2, 0.3}}, kCoarse);
  structure::HapticOptions o = kCoarse;
  o.voxel_size = 0.021;
  add(kBall, o);
  o = kCoarse;
  o.point_spacing = 0.021;
  add(kBall, o);
  o = kCoarse;
  o.outer_layers = 3;
  add(kBall, o);
  o = kCoarse;
  o.field = structure::FieldKind::kFloat;
  add(kBall, o);
  const auto addMesh = [&] { keys.push_back(structureKey(*geometry::makeSurface(mesh), kCoarse)); };
  addMesh();
  EXPECT_EQ(keys.back(), structureKey(*geometry::makeSurface(mesh), kCoarse));
  keys.push_back(surfaceKey(mesh));
  mesh.vertices[3].x() = std::nextafter(mesh.vertices[3].x(), 1.0);
  addMesh();
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  addMesh();
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

// Two processes and more, each with threads of its own, write and read the same file. A reader sees it whole
// or not at all.
TEST(StructureCache, IsSharedByProcesses) {
  Kept k;
  const std::string bytes = bytesOf(*k.made);
  std::vector<pid_t> children;
  for (int c = 0; c < 4; ++c) {
    const pid_t pid = ::fork();
    if (pid == 0) {
      StructureCache cache(k.folder.path());
      bool good = true;
      for (int i = 0; i < 50; ++i) {
        if (c < 2) cache.store(k.key, *k.made);
        const auto found = cache.findStructure(k.key, "ball", nullptr);
        good = good && found && bytesOf(*found) == bytes;
      }
      ::_exit(good && cache.takeWarnings().empty() ? 0 : 1);
    }
    children.push_back(pid);
  }
  for (const pid_t pid : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(pid, &status, 0), pid);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(filesIn(k.folder.path()), 1u) << "nothing half written is left";
}

TEST(StructureCache, EvictsLeastRecentlyUsed) {
  ScratchFolder folder;
  Kept k;
  const std::uintmax_t one = fs::file_size(k.file);
  StructureCache cache(folder.path(), 3 * one + one / 2);
  const auto keyOf = [](int i) { return ContentKey{std::uint64_t(i), 0}; };
  const auto then = fs::file_time_type::clock::now() - std::chrono::hours(10);
  for (int i = 0; i < 3; ++i) {
    cache.store(keyOf(i), *k.made);
    fs::last_write_time(cache.structureFile(keyOf(i)), then + std::chrono::hours(i));
  }
  EXPECT_EQ(filesIn(folder.path()), 3u);
  EXPECT_TRUE(cache.findStructure(keyOf(0), "", ball())) << "now it was used last";
  spit(folder.path() / "a stranger", std::string(10 * one, 'x'));
  cache.store(keyOf(3), *k.made);
  EXPECT_EQ(filesIn(folder.path()), 4u);
  EXPECT_FALSE(exists(cache.structureFile(keyOf(1))));
  EXPECT_TRUE(exists(cache.structureFile(keyOf(0))) && exists(cache.structureFile(keyOf(2))) &&
              exists(cache.structureFile(keyOf(3))));
  EXPECT_TRUE(exists(folder.path() / "a stranger"));
}

TEST(StructureCache, RemovesPartialFilesOfKilledProcesses) {
  Kept k;
  const fs::path old = k.file.string() + ".part1234.0", fresh = k.file.string() + ".part1235.0";
  spit(old, "half");
  spit(fresh, "half");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(48));
  k.cache.store(k.key, *k.made);
  EXPECT_FALSE(exists(old));
  EXPECT_TRUE(exists(fresh)) << "somebody may be writing it";
}

TEST(StructureCache, UnusableFolderIsOnlyAWarning) {
  ScratchFolder folder;
  StructureCache cache(folder.write("file", "in the way") / "cache");
  const MadeStructure made = makeHapticStructure(cache, "ball", ball(), kCoarse, 1);
  EXPECT_TRUE(made.structure);
  EXPECT_FALSE(made.cached);
  EXPECT_EQ(cache.takeWarnings().size(), 1u);
}

TEST(StructureCache, StoresNothingWhenOff) {
  StructureCache cache({});
  EXPECT_FALSE(cache.on());
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(makeHapticStructure(cache, "ball", ball(), kCoarse, 1).cached);
  EXPECT_TRUE(cache.takeWarnings().empty());
}

TEST(StructureCache, UsesCacheFolderOfUser) {
  const auto with = [](const char* own, const char* xdg, const char* home) {
    const auto set = [](const char* name, const char* value) {
      value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
    };
    set("ABSTAND_CACHE", own);
    set("XDG_CACHE_HOME", xdg);
    set("HOME", home);
    return userCacheFolder();
  };
  EXPECT_EQ(with("/a/b", "/x", "/h"), "/a/b");
  EXPECT_EQ(with("off", "/x", "/h"), "");
  EXPECT_EQ(with(nullptr, "/x", "/h"), "/x/abstand");
  EXPECT_EQ(with("", "relative", "/h"), "/h/.cache/abstand");
  EXPECT_EQ(with(nullptr, nullptr, "/h"), "/h/.cache/abstand");
  EXPECT_EQ(with(nullptr, nullptr, nullptr), "");
  ::setenv("ABSTAND_CACHE", "off", 1);
}

TEST(BuildMonitor, ReportsAllWorkOnce) {
  for (const int threads : {1, 3}) {
    std::vector<double> heard;
    std::vector<std::string> phases;
    structure::BuildMonitor monitor;
    monitor.progress = [&](double fraction, std::string_view phase) {
      heard.push_back(fraction);
      if (phases.empty() || phases.back() != phase) phases.emplace_back(phase);
    };
    structure::buildHapticStructure("ball", ball(), {.voxel_size = 0.005, .point_spacing = 0.01}, threads,
                                    monitor);
    EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
    EXPECT_EQ(heard.front(), 0.0);
    EXPECT_EQ(heard.back(), 1.0);
    EXPECT_GT(heard.size(), 20u);
    EXPECT_EQ(phases, (std::vector<std::string>{"voxels", "near field", "far field", "pointshell"}));
  }
}

TEST(BuildMonitor, CancelsBuildAnywhereLeavingNothing) {
  std::shared_ptr<const geometry::Surface> body{geometry::makeSurface(bodyMesh())};
  std::atomic<int> asked{0};
  structure::BuildMonitor monitor;
  monitor.cancelled = [&] {
    ++asked;
    return false;
  };
  structure::buildHapticStructure("body", body, kCoarse, 2, monitor);
  const int all = asked;
  ASSERT_GT(all, 20);
  ScratchFolder folder;
  StructureCache cache(folder.path());
  for (int until = 0; until < all; until += 1 + all / 30) {
    asked = 0;
    monitor.cancelled = [&] { return ++asked > until; };
    EXPECT_THROW(makeHapticStructure(cache, "body", body, kCoarse, 2, monitor), structure::BuildCancelled)
        << until;
    // Each thread asks once more at most, and the first one to hear stops the others.
    EXPECT_LE(asked, until + 2);
    EXPECT_EQ(loop_watch, nullptr);
  }
  EXPECT_EQ(filesIn(folder.path()), 0u);
}

}  // namespace structure_cache_test
}  // namespace abstand::store
