// The dense log of a run (HDF5); the only fence around that library.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/session/session.hpp"

namespace abstand {

/// Datasets, one row a frame: /t [s], /distance and /bound [m] (frame x pair), /force [N] (frame x pair x 3,
/// on the first body), /q and /effort (frame x joint), with the names in /objects and /pairs (index pairs)
/// and the format's version as attribute `abstand`. Flushed every 256 frames; renamed into place at commit().
class SessionLog {
 public:
  SessionLog(const std::filesystem::path& file, const Session& session);
  ~SessionLog();
  void write(double t, const Session& session, const std::vector<PairResult>& results);
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand
