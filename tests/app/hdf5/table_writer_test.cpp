// Tables come back as they were written. TableReader reads with H5Dread alone, whose filters are the
// library's own.
#include "app/hdf5/table_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "app/hdf5/table_reader.hpp"
#include "core/base/text_file.hpp"
#include "core/math/transform.hpp"
#include "tests/support/paths.hpp"

namespace abstand::testing {
namespace table_writer_test {

constexpr std::size_t kRows = 2500;  // two full chunks and a part of one
constexpr double kStep = 0.25;

/// Rows of every kind: values that compress well, hardly, and not at all; unknown and equal ones.
double valueAt(std::size_t row, std::size_t column) {
  std::mt19937_64 random(row * 1000 + column);
  switch (column % 5) {
    case 0:
      return 3.0;
    case 1:
      return static_cast<double>(row) * kStep;
    case 2:
      return std::ldexp(static_cast<double>(random()), -50);
    case 3:
      return kNaN;
    default:
      return -1.5 * static_cast<double>(row % 7);
  }
}

class Hdf5Tables : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.path() / "tables.h5"; }
  /// Writes `rows` rows of numbers with the extents `row`.
  void write(const std::vector<std::size_t>& row, hdf5::Storage storage,
             hdf5::Compression compression = hdf5::Compression::kDeflate, std::size_t rows = kRows) const {
    hdf5::TableWriter out(file(), compression);
    const std::size_t table = out.table("values", row, storage, kStep);
    std::size_t width = 1;
    for (const std::size_t n : row) width *= n;
    for (std::size_t i = 0; i < rows; ++i) {
      std::vector<double> values;
      for (std::size_t c = 0; c < width; ++c) values.push_back(valueAt(i, c));
      out.add(table, values);
      out.endRow();
    }
    out.commit();
  }

  ScratchFolder folder_;
};

/// Distances wander by some steps from row to row: their lowest bytes are noise, the others hardly change.
TEST_F(Hdf5Tables, OfNoiseAboveConstantsComeBackAndAreSmall) {
  for (const auto storage : {hdf5::Storage::kDouble, hdf5::Storage::kSteps32, hdf5::Storage::kSteps16}) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> steps(-300, 300);
    std::vector<double> written;
    int wandering = 20'000;
    for (std::size_t i = 0; i < kRows; ++i) {
      wandering = std::clamp(wandering + steps(random), 16'500, 30'000);
      written.push_back(wandering * kStep);
    }
    hdf5::TableWriter out(file());
    const std::size_t table = out.table("values", {}, storage, kStep);
    for (const double v : written) {
      out.add(table, v);
      out.endRow();
    }
    out.commit();
    EXPECT_EQ(hdf5::TableReader(file()).table("values", kRows, 1), written);
    // One byte of noise and what the others take; the file itself has some 6 kB.
    EXPECT_LT(std::filesystem::file_size(file()), storage == hdf5::Storage::kDouble ? 18'000u : 12'000u);
  }
}

TEST_F(Hdf5Tables, ComeBackWithoutCompression) {
  write({3, 7}, hdf5::Storage::kDouble, hdf5::Compression::kNone);
  const std::vector<double> values = hdf5::TableReader(file()).table("values", kRows, 21);
  for (std::size_t i = 0; i < kRows; ++i)
    for (std::size_t c = 0; c < 21; ++c) {
      const double expected = valueAt(i, c), found = values[i * 21 + c];
      ASSERT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << i << ", " << c;
    }
}

TEST_F(Hdf5Tables, DoublesRoundTripExactly) {
  write({3, 7}, hdf5::Storage::kDouble);
  const hdf5::TableReader in(file());
  EXPECT_EQ(in.extents("values").rows, kRows);
  EXPECT_EQ(in.extents("values").row, (std::vector<std::size_t>{3, 7}));
  const std::vector<double> values = in.table("values", kRows, 21);
  for (std::size_t i = 0; i < kRows; ++i)
    for (std::size_t c = 0; c < 21; ++c) {
      const double expected = valueAt(i, c), found = values[i * 21 + c];
      ASSERT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << i << ", " << c;
    }
}

