// The CSV files of a run.
#pragma once

#include <filesystem>
#include <memory>

#include "app/loop/closed_loop.hpp"
#include "app/session/session.hpp"
#include "core/base/output_file.hpp"

namespace abstand::run {

/// Which files are wanted; empty: not.
struct CsvPaths {
  std::filesystem::path pairs, objects, joints;
};

/// Writes a row a pair, object or moment. Files appear whole at commit(), or not at all.
class CsvOutputs {
 public:
  /// `loop`: null without a closed loop; else the joints' file has more columns. Throws UsageError when a
  /// place cannot be written.
  /// `live`: the pairs' file has the age of each result as last column.
  CsvOutputs(const CsvPaths& paths, const session::Session& session, const loop::ClosedLoop* loop, bool live);

  /// `results` in the order of the scene's pairs; `shown`: s, of the poses that the scene shows.
  void write(double t, double shown, const session::Session& session,
             const std::vector<query::PairResult>& results);
  /// Writes and checks what is left, so that commit() has only to rename. Throws WriteError.
  void finish();
  void commit();
  bool wanted() const { return pairs_ || objects_ || joints_; }

 private:
  void writePairs(double t, double shown, const session::Session& session,
                  const std::vector<query::PairResult>& results);
  void writeObjects(double t, const session::Session& session);
  void writeJoints(double t, const session::Session& session);

  const loop::ClosedLoop* loop_;
  bool live_;
  std::unique_ptr<OutputFile> pairs_, objects_, joints_;
  std::string line_;
};

}  // namespace abstand::run
