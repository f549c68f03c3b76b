// Handles of the HDF5 library. Internal to this module.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

namespace abstand::hdf5 {

/// Owns an HDF5 id; the destructor closes it. Negative: none.
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
  /// Closes the object; returns the library's status, 0 without an object.
  herr_t close() { return id_ >= 0 ? close_(std::exchange(id_, -1)) : 0; }

 private:
  hid_t id_{-1};
  Close close_{nullptr};
};

/// Initialises the library; called before any other use. Disables its error output and its exit handler,
/// which would retry writes that a full disk refused, and crash. Throws WriteError.
void startLibrary();

/// The system's reason in the library's error stack ("No space left on device"), or a text that the library
/// failed.
std::string systemReason();

}  // namespace abstand::hdf5