TEST_F(Hdf5Tables, StepsRoundDownAndClip) {
  for (const auto storage : {hdf5::Storage::kSteps32, hdf5::Storage::kSteps16}) {
    const double most = (storage == hdf5::Storage::kSteps32 ? 2147483647.0 : 32767.0) * kStep;
    write({35}, storage);
    const std::vector<double> values = hdf5::TableReader(file()).table("values", kRows, 35);
    for (std::size_t i = 0; i < kRows; ++i)
      for (std::size_t c = 0; c < 35; ++c) {
        const double whole = std::min(std::floor(valueAt(i, c) / kStep) * kStep, most);
        const double expected = std::isnan(valueAt(i, c)) ? kNaN : whole, found = values[i * 35 + c];
        ASSERT_TRUE(found == expected || (std::isnan(found) && std::isnan(expected))) << i << ", " << c;
      }
  }
}

TEST_F(Hdf5Tables, ReadsRowRangesAcrossChunks) {
  write({5}, hdf5::Storage::kDouble);
  const hdf5::TableReader in(file());
  const std::vector<double> values = in.rows("values", 1020, 10, 5);
  for (std::size_t i = 0; i < 10; ++i)
    for (const std::size_t c : {0u, 1u, 2u, 4u}) EXPECT_EQ(values[i * 5 + c], valueAt(1020 + i, c));
}

/// Tables of up to a chunk, which is as long as the table, and of one row more.
TEST_F(Hdf5Tables, OfAnyLengthRoundTripExactly) {
  for (const std::size_t rows : {0u, 1u, 2u, 200u, 255u, 256u, 257u, 1023u, 1024u, 1025u}) {
    write({3}, hdf5::Storage::kDouble, hdf5::Compression::kDeflate, rows);
    const std::vector<double> values = hdf5::TableReader(file()).table("values", rows, 3);
    ASSERT_EQ(values.size(), 3 * rows);
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(values[i * 3 + c], valueAt(i, c)) << rows << ", " << i;
  }
}

/// Uncompressed, 400 columns of 10 rows take little more than their numbers: their chunks have 10 rows too.
TEST_F(Hdf5Tables, ShortTablesHaveShortChunks) {
  constexpr std::size_t kShort = 10, kColumns = 400, kChunkOverhead = 100;  // bytes of HDF5's index a chunk
  write({kColumns}, hdf5::Storage::kDouble, hdf5::Compression::kNone, kShort);
  EXPECT_LT(std::filesystem::file_size(file()), kColumns * (kShort * sizeof(double) + kChunkOverhead));
}

TEST_F(Hdf5Tables, SameValuesGiveSameBytes) {
  write({11}, hdf5::Storage::kSteps32);
  const std::string first = readFile(file());
  write({11}, hdf5::Storage::kSteps32);
  EXPECT_EQ(readFile(file()), first);
}

TEST_F(Hdf5Tables, SeveralGroupsAreWrittenInSequence) {
  {
    hdf5::TableWriter out(file());
    const std::size_t a = out.table("a", {});
    for (int i = 0; i < 1500; ++i) out.add(a, i), out.endRow();
    out.nextTables();
    const std::size_t b = out.table("b", {2});
    for (int i = 0; i < 1100; ++i) {
      for (const int sign : {1, -1}) out.add(b, sign * i);
      out.endRow();
    }
    out.commit();
  }
  const hdf5::TableReader in(file());
  const std::vector<double> a = in.table("a", 1500, 1), b = in.table("b", 1100, 2);
  for (std::size_t i = 0; i < 1500; ++i) ASSERT_EQ(a[i], static_cast<double>(i));
  for (std::size_t i = 0; i < 1100; ++i) {
    ASSERT_EQ(b[2 * i], static_cast<double>(i));
    ASSERT_EQ(b[2 * i + 1], -static_cast<double>(i));
  }
}

}  // namespace table_writer_test
}  // namespace abstand::testing
