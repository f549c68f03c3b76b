// The CSV files of a run.
#pragma once

#include <filesystem>
#include <memory>

#include "app/loop/closed_loop.hpp"
#include "app/session/session.hpp"
#include "core/base/output_file.hpp"

namespace abstand {

/// Which files are wanted; empty: not.
struct CsvPaths {
  std::filesystem::path pairs, objects, joints;
};

/// Writes a row a pair, object or moment. Files appear whole at commit(), or not at all.
class CsvOutputs {
 public:
  /// `loop`: null without a closed loop; else the joints' file has more columns. Throws UsageError when a
  /// place cannot be written.
  CsvOutputs(const CsvPaths& paths, const Session& session, const ClosedLoop* loop = nullptr);

  /// `results` in the order of the scene's pairs.
  void write(double t, const Session& session, const std::vector<PairResult>& results);
  void commit();
  bool wanted() const { return pairs_ || objects_ || joints_; }

 private:
  void writePairs(double t, const Session& session, const std::vector<PairResult>& results);
  void writeObjects(double t, const Session& session);
  void writeJoints(double t, const Session& session);

  const ClosedLoop* loop_;
  std::unique_ptr<OutputFile> pairs_, objects_, joints_;
  std::string line_;
};

}  // namespace abstand
