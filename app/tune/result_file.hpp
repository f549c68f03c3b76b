// Result file of a recording.
#pragma once

#include <filesystem>

#include "app/hdf5/table_writer.hpp"
#include "app/tune/part_tables.hpp"
#include "app/tune/recording_tune.hpp"
#include "core/base/content_hash.hpp"

namespace abstand::tune {

/// Writes a result while its recording is run (docs/margins.md, "Result files"): values of all pairs and
/// parts frame by frame, then what holds for the whole. Keeps some thousand frames in memory. The file
/// appears completely at commit(), or not at all.
class ResultWriter {
 public:
  /// `compression`: kNone for a file that is read once and removed. Throws WriteError.
  ResultWriter(const std::filesystem::path& file, const ContentKey& key,
               hdf5::Compression compression = hdf5::Compression::kDeflate);
  /// For PassOptions::on_frame; the last entries of the parts' lists are those of the frame. Throws
  /// WriteError.
  void frame(const SettledFrame& settled, const PassResult& pass);
  /// `tuned`: the lists of its parts are not looked at if they were written frame by frame. Throws
  /// WriteError.
  void commit(const TunedRecording& tuned, const TuneOptions& options);

 private:
  void begin(const PassResult& names);
  void writeOptions(const TunedRecording& tuned, const TuneOptions& options);
  void writeApproaches(const std::vector<Approach>& approaches);
  void writeNeeds(const PassResult& pass);
  void writeEnclosed(const std::vector<humanmodel::EnclosedShare>& shares);

  hdf5::TableWriter out_;
  bool begun_{false};
  std::size_t distance_{0}, bound_{0}, uncertainty_{0}, points_{0}, speeds_{0};
  PartTableWriter parts_;
  std::vector<double> row_;  ///< of one table
};

struct StoredResult {
  TunedRecording tuned;
  TuneOptions options;
  std::string key;      ///< ContentKey::hex()
  std::string version;  ///< resultVersion() of the program that wrote it
};

/// True if the file is a complete result with this key. Verifies its checksum, not its content.
bool isResult(const std::filesystem::path& file, const ContentKey& key);

/// Throws ParseError if it is not such a file, or damaged.
StoredResult readResult(const std::filesystem::path& file);
/// The parts of a recording that was read from a result file, with the lists of their frames. Throws
/// ParseError if the file is damaged or holds another result by now.
std::vector<PartClearance> readFrames(const TunedRecording& recording);

}  // namespace abstand::tune
