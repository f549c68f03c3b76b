#include "app/hdf5/chunk_encoder.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <new>

namespace abstand::hdf5 {
namespace {

constexpr int kFastest = 1;
constexpr std::uint32_t kNotDeflated = 1u << 1;  // the second filter is left out

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

ChunkEncoder::ChunkEncoder(std::size_t rows) : rows_{rows}, deflate_{std::make_unique<Deflate>()} {}

ChunkEncoder::~ChunkEncoder() = default;

ChunkEncoder::Chunk ChunkEncoder::encode(const std::byte* numbers, std::size_t count, std::size_t stride,
                                         std::size_t size) {
  // The first bytes of all numbers, then their second bytes, and so on.
  shuffled_.assign(rows_ * size, std::byte{0});
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < size; ++b) shuffled_[b * rows_ + i] = numbers[i * stride + b];
  // Neighbouring columns are often equal: a part's uncertainty is the same beside every link.
  if (shuffled_ == before_) return chunk_;
  deflated_.resize(shuffled_.size());
  const std::size_t bytes =
      libdeflate_zlib_compress(deflate_->compressor, shuffled_.data(), shuffled_.size(), deflated_.data(),
                               deflated_.size() - std::min<std::size_t>(deflated_.size(), 1));
  before_.swap(shuffled_);
  chunk_ = bytes > 0 ? Chunk{{deflated_.data(), bytes}, 0} : Chunk{before_, kNotDeflated};
  return chunk_;
}

}  // namespace abstand::hdf5
