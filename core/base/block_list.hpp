// A list that grows without copies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace abstand {

/// Gathers elements whose number is not known in advance, in blocks: a growing std::vector needs up to three
/// times the memory of its elements while it is copied. One thread.
template <class T>
class BlockList {
 public:
  /// The default is the size from which glibc always returns memory to the system (M_MMAP_THRESHOLD,
  /// mallopt(3)).
  explicit BlockList(std::size_t block_bytes = std::size_t{32} << 20)
      : block_size_{std::max<std::size_t>(1, block_bytes / sizeof(T))} {}

  std::size_t size() const {
    return blocks_.empty() ? 0 : (blocks_.size() - 1) * block_size_ + blocks_.back().size();
  }
  void add(T element) {
    if (blocks_.empty() || blocks_.back().size() == block_size_) {
      blocks_.emplace_back();
      // The first block grows like any vector: most lists are short.
      if (blocks_.size() > 1) blocks_.back().reserve(block_size_);
    }
    blocks_.back().push_back(std::move(element));
  }
  /// All elements; the list is empty afterwards. Needs the memory of one block beside them.
  std::vector<T> take() {
    std::vector<T> all;
    if (blocks_.size() == 1) {
      all = std::move(blocks_.front());
    } else {
      all.reserve(size());
      for (std::vector<T>& block : blocks_) {
        std::move(block.begin(), block.end(), std::back_inserter(all));
        std::vector<T>().swap(block);
      }
    }
    blocks_.clear();
    return all;
  }

 private:
  std::size_t block_size_;
  std::vector<std::vector<T>> blocks_;
};

}  // namespace abstand
