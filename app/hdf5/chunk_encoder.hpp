// Encodes columns of numbers as chunks of an HDF5 dataset.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace abstand::hdf5 {

/// Encodes chunks as HDF5's filters shuffle and deflate do (H5Pset_shuffle, then H5Pset_deflate), for
/// H5Dwrite_chunk(). Deflates with libdeflate, which takes a fraction of the time of zlib, and leaves out
/// what is noise. The same numbers give the same bytes. One thread.
class ChunkEncoder {
 public:
  /// `deflates`: false to shuffle only. Throws std::bad_alloc.
  explicit ChunkEncoder(bool deflates = true);
  ~ChunkEncoder();

  /// Valid until the next call.
  struct Chunk {
    std::span<const std::byte> bytes;
    /// As H5Dwrite_chunk() expects it: bit 1 is set if deflate would not make the chunk smaller.
    std::uint32_t filter_mask{0};
  };
  /// Part of a table's column.
  struct Column {
    const std::byte* first;
    std::size_t count;
    std::size_t stride;  ///< bytes from one number to the next
    std::size_t size;    ///< bytes of each number: 2, 4 or 8
  };
  /// @param rows  numbers in the chunk, at least column.count; missing ones are filled with 0
  Chunk encode(const Column& column, std::size_t rows);

 private:
  struct Deflate;
  std::size_t deflate(std::size_t rows, std::size_t planes);

  bool deflates_;
  std::unique_ptr<Deflate> deflate_;
  std::vector<std::uint64_t> memory_;  ///< of shuffle
  std::vector<std::byte> shuffled_, before_, deflated_;
  Chunk chunk_;  ///< of `before_`
};

}  // namespace abstand::hdf5
