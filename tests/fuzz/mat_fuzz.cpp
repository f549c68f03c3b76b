// Fuzzes the reader of MATLAB skeletons, through a file in memory: matio reads by name.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/read_all.hpp"
#include "tracking/kinect/utd_mhad.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int fd = memfd_create("fuzz", 0);
  if (fd < 0 || write(fd, data, size) != static_cast<ssize_t>(size)) return 0;
  abstand::testing::readAll([&] { return abstand::UtdMhadReader("/proc/self/fd/" + std::to_string(fd)); });
  close(fd);
  return 0;
}
