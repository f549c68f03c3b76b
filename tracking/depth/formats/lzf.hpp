// LZF, the packing of PCD files.
#pragma once

#include <string>
#include <string_view>

namespace abstand::tracking {

/// Unpacks what Marc Lehmann's LibLZF packs: a byte below 32 copies so many bytes and one; any other copies
/// from what was unpacked, 3 bits of length (7: one more byte) and 13 bits of distance. Memory grows with
/// what is unpacked, up to `most` bytes. False where the input is damaged or gives more.
bool unpackLzf(std::string_view packed, std::size_t most, std::string& out);

}  // namespace abstand::tracking
