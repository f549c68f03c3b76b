// Bytes of fields and back.
#include "core/store/structure_archive.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace abstand::store {
namespace structure_archive_test {

struct Part {
  double length{0.0};
  std::vector<std::int16_t> layers;
  template <class Archive>
  void archive(Archive& ar) {
    ar(length, layers);
  }
  bool operator==(const Part&) const = default;
};

struct Slot {
  using ArchivedAsBytes = void;
  Vector3d normal;
  bool operator==(const Slot&) const = default;
};

enum class Kind { kOne, kTwo };

struct Everything {
  int number{0};
  bool yes{false};
  Kind kind{Kind::kOne};
  float box[3]{};
  std::string name;
  Vector3d place{Vector3d::Zero()};
  Matrix3d matrix{Matrix3d::Zero()};
  std::optional<Part> there, not_there{Part{}};
  std::vector<Part> parts;
  std::vector<Vector3f> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Slot> slots;
  template <class Archive>
  void archive(Archive& ar) {
    ar(number, yes, kind, box, name, place, matrix, there, not_there, parts, points, triangles, slots);
  }
};

Everything something() {
  Everything e;
  e.number = -7;
  e.yes = true;
  e.kind = Kind::kTwo;
  e.box[2] = 2.5f;
  e.name = "left/link 1";
  e.place = {1.0, -0.0, kInfinity};
  e.matrix(1, 2) = 4.0;
  e.there = Part{3.5, {1, -2, 3}};
  e.not_there.reset();
  e.parts = {{1.0, {}}, {2.0, {4, 5}}};
  e.points = {{1, 2, 3}, {4, 5, 6}};
  e.triangles = {{0, 1, 2}};
  e.slots = {{{1, 2, 3}}, {{4, 5, 6}}};
  return e;
}

std::string bytesOf(Everything e) {
  std::ostringstream out;
  ArchiveWriter writer(&out);
  writer(e);
  EXPECT_EQ(writer.size(), out.str().size());
  return out.str();
}

TEST(StructureArchive, RoundTrips) {
  const Everything e = something();
  const std::string bytes = bytesOf(e);
  std::istringstream in(bytes);
  ArchiveReader reader(in, bytes.size());
  Everything back;
  reader(back);
  EXPECT_EQ(reader.left(), 0u);
  EXPECT_EQ(back.number, e.number);
  EXPECT_EQ(back.yes, e.yes);
  EXPECT_EQ(back.kind, e.kind);
  EXPECT_EQ(back.box[2], e.box[2]);
  EXPECT_EQ(back.name, e.name);
  EXPECT_EQ(back.place, e.place);
  EXPECT_TRUE(std::signbit(back.place.y()));
  EXPECT_EQ(back.matrix, e.matrix);
  EXPECT_EQ(back.there, e.there);
  EXPECT_EQ(back.not_there, std::nullopt);
  EXPECT_EQ(back.parts, e.parts);
  EXPECT_EQ(back.points, e.points);
  EXPECT_EQ(back.triangles, e.triangles);
  EXPECT_EQ(back.slots, e.slots);
}

TEST(StructureArchive, CountsSizeWithoutStream) {
  Everything e = something();
  ArchiveWriter counter(nullptr);
  counter(e);
  EXPECT_EQ(counter.size(), bytesOf(e).size());
}

TEST(StructureArchive, ChecksumsAgreeAndDependOnEveryByte) {
  Everything e = something();
  std::ostringstream out;
  ArchiveWriter writer(&out);
  writer(e);
  const std::string bytes = out.str();
  for (std::size_t i = 0; i <= bytes.size(); ++i) {
    std::string changed = bytes;
    if (i < bytes.size()) changed[i] = static_cast<char>(changed[i] ^ 0x10);
    std::istringstream in(changed);
    ArchiveReader reader(in, changed.size());
    std::string all(changed.size(), '\0');
    reader.bytes(all.data(), all.size());
    EXPECT_EQ(reader.checksum() == writer.checksum(), i == bytes.size()) << i;
  }
}

TEST(StructureArchive, RejectsReadingBeyondEnd) {
  const std::string bytes = bytesOf(something());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::istringstream in(bytes);
    ArchiveReader reader(in, size);
    Everything back;
    EXPECT_THROW(reader(back), ArchiveError) << size;
    // The stream ends before the size that was said.
    std::istringstream cut(bytes.substr(0, size));
    ArchiveReader hopeful(cut, bytes.size());
    EXPECT_THROW(hopeful(back), ArchiveError) << size;
  }
}

// A count that the rest of the file cannot hold must not be allocated.
TEST(StructureArchive, RejectsImpossibleCounts) {
  for (const std::uint64_t count : {std::uint64_t{3}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    std::string bytes(reinterpret_cast<const char*>(&count), sizeof count);
    bytes += std::string(2 * sizeof(double), 'x');
    std::vector<double> numbers;
    std::vector<Part> parts;
    std::string text;
    const auto refuses = [&](auto& value) {
      std::istringstream in(bytes);
      ArchiveReader reader(in, bytes.size());
      EXPECT_THROW(reader(value), ArchiveError) << count;
    };
    refuses(numbers);
    refuses(parts);
    if (count > 16) refuses(text);
    EXPECT_LT(numbers.capacity() + parts.capacity() + text.capacity(), 100u);
  }
}

}  // namespace structure_archive_test
}  // namespace abstand::store
