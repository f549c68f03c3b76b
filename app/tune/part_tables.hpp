// Tables of body parts in a result file.
#pragma once

#include "app/hdf5/table_reader.hpp"
#include "app/hdf5/table_writer.hpp"
#include "app/tune/distance_pass.hpp"

namespace abstand::tune {

/// Adds the tables with a row for each frame.
void writePartTables(const std::vector<PartClearance>& parts, hdf5::TableWriter& out);
/// Adds the table of the worst moments of protective distances, a row for each part.
void writeWorstSeparation(const std::vector<PartClearance>& parts, hdf5::TableWriter& out);

/// What the other tables of the file name.
struct PartTableNames {
  const std::vector<std::string>& parts;
  std::size_t links{0}, frames{0};
};

/// Reads both, some thousand frames at a time. Throws ParseError for damaged or inconsistent tables.
std::vector<PartClearance> readPartTables(const hdf5::TableReader& in, const PartTableNames& names,
                                          const std::string& file);

}  // namespace abstand::tune
