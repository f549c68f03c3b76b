// Structures in files of their own.
#pragma once

#include <filesystem>
#include <memory>

#include "core/structure/haptic_structure.hpp"

namespace abstand::python {

/// Writes name, surface and all fields of a structure, whole or not at all. Throws UsageError, WriteError.
void saveStructure(const structure::HapticStructure& structure, const std::filesystem::path& file);

/// The same bits that were saved. Throws ParseError for a file that is none, of another version of the
/// engine, cut short or damaged. The checksum is against accidents, not against somebody who means harm.
std::shared_ptr<const structure::HapticStructure> loadStructure(const std::filesystem::path& file);

}  // namespace abstand::python
