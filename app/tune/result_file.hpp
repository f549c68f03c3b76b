// Result file of a recording.
#pragma once

#include <filesystem>
#include <limits>

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

/// `max_frames`: of single parts; of a file with more, the lists of frames are left empty. Throws ParseError
/// if it is not such a file, or damaged.
StoredResult readResult(const std::filesystem::path& file,
                        std::size_t max_frames = std::numeric_limits<std::size_t>::max());

/// Reads the frames of a recording whose other data were read from a result file. One thread.
class FrameReader {
 public:
  /// Throws ParseError if the file is damaged or contains another result by now, as do the functions.
  explicit FrameReader(const TunedRecording& recording);
  /// Fills the empty lists of all parts.
  void read(std::vector<PartClearance>& parts) const;
  /// Fills the empty lists of the part at index `p`.
  void read(std::size_t p, PartClearance& part) const;

 private:
  PartTableNames names() const;

  const TunedRecording& recording_;
  hdf5::TableReader in_;
  std::vector<std::string> parts_;
};

}  // namespace abstand::tune
