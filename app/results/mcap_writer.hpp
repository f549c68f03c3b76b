// Writes MCAP files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/results/mcap_bytes.hpp"

namespace abstand::results {

/// Writes an MCAP file (https://mcap.dev/spec, version 0) of JSON messages with JSON schemas. Messages are
/// collected in chunks (zstd), each with message indices; the summary, its offsets and checksums follow. The
/// file appears completely at commit(), or not at all. The same input gives the same bytes with the same
/// version of zstd.
class McapWriter {
 public:
  /// `library`: name and version of the writing program. Throws UsageError and WriteError as OutputFile.
  McapWriter(const std::filesystem::path& file, const std::string& library);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Returns its id. `schema`: JSON Schema of an object.
  std::uint16_t addSchema(const std::string& name, const std::string& schema);
  /// Adds a topic with messages of that schema; returns its id. Throws UsageError for more than 65,535.
  std::uint16_t addChannel(std::uint16_t schema, const std::string& topic, const TextMap& metadata);
  void addMetadata(const std::string& name, const TextMap& metadata);
  /// `log_time`: ns. Files with increasing times are read fastest.
  void add(std::uint16_t channel, std::uint64_t log_time, std::string_view json);
  /// Throws WriteError.
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace abstand::results
