// Writes tables of numbers row by row to an HDF5 file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace abstand::hdf5 {

/// Storage type of a table's numbers.
enum class Storage : std::uint8_t {
  kDouble,   ///< 64-bit, exact
  kSteps32,  ///< integer multiples of a step, rounded down, 32-bit; clipped to the range; NaN is preserved
  kSteps16,  ///< the same in 16 bits
};

/// Whether a file's tables are made smaller, which takes a third of the time to write them.
enum class Compression : std::uint8_t { kDeflate, kNone };

/// A file under construction: appears under its name at commit(), completely or not at all. The same input
/// gives the same bytes. Only one thread of a process may use the library at a time.
class TableWriter {
 public:
  /// With a checksum in front (file_seal.hpp), which TableReader asks for. Throws WriteError.
  explicit TableWriter(const std::filesystem::path& file, Compression compression = Compression::kDeflate);
  ~TableWriter();
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// Sets an attribute of the file.
  void attribute(const std::string& name, long long value);
  void attribute(const std::string& name, double value);
  void attribute(const std::string& name, const std::string& value);
  /// Writes a whole list of texts.
  void texts(const std::string& name, const std::vector<std::string>& values);
  /// Writes a whole list of integers, with rows of `width`.
  void integers(const std::string& name, const std::vector<int>& values, std::size_t width);

  /// Adds a table that grows by rows of the extents `row` (empty: one number). Returns its index. `step` is
  /// the step of integer storage, stored in its attribute `step`.
  std::size_t table(const std::string& name, std::vector<std::size_t> row, Storage storage = Storage::kDouble,
                    double step = 1.0);
  /// What the numbers of a table are, as attributes of it: "m", and "x y z" for the columns of a row.
  void describe(std::size_t table, const std::string& unit, const std::string& columns = {});
  /// Numbers of the next row of a table, in order. Kept until endRow() has gathered a chunk.
  void add(std::size_t table, double value);
  void add(std::size_t table, std::span<const double> values);
  /// Declares the tables so far complete; table indices start at 0 again.
  void nextTables();
  /// Call after the numbers of all tables for one row. Throws WriteError immediately on disk errors.
  void endRow();

  /// Writes, closes and checks, so that commit() only renames. Throws WriteError.
  void finish();
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::hdf5
