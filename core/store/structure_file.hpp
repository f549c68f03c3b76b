// A structure in a file of its own, for exchange. Layout: docs/structure-files.md.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/store/structure_cache.hpp"

namespace abstand::store {

/// Content of the documented sections of a file.
struct StoredBody {
  std::string name;
  std::shared_ptr<const geometry::Surface> surface;
  structure::HapticOptions options;
};

/// Written completely or not at all. Throws UsageError and WriteError. Any thread.
void saveStructure(const structure::HapticStructure& structure, const std::filesystem::path& file);

/// Reads the body only; a structure is built from it, or found in a cache. Everything is validated, so the
/// file may be untrusted. Throws ParseError. Any thread.
StoredBody readStoredBody(const std::filesystem::path& file);
/// The same for the content of a file; `name` is used in errors.
StoredBody parseStoredBody(std::string_view content, const std::string& name);

/// Reads the engine's memory image without validation: only for the user's own files, as a forged one is not
/// detected. Null if another version of the engine wrote it. Throws ParseError. Any thread.
std::shared_ptr<const structure::HapticStructure> readStoredStructure(const std::filesystem::path& file);

/// Loads the structure of a file: from the memory image if the file is `trusted` and of this engine version,
/// otherwise built from the body or found in `cache`. Throws ParseError.
std::shared_ptr<const structure::HapticStructure> loadStructure(const std::filesystem::path& file,
                                                                bool trusted, StructureCache& cache,
                                                                int threads);

}  // namespace abstand::store
