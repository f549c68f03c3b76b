// Exposure in a result file.
#pragma once

#include <string>

#include "app/hdf5/table_reader.hpp"
#include "app/hdf5/table_writer.hpp"
#include "app/tune/exposure.hpp"

namespace abstand::tune {

/// The tables `exposure`, `exposure_body`, `exposure_floor` and `outlines` (docs/margins.md, "Result files").
/// The tables before are complete. Throws WriteError.
void writeExposure(const PassExposure& exposure, hdf5::TableWriter& out);

struct NameCounts {
  std::size_t parts, links;
};

/// Throws ParseError for numbers that cannot be, and for parts and links that are not there.
PassExposure readExposure(const hdf5::TableReader& in, const NameCounts& names, const std::string& file);

}  // namespace abstand::tune
