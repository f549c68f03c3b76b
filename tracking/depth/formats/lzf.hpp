// LZF decompression, for PCD files.
#pragma once

#include <string>
#include <string_view>

namespace abstand::tracking {

/// Decompresses the format of Marc Lehmann's LibLZF: a byte n below 32 is followed by n + 1 literal bytes;
/// any other is a back reference, 3 bits of length (7: one more byte) and 13 bits of distance. Memory grows
/// with the output, up to `max_size` bytes. False if the input is damaged or the output larger.
bool unpackLzf(std::string_view packed, std::size_t max_size, std::string& out);

}  // namespace abstand::tracking
