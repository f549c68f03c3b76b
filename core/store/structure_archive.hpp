// Binary serialisation of objects.
#pragma once

#include <bit>
#include <concepts>
#include <iosfwd>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/content_hash.hpp"
#include "core/math/transform.hpp"

namespace abstand::store {

static_assert(std::endian::native == std::endian::little && std::numeric_limits<double>::is_iec559,
              "archives hold numbers as a little-endian machine with IEEE 754 does");
static_assert(sizeof(std::size_t) == sizeof(std::uint64_t), "sizes are fields of 64 bits");

/// The data read is not a valid archive; the message is a predicate ("is shorter than stated in it").
class ArchiveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Common part of reader and writer. A class is archived by one member that lists its fields in order,
///   template <class Archive> void archive(Archive& ar) { ar(first_, second_); }
/// Fields are numbers, enumerations, fixed-size Eigen matrices, arrays, strings, optionals, vectors, and
/// classes with such a member. A vector is stored as one block of bytes if its elements are trivially
/// copyable without an archive member, or declare `using ArchivedAsBytes = void;` (for those with Eigen
/// members); such elements contain no pointers.
template <class Side>
class Archive {
 public:
  template <class... Fields>
  void operator()(Fields&... fields) {
    (field(fields), ...);
  }

 private:
  template <class T>
  static constexpr bool kTakesPart = requires(T& value, Side& side) {
    value.archive(side);
  };
  template <class T>
  static constexpr bool kIsMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;
  template <class T>
  static constexpr bool kSaysBytes = requires {
    typename T::ArchivedAsBytes;
  };
  template <class T>
  static constexpr bool kIsFlat = kIsMatrix<T> || kSaysBytes<T> ||
                                  (std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> &&
                                   !kTakesPart<T>);

  Side& side() { return static_cast<Side&>(*this); }

  template <class T>
  void field(T& value) {
    if constexpr (kTakesPart<T>) {
      value.archive(side());
    } else if constexpr (kIsMatrix<T>) {
      static_assert(T::SizeAtCompileTime != Eigen::Dynamic &&
                    sizeof(T) == T::SizeAtCompileTime * sizeof(value(0)));
      side().bytes(value.data(), sizeof(T));
    } else if constexpr (std::same_as<T, bool>) {
      std::uint8_t byte = value ? 1 : 0;
      side().bytes(&byte, 1);
      if constexpr (Side::kReads) value = byte != 0;
    } else {
      static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "not a field that an archive can hold");
      side().bytes(&value, sizeof value);
    }
  }

  template <class T, std::size_t n>
  void field(T (&values)[n]) {
    for (T& value : values) field(value);
  }

  template <class T>
  void field(std::optional<T>& value) {
    bool there = value.has_value();
    field(there);
    if constexpr (Side::kReads) {
      value.reset();
      if (there) value.emplace();
    }
    if (there) field(*value);
  }

  void field(std::string& text) {
    const std::size_t count = side().count(text.size(), 1);
    if constexpr (Side::kReads) text.resize(count);
    side().bytes(text.data(), count);
  }

  template <class T>
  void field(std::vector<T>& values) {
    if constexpr (kIsFlat<T>) {
      const std::size_t count = side().count(values.size(), sizeof(T));
      if constexpr (Side::kReads) values.resize(count);
      side().bytes(values.data(), count * sizeof(T));
    } else {
      const std::size_t count = side().count(values.size(), 1);
      if constexpr (Side::kReads) values.clear();
      for (std::size_t i = 0; i < count; ++i) {
        // One element at a time, so that a wrong count fails at the end of the file before it allocates
        // memory.
        if constexpr (Side::kReads) values.emplace_back();
        field(values[i]);
      }
    }
  }
};

/// Writes to a stream, or with null only counts bytes. The stream's state shows errors.
class ArchiveWriter : public Archive<ArchiveWriter> {
 public:
  static constexpr bool kReads = false;
  explicit ArchiveWriter(std::ostream* out) : out_(out) {}

  std::uint64_t size() const { return size_; }
  /// Of all bytes written so far.
  ContentKey checksum() const { return hash_.value(); }

  void bytes(const void* from, std::size_t count);
  std::size_t count(std::size_t elements, std::size_t bytes_each);

 private:
  std::ostream* out_;
  std::uint64_t size_{0};
  ContentHash hash_;
};

/// Reads at most `size` bytes from a stream; throws ArchiveError instead of reading further or allocating
/// more than the remaining bytes.
class ArchiveReader : public Archive<ArchiveReader> {
 public:
  static constexpr bool kReads = true;
  ArchiveReader(std::istream& in, std::uint64_t size) : in_(in), left_(size) {}

  std::uint64_t left() const { return left_; }
  /// Of all bytes read so far.
  ContentKey checksum() const { return hash_.value(); }

  void bytes(void* to, std::size_t count);
  std::size_t count(std::size_t ignored, std::size_t bytes_each);

 private:
  std::istream& in_;
  std::uint64_t left_;
  ContentHash hash_;
};

}  // namespace abstand::store
