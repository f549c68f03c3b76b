// Result file of a recording.
#pragma once

#include <filesystem>

#include "app/hdf5/table_writer.hpp"
#include "app/tune/recording_tune.hpp"
#include "core/base/content_hash.hpp"

namespace abstand::tune {

/// Writes a result while its recording is run (docs/margins.md, "Result files"): distances of all pairs frame
/// by frame, then results of the parts. The file appears completely at commit(), or not at all.
class ResultWriter {
 public:
  /// Throws WriteError.
  ResultWriter(const std::filesystem::path& file, const ContentKey& key);
  /// For PassOptions::on_frame. Throws WriteError.
  void frame(const SettledFrame& settled, const PassResult& names);
  void commit(const TunedRecording& tuned, const TuneOptions& options);

 private:
  void begin(const PassResult& names);
  void writeOptions(const TunedRecording& tuned, const TuneOptions& options);
  void writeApproaches(const std::vector<Approach>& approaches);
  void writeNeeds(const PassResult& pass);

  hdf5::TableWriter out_;
  bool begun_{false};
  std::size_t distance_{0}, bound_{0}, uncertainty_{0}, points_{0}, speeds_{0};
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

}  // namespace abstand::tune
