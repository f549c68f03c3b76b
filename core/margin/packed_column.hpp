// Values of which often all are equal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace abstand::margin {

/// A list that needs one value where all are the same. Constant after construction.
template <class Value>
class PackedColumn {
 public:
  PackedColumn() = default;
  explicit PackedColumn(const std::vector<Value>& values) : values_(values) {
    const bool same = std::all_of(values_.begin(), values_.end(),
                                  [&](const Value& value) { return value == values_.front(); });
    if (same && values_.size() > 1) values_.resize(1);
    values_.shrink_to_fit();
  }

  Value operator[](std::size_t index) const { return values_[values_.size() == 1 ? 0 : index]; }
  std::size_t bytes() const { return values_.capacity() * sizeof(Value); }

 private:
  std::vector<Value> values_;
};

}  // namespace abstand::margin
