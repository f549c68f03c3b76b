// The dense log of a run (HDF5); the only fence around that library.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/session/session.hpp"

namespace abstand::run {

/// Datasets, one row a frame: /t [s], /distance and /bound [m] (frame x pair), /force [N] (frame x pair x 3,
/// on the first body), /q and /effort (frame x joint), in live mode /age [s] (frame x pair), with the names
/// in /objects and /pairs (index pairs) and the format's version as attribute `abstand`. Flushed every 256
/// frames; renamed into place at commit().
class SessionLog {
 public:
  SessionLog(const std::filesystem::path& file, const session::Session& session, bool live);
  ~SessionLog();
  /// `shown`: s, of the poses that the scene shows. Throws WriteError as soon as the disk refuses something.
  void write(double t, double shown, const session::Session& session,
             const std::vector<query::PairResult>& results);
  /// Writes, closes and checks, so that commit() has only to rename. Throws WriteError.
  void finish();
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::run
