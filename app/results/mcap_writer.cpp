#include "app/results/mcap_writer.hpp"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <vector>

#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::results {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
constexpr int kZstdLevel = 3;
constexpr std::size_t kMaxChannels = 65535;
constexpr const char* kCompression = "zstd";

/// Kinds of records ("opcodes").
enum Kind : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

std::uint32_t crc32Of(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Messages not written yet.
struct PendingChunk {
  McapBytes records;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;  ///< time, offset
  std::uint64_t first{~std::uint64_t{0}}, last{0};                                      ///< ns
};

}  // namespace

struct McapWriter::Impl {
  explicit Impl(const std::filesystem::path& name) : file(name), out(name) {}

  std::filesystem::path file;
  OutputFile out;
  std::uint64_t offset{0};
  std::uint32_t crc{0};  ///< over all bytes so far
  McapBytes schemas, channels, chunk_indices, metadata_indices;
  std::uint16_t schema_count{0};
  std::uint32_t channel_count{0}, metadata_count{0}, chunk_count{0};
  PendingChunk chunk;
  std::map<std::uint16_t, std::uint64_t> messages;  ///< count for each channel
  std::uint64_t message_count{0}, first{~std::uint64_t{0}}, last{0};

  void write(std::string_view bytes) {
    out.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    offset += bytes.size();
    crc = crc32Of(crc, bytes);
  }
  /// Returns the offset of the record.
  std::uint64_t write(Kind kind, std::string_view content) {
    const std::uint64_t begin = offset;
    write(McapBytes().record(kind, content).bytes());
    return begin;
  }

  void writeChunk() {
    if (chunk.records.size() == 0) return;
    const std::string& plain = chunk.records.bytes();
    std::string packed(ZSTD_compressBound(plain.size()), '\0');
    const std::size_t size =
        ZSTD_compress(packed.data(), packed.size(), plain.data(), plain.size(), kZstdLevel);
    if (ZSTD_isError(size)) throw WriteError(file.string(), std::string(ZSTD_getErrorName(size)));
    packed.resize(size);
    McapBytes content;
    content.number(chunk.first).number(chunk.last).number(std::uint64_t{plain.size()});
    content.number(crc32Of(0, plain)).text(kCompression).number(std::uint64_t{packed.size()}).raw(packed);
    const std::uint64_t begin = write(kChunk, content.bytes());
    const std::uint64_t index_begin = offset;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
    for (const auto& [channel, entries] : chunk.index) {
      McapBytes list;
      for (const auto& [time, at] : entries) list.number(time).number(at);
      index_offsets[channel] = write(kMessageIndex, McapBytes().number(channel).text(list.bytes()).bytes());
    }
    McapBytes index;
    index.number(chunk.first).number(chunk.last).number(begin).number(index_begin - begin);
    index.map(index_offsets).number(offset - index_begin).text(kCompression);
    index.number(std::uint64_t{packed.size()}).number(std::uint64_t{plain.size()});
    chunk_indices.record(kChunkIndex, index.bytes());
    ++chunk_count;
    chunk = PendingChunk();
  }

  std::string statistics() const {
    McapBytes content;
    content.number(message_count).number(schema_count).number(channel_count).number(std::uint32_t{0});
    content.number(metadata_count).number(chunk_count);
    content.number(message_count > 0 ? first : std::uint64_t{0}).number(last).map(messages);
    return McapBytes().record(kStatistics, content.bytes()).bytes();
  }

  /// Summary, summary offsets and footer.
  void writeSummary() {
    const std::uint64_t summary_begin = offset;
    const std::string statistics_record = statistics();
    McapBytes summary, offsets;
    const std::pair<Kind, const std::string*> groups[] = {{kSchema, &schemas.bytes()},
                                                          {kChannel, &channels.bytes()},
                                                          {kStatistics, &statistics_record},
                                                          {kChunkIndex, &chunk_indices.bytes()},
                                                          {kMetadataIndex, &metadata_indices.bytes()}};
    for (const auto& [kind, records] : groups) {
      if (records->empty()) continue;
      McapBytes group;
      group.number(std::uint8_t{kind}).number(summary_begin + summary.size());
      group.number(std::uint64_t{records->size()});
      offsets.record(kSummaryOffset, group.bytes());
      summary.raw(*records);
    }
    McapBytes footer;
    footer.number(summary_begin).number(summary_begin + summary.size());
    constexpr std::uint64_t kFooterBytes = 20;
    McapBytes checked;  // bytes covered by the footer's checksum
    checked.raw(summary.bytes()).raw(offsets.bytes());
    checked.number(std::uint8_t{kFooter}).number(kFooterBytes).raw(footer.bytes());
    write(checked.number(crc32Of(0, checked.bytes())).bytes());
  }
};

McapWriter::McapWriter(const std::filesystem::path& file, const std::string& library)
    : impl_(std::make_unique<Impl>(file)) {
  impl_->write(kMagic);
  impl_->write(kHeader, McapBytes().text("").text(library).bytes());
}

McapWriter::~McapWriter() = default;

std::uint16_t McapWriter::addSchema(const std::string& name, const std::string& schema) {
  const std::uint16_t id = ++impl_->schema_count;
  const McapBytes content = McapBytes().number(id).text(name).text("jsonschema").text(schema);
  impl_->write(kSchema, content.bytes());
  impl_->schemas.record(kSchema, content.bytes());
  return id;
}

std::uint16_t McapWriter::addChannel(std::uint16_t schema, const std::string& topic,
                                     const TextMap& metadata) {
  if (impl_->channel_count >= kMaxChannels)
    throw UsageError(impl_->file.string() + ": found more than " + std::to_string(kMaxChannels) +
                     " topics for one MCAP file, expected fewer: export fewer recordings at once");
  const auto id = static_cast<std::uint16_t>(++impl_->channel_count);
  const McapBytes content = McapBytes().number(id).number(schema).text(topic).text("json").map(metadata);
  impl_->write(kChannel, content.bytes());
  impl_->channels.record(kChannel, content.bytes());
  return id;
}

void McapWriter::addMetadata(const std::string& name, const TextMap& metadata) {
  const std::uint64_t begin = impl_->write(kMetadata, McapBytes().text(name).map(metadata).bytes());
  impl_->metadata_indices.record(kMetadataIndex,
                                 McapBytes().number(begin).number(impl_->offset - begin).text(name).bytes());
  ++impl_->metadata_count;
}

void McapWriter::add(std::uint16_t channel, std::uint64_t log_time, std::string_view json) {
  Impl& to = *impl_;
  const auto sequence = static_cast<std::uint32_t>(to.messages[channel]++);
  McapBytes content;
  content.number(channel).number(sequence).number(log_time).number(log_time).raw(json);
  to.chunk.index[channel].emplace_back(log_time, to.chunk.records.size());
  to.chunk.records.record(kMessage, content.bytes());
  to.chunk.first = std::min(to.chunk.first, log_time);
  to.chunk.last = std::max(to.chunk.last, log_time);
  to.first = std::min(to.first, log_time);
  to.last = std::max(to.last, log_time);
  ++to.message_count;
  if (to.chunk.records.size() >= kChunkBytes) to.writeChunk();
}

void McapWriter::commit() {
  impl_->writeChunk();
  impl_->write(kDataEnd, McapBytes().number(impl_->crc).bytes());
  impl_->writeSummary();
  impl_->write(kMagic);
  impl_->out.commit();
}

}  // namespace abstand::results
