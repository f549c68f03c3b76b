// Tables of numbers, written row by row into an HDF5 file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace abstand::hdf5 {

/// How the numbers of a table are kept.
enum class Storage : std::uint8_t {
  kDouble,   ///< 64 bits, exactly
  kSteps32,  ///< whole steps, rounded down, in 32 bits; what does not fit is clipped, no number stays none
  kSteps16,  ///< the same in 16 bits
};

/// A file under construction: appears under its name at commit(), whole, or not at all. The same input gives
/// the same bytes. One thread at a time uses the library in a process.
class TableWriter {
 public:
  /// With a checksum in front (file_seal.hpp), which TableReader asks for. Throws WriteError.
  explicit TableWriter(const std::filesystem::path& file);
  ~TableWriter();
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// Attributes of the file.
  void attribute(const std::string& name, long long value);
  void attribute(const std::string& name, double value);
  void attribute(const std::string& name, const std::string& value);
  /// A list of texts, whole.
  void texts(const std::string& name, const std::vector<std::string>& values);
  /// A list of numbers, whole, with rows of `width`.
  void integers(const std::string& name, const std::vector<int>& values, std::size_t width);

  /// A table that grows; a row has the extents `row` (empty: one number). Gives its number. Steps are `step`
  /// large, which the table says in its attribute `step`.
  std::size_t table(const std::string& name, std::vector<std::size_t> row, Storage storage = Storage::kDouble,
                    double step = 1.0);
  /// What the numbers of a table are, as attributes of it: "m", and "x y z" for the columns of a row.
  void describe(std::size_t table, const std::string& unit, const std::string& columns = {});
  /// Numbers of the next row of a table, in order. Kept until endRow() has gathered a chunk.
  void add(std::size_t table, double value);
  void add(std::size_t table, std::span<const double> values);
  /// The tables so far are complete; numbers of tables begin at 0 again.
  void nextTables();
  /// After the numbers of all tables for one row. Throws WriteError as soon as the disk refuses something.
  void endRow();

  /// Writes, closes and checks, so that commit() has only to rename. Throws WriteError.
  void finish();
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::hdf5
