// JUnit XML for continuous integration servers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace abstand::run {

struct JunitCase {
  std::string name;
  std::string type, reason;  ///< type and reason of its failure; empty reason: passed
};

struct JunitSuite {
  std::string name, class_name;
  std::vector<JunitCase> cases;
  std::string output;  ///< text for the whole suite; may be empty
};

/// Throws UsageError and WriteError; the file is written completely or not at all.
void writeJunit(const JunitSuite& suite, const std::filesystem::path& file);

}  // namespace abstand::run
