// Tables of numbers, read back from an HDF5 file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace abstand::hdf5 {

/// Of a table: rows and the extents of one row.
struct Extents {
  std::size_t rows{0};
  std::vector<std::size_t> row;
  /// Numbers in a row.
  std::size_t width() const;
};

/// A file of TableWriter, or of anyone: every type and size is checked, and no more than 2 GiB are read at
/// once. All functions throw ParseError, with the file and what was found. One thread at a time uses
/// the library in a process.
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
  /// All numbers of a table, row by row. With `rows` and `width` that the caller expects.
  std::vector<double> table(const std::string& name, std::size_t rows, std::size_t width) const;
  /// Some rows of a table, from row `first` on; the table has that `width`. So a table of any length is read.
  std::vector<double> rows(const std::string& name, std::size_t first, std::size_t count,
                           std::size_t width) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::hdf5
