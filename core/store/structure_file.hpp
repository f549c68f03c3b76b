// One structure in a file of its own, to be given to others. Layout: docs/structure-files.md.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/store/structure_cache.hpp"

namespace abstand::store {

/// What a file says of a body in its documented sections.
struct StoredBody {
  std::string name;
  std::shared_ptr<const geometry::Surface> surface;
  structure::HapticOptions options;
};

/// Written whole or not at all. Throws UsageError and WriteError. Any thread.
void saveStructure(const structure::HapticStructure& structure, const std::filesystem::path& file);

/// The body alone; a structure is built from it, or found in a cache. Everything is checked, so the file may
/// be anybody's. Throws ParseError. Any thread.
StoredBody readStoredBody(const std::filesystem::path& file);
/// The same for the content of a file; `name` goes into errors.
StoredBody parseStoredBody(std::string_view content, const std::string& name);

/// With what the engine had in memory, as it stands: for files of the user's own, as nothing protects from
/// one that somebody forged. Null where another version of the engine wrote it. Throws ParseError. Any
/// thread.
std::shared_ptr<const structure::HapticStructure> readStoredStructure(const std::filesystem::path& file);

/// The structure of a file: as the engine had it in memory, where the file is `trusted` and of this version
/// of the engine, else built from the body, or found in `cache`. Throws ParseError.
std::shared_ptr<const structure::HapticStructure> loadStructure(const std::filesystem::path& file,
                                                                bool trusted, StructureCache& cache,
                                                                int threads);

}  // namespace abstand::store
