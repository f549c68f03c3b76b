// Terms of the protective distance from a table that a user can replace by that of another edition.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/config/cited_value.hpp"
#include "core/safety/protective_distance.hpp"

namespace abstand::safety {

/// Numbers of SeparationOptions as an edition of a standard states them, each with its source.
struct SeparationStandard {
  struct Term {
    std::string key;  ///< a number of SeparationOptions
    config::CitedValue cited;
  };

  std::string title, edition, note, origin;
  std::vector<std::string> to_be_checked;
  std::vector<Term> terms;  ///< in the order of SeparationOptions
  std::string file;
  ContentKey content;  ///< of the file

  const Term* term(const std::string& key) const;  ///< null: the table does not state it
  /// Default options with the numbers of the table.
  SeparationOptions options() const;
  /// "title, edition, file name, content hash", for reports.
  std::string stamp() const;
};

/// Reads a table; docs/margins.md lists the keys. Throws ParseError with file, line and column for unknown
/// keys, numbers outside of the range of SeparationOptions, an unlisted source, and a table without the
/// speeds of people and `near`, which always come from an edition.
SeparationStandard loadSeparationStandard(const std::filesystem::path& file);

/// The same for a text; `file` is its name in errors.
SeparationStandard parseSeparationStandard(const std::string& text, const std::string& file);

/// The table included with the project: data/standards/iso_13855_2010.yaml.
std::filesystem::path defaultSeparationTable();

}  // namespace abstand::safety
