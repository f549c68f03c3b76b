// JUnit XML, which servers of continuous integration read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace abstand::run {

struct JunitCase {
  std::string name;
  std::string type, reason;  ///< of its failure; no reason: it passed
};

struct JunitSuite {
  std::string name, class_name;
  std::vector<JunitCase> cases;
  std::string output;  ///< what is said of all cases; empty: nothing
};

/// Throws UsageError and WriteError; the file appears whole or not at all.
void writeJunit(const JunitSuite& suite, const std::filesystem::path& file);

}  // namespace abstand::run
