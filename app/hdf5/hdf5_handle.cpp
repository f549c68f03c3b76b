#include "app/hdf5/hdf5_handle.hpp"

#include <string_view>

#include "core/base/write_error.hpp"

namespace abstand::hdf5 {

void startLibrary() {
  static const bool started = [] {
    H5dont_atexit();
    return H5open() >= 0;
  }();
  if (!started) throw WriteError("HDF5", std::string("the library does not start"));
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string systemReason() {
  std::string reason;
  // `errno = 28, error message = 'No space left on device'`
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* entry, void* out) -> herr_t {
        const std::string_view text = entry->desc ? entry->desc : "";
        constexpr std::string_view kBegin = "error message = '";
        const auto begin = text.find(kBegin);
        if (begin == text.npos) return 0;
        const auto from = begin + kBegin.size();
        *static_cast<std::string*>(out) = text.substr(from, text.find('\'', from) - from);
        return 1;
      },
      &reason);
  return reason.empty() ? "the HDF5 library failed" : reason;
}

}  // namespace abstand::hdf5
