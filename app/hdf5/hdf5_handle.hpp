// Handles of the HDF5 library. Internal to this module.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

namespace abstand::hdf5 {

/// Closes its object at the end. Negative: none.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this == &other) return *this;
    reset();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
    return *this;
  }
  explicit operator bool() const { return id_ >= 0; }
  hid_t get() const { return id_; }
  void reset() { close(); }
  /// What the library answers; 0 without an object.
  herr_t close() { return id_ >= 0 ? close_(std::exchange(id_, -1)) : 0; }

 private:
  hid_t id_{-1};
  Close close_{nullptr};
};

/// Once, before anything else of the library; it prints no errors of its own and has no exit handler, which
/// would write what a full disk refused before, and crash over it. Throws WriteError.
void startLibrary();

/// The system's reason in the library's stack of errors ("No space left on device"), or that the library
/// failed.
std::string systemReason();

}  // namespace abstand::hdf5
