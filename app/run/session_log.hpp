// HDF5 log of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/hdf5/table_writer.hpp"
#include "app/session/session.hpp"

namespace abstand::run {

/// Datasets, one row for each frame: /t [s], /distance and /bound [m] (frame x pair), /force [N] (frame x
/// pair x 3, on the first body), /q and /effort (frame x joint), in live mode /age [s] (frame x pair); names
/// in /objects and /pairs (index pairs); the format version is the attribute `abstand`. Flushed every 1,024
/// frames; renamed into place by commit().
class SessionLog {
 public:
  SessionLog(const std::filesystem::path& file, const session::Session& session, bool live);
  /// `shown`: s, time of the scene's poses. Throws WriteError immediately on disk errors.
  void write(double t, double shown, const session::Session& session,
             const std::vector<query::PairResult>& results);
  /// Writes, closes and checks, so that commit() only renames. Throws WriteError.
  void finish();
  void commit();

 private:
  hdf5::TableWriter out_;
  std::size_t t_, distance_, bound_, force_, pose_uncertainty_, q_, effort_;  ///< tables
  std::optional<std::size_t> age_;
};

}  // namespace abstand::run
