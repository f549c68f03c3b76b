// The CSV files of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/loop/closed_loop.hpp"
#include "app/session/session.hpp"
#include "core/base/output_file.hpp"

namespace abstand::run {

/// Output paths; empty: not written.
struct CsvPaths {
  std::filesystem::path pairs, objects, joints, cycles;
  int cycles_every{1};  ///< rows of `cycles`: the first of so many cycles
};

/// Writes one row for each pair, object, time or cycle. Files appear completely at commit(), or not at all.
class CsvOutputs {
 public:
  /// `loop`: null without a closed loop; otherwise the joints' file has more columns. Throws UsageError if a
  /// file cannot be written.
  /// `live`: the last column of the pairs' file is the age of each result.
  CsvOutputs(const CsvPaths& paths, const session::Session& session, const loop::ClosedLoop* loop, bool live);

  /// Keeps a cycle for the next write(). `worked`: s.
  void addCycle(double t, double worked, const std::vector<query::PairResult>& results);
  /// `results` in the order of the scene's pairs; `shown`: s, time of the scene's poses.
  void write(double t, double shown, const session::Session& session,
             const std::vector<query::PairResult>& results);
  /// Writes and checks the remaining data, so that commit() only renames. Throws WriteError.
  void finish();
  void commit();

 private:
  void writePairs(double t, double shown, const session::Session& session,
                  const std::vector<query::PairResult>& results);
  void writeObjects(double t, const session::Session& session);
  void writeJoints(double t, const session::Session& session);
  void writeCycles();

  const loop::ClosedLoop* loop_;
  bool live_;
  std::unique_ptr<OutputFile> pairs_, objects_, joints_, cycles_;
  struct Cycle {
    long number;
    double t, worked;  // s
    long colliding;    // pairs
  };
  std::vector<Cycle> kept_;
  int cycles_every_;
  long cycle_count_{0};
  std::string line_;
};

}  // namespace abstand::run
