# cmake -DSOURCES=a;b;c -DNAME=kName -DWHAT=words -DOUT=file -P WriteFingerprint.cmake: writes a header with a hash of the sources.
set(all "")
foreach(source IN LISTS SOURCES)
  file(SHA256 ${source} hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 short)
file(WRITE ${OUT} "// Written by scripts/cmake/WriteFingerprint.cmake.\n#pragma once\n\n#include <cstdint>\n
namespace abstand {\n
/// Hash of the sources that ${WHAT}.
inline constexpr std::uint64_t ${NAME} = 0x${short};\n
}  // namespace abstand\n")
