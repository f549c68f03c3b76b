#include "core/store/structure_archive.hpp"

#include <istream>
#include <ostream>

namespace abstand::store {

void ArchiveWriter::bytes(const void* from, std::size_t count) {
  size_ += count;
  if (out_ == nullptr) return;
  hash_.add(from, count);
  out_->write(static_cast<const char*>(from), static_cast<std::streamsize>(count));
}

std::size_t ArchiveWriter::count(std::size_t elements, std::size_t) {
  const std::uint64_t stored = elements;
  bytes(&stored, sizeof stored);
  return elements;
}

void ArchiveReader::bytes(void* to, std::size_t count) {
  if (count > left_) throw ArchiveError("is shorter than stated in it");
  in_.read(static_cast<char*>(to), static_cast<std::streamsize>(count));
  if (!in_) throw ArchiveError("cannot be read to its end");
  left_ -= count;
  hash_.add(to, count);
}

std::size_t ArchiveReader::count(std::size_t, std::size_t bytes_each) {
  std::uint64_t stored = 0;
  bytes(&stored, sizeof stored);
  if (stored > left_ / bytes_each) throw ArchiveError("is shorter than stated in it");
  return static_cast<std::size_t>(stored);
}

}  // namespace abstand::store
