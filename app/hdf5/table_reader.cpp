#include "app/hdf5/table_reader.hpp"

#include <cstdint>
#include <limits>
#include <optional>

#include "app/hdf5/file_seal.hpp"
#include "app/hdf5/hdf5_handle.hpp"
#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/math/transform.hpp"

namespace abstand::hdf5 {
namespace {

constexpr std::size_t kMaxTableBytes = std::size_t{2} << 30;
constexpr std::size_t kMaxTextBytes = 100000;
constexpr std::size_t kMaxTexts = 100000;

}  // namespace

std::size_t Extents::width() const {
  std::size_t width = 1;
  for (const std::size_t n : row) width *= n;
  return width;
}

struct TableReader::Impl {
  std::string file;
  Handle handle;

  [[noreturn]] void fail(const std::string& what) const { throw ParseError({file}, what); }

  Handle attribute(const std::string& name) const {
    Handle a(H5Aopen(handle.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
    if (!a) fail("found no attribute `" + name + "`, expected a file that abstand wrote");
    const Handle space(H5Aget_space(a.get()), H5Sclose);
    if (H5Sget_simple_extent_npoints(space.get()) != 1)
      fail("found a list in the attribute `" + name + "`, expected one value");
    return a;
  }
  template <class T>
  T number(const std::string& name, hid_t as, H5T_class_t expected) const {
    const Handle a = attribute(name);
    const Handle type(H5Aget_type(a.get()), H5Tclose);
    T value{};
    if (H5Tget_class(type.get()) != expected || H5Aread(a.get(), as, &value) < 0)
      fail("found no number in the attribute `" + name + "`, expected one");
    return value;
  }
  Handle set(const std::string& name) const {
    Handle s(H5Dopen2(handle.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!s) fail("found no table `" + name + "`, expected a file that abstand wrote");
    return s;
  }
  Extents extents(const Handle& s, const std::string& name) const {
    const Handle space(H5Dget_space(s.get()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if (rank < 1 || rank > 4)
      fail("found " + std::to_string(rank) + " dimensions in `" + name + "`, expected 1 to 4");
    std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr);
    return {dims.front(), {dims.begin() + 1, dims.end()}};
  }
  /// Throws ParseError if more is requested than allowed.
  void checkSize(const std::string& name, std::size_t rows, std::size_t width) const {
    if (static_cast<double>(rows) * static_cast<double>(width) * sizeof(double) >
        static_cast<double>(kMaxTableBytes))
      fail("found more than 2 GiB in `" + name + "`, expected less");
  }
  struct Range {
    std::size_t first, count;
  };
  /// `entry`: of the first extent of each row; none: all of them.
  std::vector<double> rows(const std::string& name, const Range& range, std::optional<std::size_t> entry,
                           std::size_t width) const;
  /// The numbers of a table in `space`, scaled to their unit.
  std::vector<double> values(const Handle& s, const std::string& name, std::size_t count,
                             const Handle& memory, const Handle& space) const;
};

std::vector<double> TableReader::Impl::values(const Handle& s, const std::string& name, std::size_t count,
                                              const Handle& memory, const Handle& space) const {
  const Handle type(H5Dget_type(s.get()), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) fail("found no numbers in `" + name + "`, expected some");
  std::vector<double> values(count);
  const auto read = [&](hid_t as, void* to) {
    if (count > 0 && H5Dread(s.get(), as, memory.get(), space.get(), H5P_DEFAULT, to) < 0)
      fail("`" + name + "` is damaged");
  };
  if (kind != H5T_INTEGER || H5Aexists(s.get(), "step") <= 0) {
    read(H5T_NATIVE_DOUBLE, values.data());
    return values;
  }
  double step = 0.0;
  const Handle a(H5Aopen(s.get(), "step", H5P_DEFAULT), H5Aclose);
  if (H5Aread(a.get(), H5T_NATIVE_DOUBLE, &step) < 0 || !(step > 0.0))
    fail("found a bad `step` of `" + name + "`, expected a positive number");
  // The library converts numbers one by one, so it is asked for none.
  const auto scaled = [&](auto none, hid_t as) {
    std::vector<decltype(none)> steps(count);
    read(as, steps.data());
    for (std::size_t i = 0; i < count; ++i)
      values[i] = steps[i] == none ? kNaN : static_cast<double>(steps[i]) * step;
  };
  if (H5Tget_size(type.get()) == 2)
    scaled(std::numeric_limits<std::int16_t>::min(), H5T_NATIVE_INT16);
  else
    scaled(std::numeric_limits<std::int32_t>::min(), H5T_NATIVE_INT32);
  return values;
}

std::vector<double> TableReader::Impl::rows(const std::string& name, const Range& range,
                                            std::optional<std::size_t> entry, std::size_t width) const {
  const Handle s = set(name);
  const Extents extents = this->extents(s, name);
  std::vector<hsize_t> offset{range.first}, block{range.count};
  for (const std::size_t n : extents.row) offset.push_back(0), block.push_back(n);
  std::size_t found = extents.width();
  if (entry) {
    if (extents.row.empty() || *entry >= extents.row.front())
      fail("found no entry " + std::to_string(*entry) + " in the rows of `" + name + "`, expected one");
    found /= extents.row.front();
    offset[1] = *entry, block[1] = 1;
  }
  if (found != width || range.first > extents.rows || range.count > extents.rows - range.first)
    fail("found " + std::to_string(extents.rows) + " rows of " + std::to_string(found) + " numbers in `" +
         name + "`, expected " + std::to_string(width) + " in a row, and rows up to " +
         std::to_string(range.first + range.count));
  checkSize(name, range.count, width);
  const Handle space(H5Dget_space(s.get()), H5Sclose);
  const Handle memory(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose);
  if (!memory ||
      H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, offset.data(), nullptr, block.data(), nullptr) < 0)
    fail("`" + name + "` is damaged");
  return values(s, name, range.count * width, memory, space);
}

TableReader::TableReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  startLibrary();
  impl_->file = file.string();
  noteInput(file);
  std::error_code ec;
  if (!std::filesystem::is_regular_file(file, ec)) impl_->fail("no such file, expected a readable file");
  if (const std::string broken = brokenSeal(file); !broken.empty()) impl_->fail(broken);
  impl_->handle = Handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!impl_->handle) impl_->fail("found no HDF5 file, or a damaged one, expected one that abstand wrote");
}

TableReader::~TableReader() = default;

long long TableReader::integer(const std::string& attribute) const {
  return impl_->number<long long>(attribute, H5T_NATIVE_LLONG, H5T_INTEGER);
}

double TableReader::number(const std::string& attribute) const {
  return impl_->number<double>(attribute, H5T_NATIVE_DOUBLE, H5T_FLOAT);
}

std::string TableReader::text(const std::string& name) const {
  const Handle a = impl_->attribute(name);
  const Handle type(H5Aget_type(a.get()), H5Tclose);
  const std::size_t size = H5Tget_size(type.get());
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 || size > kMaxTextBytes)
    impl_->fail("found no text in the attribute `" + name + "`, expected one");
  std::string value(size + 1, '\0');
  if (H5Aread(a.get(), type.get(), value.data()) < 0)
    impl_->fail("the attribute `" + name + "` cannot be read");
  return value.c_str();
}

std::vector<std::string> TableReader::texts(const std::string& name) const {
  const Handle s = impl_->set(name);
  const Extents extents = impl_->extents(s, name);
  const Handle type(H5Dget_type(s.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) <= 0 || !extents.row.empty() ||
      extents.rows > kMaxTexts)
    impl_->fail("found no list of texts in `" + name + "`, expected one");
  const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.get(), H5T_VARIABLE);
  std::vector<char*> pointers(extents.rows, nullptr);
  if (extents.rows > 0 && H5Dread(s.get(), text.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) < 0)
    impl_->fail("`" + name + "` is damaged");
  std::vector<std::string> values;
  for (char* p : pointers) values.emplace_back(p ? p : "");
  const Handle space(H5Dget_space(s.get()), H5Sclose);
  H5Dvlen_reclaim(text.get(), space.get(), H5P_DEFAULT, pointers.data());
  return values;
}

