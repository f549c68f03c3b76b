// Typed ids: an ObjectId cannot be passed where a PairId is expected.
#pragma once

#include <compare>
#include <cstdint>

namespace abstand {

template <class Tag>
class Id {
 public:
  constexpr explicit Id(std::uint32_t index) : index_{index} {}
  constexpr std::uint32_t index() const { return index_; }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  std::uint32_t index_;
};

using ObjectId = Id<struct ObjectTag>;
using PairId = Id<struct PairTag>;

}  // namespace abstand
