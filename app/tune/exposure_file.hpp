// Exposure tables of result files.
#pragma once

#include <string>

#include "app/hdf5/table_reader.hpp"
#include "app/hdf5/table_writer.hpp"
#include "app/tune/exposure.hpp"

namespace abstand::tune {

/// Writes the tables `exposure`, `exposure_body`, `exposure_floor` and `outlines` (docs/margins.md, "Result
/// files"). Earlier tables are complete. Throws WriteError.
void writeExposure(const PassExposure& exposure, hdf5::TableWriter& out);

struct NameCounts {
  std::size_t parts, links;
};

/// Throws ParseError for impossible numbers, and for unknown parts and links.
PassExposure readExposure(const hdf5::TableReader& in, const NameCounts& names, const std::string& file);

}  // namespace abstand::tune