Extents TableReader::extents(const std::string& name) const { return impl_->extents(impl_->set(name), name); }

void TableReader::expect(const std::string& name, std::size_t rows, std::size_t width) const {
  const Extents extents = this->extents(name);
  if (extents.rows != rows || extents.width() != width)
    impl_->fail("found " + std::to_string(extents.rows) + " rows of " + std::to_string(extents.width()) +
                " numbers in `" + name + "`, expected " + std::to_string(rows) + " of " +
                std::to_string(width));
  impl_->checkSize(name, rows, width);
}

std::vector<double> TableReader::table(const std::string& name, std::size_t rows, std::size_t width) const {
  expect(name, rows, width);
  const Handle s = impl_->set(name);
  const Handle space(H5Dget_space(s.get()), H5Sclose), memory(H5Dget_space(s.get()), H5Sclose);
  return impl_->values(s, name, rows * width, memory, space);
}

std::vector<double> TableReader::rows(const std::string& name, std::size_t first, std::size_t count,
                                      std::size_t width) const {
  return impl_->rows(name, {first, count}, std::nullopt, width);
}

std::vector<double> TableReader::rowsOf(const std::string& name, std::size_t entry, std::size_t first,
                                        std::size_t count, std::size_t width) const {
  return impl_->rows(name, {first, count}, entry, width);
}

}  // namespace abstand::hdf5
