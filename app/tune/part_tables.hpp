// Tables of body parts in a result file.
#pragma once

#include "app/hdf5/table_reader.hpp"
#include "app/hdf5/table_writer.hpp"
#include "app/tune/distance_pass.hpp"

namespace abstand::tune {

/// Number of a tool in files: 0 for a part itself, else its index + 1; and back. `tools`: how many there are.
/// Throws ParseError.
double toolNumber(std::uint16_t tool);
std::uint16_t toolOf(double number, std::size_t tools, const std::string& file);

/// Writes the tables with a row for each frame.
class PartTableWriter {
 public:
  /// Adds the tables.
  void begin(std::size_t parts, hdf5::TableWriter& out);
  /// Adds entry `i` of all lists as the numbers of the next row.
  void add(const std::vector<PartClearance>& parts, std::size_t i, hdf5::TableWriter& out);

 private:
  std::size_t t_{0}, values_{0}, separation_{0}, speeds_{0}, contact_{0}, contacts_{0};
  std::vector<double> row_;  ///< of one table
};
/// Adds the table of the worst moments of protective distances, a row for each part.
void writeWorstSeparation(const std::vector<PartClearance>& parts, hdf5::TableWriter& out);

/// Adds the table of the hardest predicted contacts, a row for each part: time, time exceeded (s), and the
/// columns of the contact. Times are NaN where nothing near ever closed in.
void writeWorstContacts(const std::vector<PartClearance>& parts, hdf5::TableWriter& out);

/// What the other tables of the file name.
struct PartTableNames {
  const std::vector<std::string>& parts;
  std::size_t links{0}, tools{0}, regions{0}, frames{0};
};

/// Reads what holds for the whole recording; the lists of frames are empty. Throws ParseError for damaged or
/// inconsistent tables, as do the functions below.
std::vector<PartClearance> readPartTables(const hdf5::TableReader& in, const PartTableNames& names,
                                          const std::string& file);
/// Fills the empty lists of all parts, some thousand frames at a time.
void readPartFrames(const hdf5::TableReader& in, const PartTableNames& names, const std::string& file,
                    std::vector<PartClearance>& parts);
/// Fills the empty lists of the part at index `p`.
void readPartFrames(const hdf5::TableReader& in, const PartTableNames& names, const std::string& file,
                    std::size_t p, PartClearance& part);

}  // namespace abstand::tune
