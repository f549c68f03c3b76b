#include "app/hdf5/chunk_encoder.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace abstand::hdf5 {
namespace {

constexpr int kFastest = 1;
constexpr std::uint32_t kNotDeflated = 1u << 1;  // the second filter is left out
constexpr std::size_t kShuffled = 256;           // numbers; a constant, for vector instructions
// Of the first kShuffled bytes of a plane: with more different values it is stored as it is. Of random bytes
// some 160 differ, and no code makes them shorter.
constexpr int kDifferentInNoise = 112;
// RFC 1950 and 1951.
constexpr unsigned char kZlibHeader[] = {0x78, 0x01};
constexpr std::size_t kStoredHeader = 5, kMaxStored = 65535, kChecksum = 4;

std::size_t wholeBlocks(std::size_t rows) { return (rows + kShuffled - 1) / kShuffled * kShuffled; }

/// Copies byte after byte of all numbers to `planes`, `rows` bytes each; missing numbers are 0.
template <class Number>
void shuffle(const ChunkEncoder::Column& numbers, std::size_t rows, std::vector<std::uint64_t>& memory,
             std::byte* planes) {
  memory.resize(wholeBlocks(rows));
  auto* const whole = reinterpret_cast<Number*>(memory.data());
  for (std::size_t i = 0; i < numbers.count; ++i)
    std::memcpy(whole + i, numbers.first + i * numbers.stride, sizeof(Number));
  std::fill(whole + numbers.count, whole + wholeBlocks(rows), Number{0});
  for (std::size_t b = 0; b < sizeof(Number); ++b)
    for (std::size_t first = 0; first < rows; first += kShuffled) {
      unsigned char block[kShuffled];
      const Number* from = whole + first;
      for (std::size_t i = 0; i < kShuffled; ++i) block[i] = static_cast<unsigned char>(from[i] >> (8 * b));
      std::memcpy(planes + b * rows + first, block, std::min(kShuffled, rows - first));
    }
}

bool isNoise(const std::byte* plane, std::size_t rows) {
  if (rows < kShuffled) return false;
  std::array<bool, 256> seen{};
  int different = 0;
  for (std::size_t i = 0; i < kShuffled; ++i) {
    bool& known = seen[static_cast<unsigned char>(plane[i])];
    different += !known;
    known = true;
  }
  return different > kDifferentInNoise;
}

void put(std::byte*& to, std::initializer_list<std::size_t> bytes) {
  for (const std::size_t b : bytes) *to++ = static_cast<std::byte>(b & 0xff);
}

}  // namespace

struct ChunkEncoder::Deflate {
  Deflate() : compressor(libdeflate_alloc_compressor(kFastest)) {
    if (!compressor) throw std::bad_alloc();
  }
  ~Deflate() { libdeflate_free_compressor(compressor); }
  Deflate(const Deflate&) = delete;
  Deflate& operator=(const Deflate&) = delete;

  libdeflate_compressor* compressor;
};

ChunkEncoder::ChunkEncoder(bool deflates) : deflates_{deflates}, deflate_{std::make_unique<Deflate>()} {}

ChunkEncoder::~ChunkEncoder() = default;

/// Bytes of `deflated_` that hold `shuffled_`; 0 if there are no fewer. The lowest bytes of measured numbers
/// are noise: they are stored, the planes behind them are deflated.
std::size_t ChunkEncoder::deflate(std::size_t rows, std::size_t planes) {
  std::size_t stored = 0;
  while (stored + 1 < planes && (stored + 1) * rows <= kMaxStored &&
         isNoise(shuffled_.data() + stored * rows, rows))
    ++stored;
  const std::size_t all = shuffled_.size(), head = stored * rows;
  if (all == 0) return 0;
  deflated_.resize(all);
  if (head == 0) {
    const std::size_t bytes =
        libdeflate_zlib_compress(deflate_->compressor, shuffled_.data(), all, deflated_.data(), all - 1);
    return bytes;
  }
  std::byte* to = deflated_.data();
  const std::size_t around = std::size(kZlibHeader) + kStoredHeader + head + kChecksum;
  if (around + 1 >= all) return 0;
  put(to, {kZlibHeader[0], kZlibHeader[1], 0, head, head >> 8, ~head, ~head >> 8});
  to = std::copy_n(shuffled_.data(), head, to);
  const std::size_t rest = libdeflate_deflate_compress(deflate_->compressor, shuffled_.data() + head,
                                                       all - head, to, all - 1 - around);
  if (rest == 0) return 0;
  to += rest;
  const std::size_t sum = libdeflate_adler32(1, shuffled_.data(), all);
  put(to, {sum >> 24, sum >> 16, sum >> 8, sum});
  return around + rest;
}

ChunkEncoder::Chunk ChunkEncoder::encode(const Column& column, std::size_t rows) {
  shuffled_.resize(rows * column.size);
  if (column.size == 8)
    shuffle<std::uint64_t>(column, rows, memory_, shuffled_.data());
  else if (column.size == 4)
    shuffle<std::uint32_t>(column, rows, memory_, shuffled_.data());
  else
    shuffle<std::uint16_t>(column, rows, memory_, shuffled_.data());
  // Neighbouring columns are often equal: a part's uncertainty is the same beside every link.
  if (shuffled_ == before_) return chunk_;
  const std::size_t bytes = deflates_ ? deflate(rows, column.size) : 0;
  before_.swap(shuffled_);
  chunk_ = bytes > 0 ? Chunk{{deflated_.data(), bytes}, 0} : Chunk{before_, kNotDeflated};
  return chunk_;
}

}  // namespace abstand::hdf5
