// HDF5 log of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/hdf5/table_writer.hpp"
#include "app/session/session.hpp"

namespace abstand::run {

/// Every frame of a run, with the histories of poses, velocities and contacts of each object (thesis, 4.2.1).
/// The tables and their units stand in docs/session-log.md; each has an attribute `unit`, and `columns` where
/// a row has several. World frame, SI units. Appears under its name at commit(), whole or not at all.
class SessionLog {
 public:
  static constexpr long long kFormat = 2;
  /// m: nearest points of pairs that are farther apart are left out.
  static constexpr double kPointsWithin = 0.5;

  /// `program`: version of the program that writes. Throws WriteError, and ParseError for an input file that
  /// can no longer be read.
  SessionLog(const std::filesystem::path& file, const session::Session& session, bool live,
             const std::string& program);
  /// `shown`: s, of the poses that the scene shows. Throws WriteError as soon as the disk refuses something.
  void write(double t, double shown, const session::Session& session,
             const std::vector<query::PairResult>& results);
  /// Writes, closes and checks, so that commit() only renames. Throws WriteError.
  void finish();
  void commit();

 private:
  void writePairs(const std::vector<query::PairResult>& results);
  void writeObjects(const scene::Scene& scene);

  hdf5::TableWriter out_;
  struct PairTables {
    std::size_t distance, bound, force, torque, points, contacts;
  } pair_;
  struct ObjectTables {
    std::size_t pose, velocity, mean_velocity, uncertainty, state, contact_force, contacts;
  } object_;
  std::size_t t_, q_, effort_;
  std::optional<std::size_t> age_;
};

}  // namespace abstand::run
