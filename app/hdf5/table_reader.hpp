// Reads tables of numbers from an HDF5 file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace abstand::hdf5 {

/// Shape of a table: number of rows, and the extents of one row.
struct Extents {
  std::size_t rows{0};
  std::vector<std::size_t> row;
  /// Numbers in each row.
  std::size_t width() const;
};

/// Reads a file of TableWriter, possibly untrusted: every type and size is checked, and at most 2 GiB are
/// read at once. All functions throw ParseError with the file and what was found. Only one thread of a
/// process may use the library at a time.
class TableReader {
 public:
  explicit TableReader(const std::filesystem::path& file);
  ~TableReader();
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  long long integer(const std::string& attribute) const;
  double number(const std::string& attribute) const;
  std::string text(const std::string& attribute) const;
  std::vector<std::string> texts(const std::string& name) const;

  Extents extents(const std::string& name) const;
  /// Throws ParseError if a table has other than `rows` rows of `width` numbers, or more than 2 GiB.
  void expect(const std::string& name, std::size_t rows, std::size_t width) const;
  /// All numbers of a table, row by row; it must have `rows` and `width`.
  std::vector<double> table(const std::string& name, std::size_t rows, std::size_t width) const;
  /// `count` rows of a table, from row `first` on; it must have this `width`. For tables of any length.
  std::vector<double> rows(const std::string& name, std::size_t first, std::size_t count,
                           std::size_t width) const;
  /// The same of one entry of the first extent of each row, with `width` numbers: of rows of parts and
  /// columns, the columns of a part.
  std::vector<double> rowsOf(const std::string& name, std::size_t entry, std::size_t first, std::size_t count,
                             std::size_t width) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::hdf5
