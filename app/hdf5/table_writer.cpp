#include "app/hdf5/table_writer.hpp"

#include <algorithm>
#include <cmath>

#include "app/hdf5/file_seal.hpp"
#include "app/hdf5/hdf5_handle.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::hdf5 {
namespace {

constexpr hsize_t kChunkRows = 1024;
constexpr int kDeflate = 1;

hid_t typeOf(Storage storage) {
  switch (storage) {
    case Storage::kSteps32:
      return H5T_STD_I32LE;
    case Storage::kSteps16:
      return H5T_STD_I16LE;
    case Storage::kDouble:
      break;
  }
  return H5T_IEEE_F64LE;
}

/// The smallest integer of the type represents NaN.
double steps(double value, Storage storage, double step) {
  const double largest = storage == Storage::kSteps32 ? 2147483647.0 : 32767.0;
  if (std::isnan(value)) return -largest - 1.0;
  return std::clamp(std::floor(value / step), -largest, largest);
}

/// Creation properties without time stamps.
Handle plainList() {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list.get(), false);
  return list;
}

/// A table that grows by rows, buffered in memory chunk by chunk.
struct Table {
  std::vector<hsize_t> row;
  hsize_t width{1}, rows{0};
  Storage storage{Storage::kDouble};
  double step{1.0};
  Handle set;
  std::vector<double> buffer;

  void add(double value) {
    buffer.push_back(storage == Storage::kDouble ? value : steps(value, storage, step));
  }

  bool flush() {
    if (!set || buffer.empty()) return true;
    const hsize_t more = buffer.size() / width;
    std::vector<hsize_t> start{rows}, count{more}, all{rows + more};
    for (const hsize_t n : row) {
      start.push_back(0);
      count.push_back(n);
      all.push_back(n);
    }
    bool good = H5Dset_extent(set.get(), all.data()) >= 0;
    const Handle space(H5Dget_space(set.get()), H5Sclose);
    good = good && H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(),
                                       nullptr) >= 0;
    const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
    good = good &&
           H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, buffer.data()) >= 0;
    rows += more;
    buffer.clear();
    return good;
  }
};

}  // namespace

struct TableWriter::Impl {
  explicit Impl(const std::filesystem::path& name) : file(name), out(name) {}

  std::filesystem::path file;
  OutputFile out;
  Handle handle;
  std::vector<Table> tables;
  hsize_t pending{0};
  std::string failure;  ///< first failure; empty: none

  /// Records the first failure while the library still knows its reason.
  void expect(bool good) {
    if (!good && failure.empty()) failure = systemReason();
  }
  void check() const {
    if (!failure.empty()) throw WriteError(file.string(), failure);
  }
  void flush() {
    for (Table& table : tables)
      if (failure.empty()) expect(table.flush());
    pending = 0;
    check();
  }
  void close() {
    // After a failure the library holds data that it cannot write: only releases it.
    for (Table& table : tables) table.set.reset();
    if (!handle) return;
    expect(H5Fflush(handle.get(), H5F_SCOPE_GLOBAL) >= 0);
    expect(handle.close() >= 0);
  }
  void write(const std::string& name, hid_t type, const std::vector<hsize_t>& extents, const void* values) {
    const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
    const Handle list = plainList();
    const Handle set(
        H5Dcreate2(handle.get(), name.c_str(), type, space.get(), H5P_DEFAULT, list.get(), H5P_DEFAULT),
        H5Dclose);
    expect(set && H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    check();
  }
  void attribute(const Handle& of, const std::string& name, hid_t type, const void* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle made(H5Acreate2(of.get(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT),
                      H5Aclose);
    expect(made && H5Awrite(made.get(), type, value) >= 0);
    check();
  }
  void text(const Handle& of, const std::string& name, const std::string& value) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), value.size() + 1);
    H5Tset_cset(type.get(), H5T_CSET_UTF8);
    attribute(of, name, type.get(), value.c_str());
  }
};

TableWriter::TableWriter(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {
  startLibrary();
  const Handle list(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(list.get(), kSealBytes);
  impl_->handle =
      Handle(H5Fcreate(impl_->out.named().c_str(), H5F_ACC_TRUNC, list.get(), H5P_DEFAULT), H5Fclose);
  impl_->expect(static_cast<bool>(impl_->handle));
  impl_->check();
}

TableWriter::~TableWriter() {
  if (impl_) impl_->close();
}

void TableWriter::attribute(const std::string& name, long long value) {
  impl_->attribute(impl_->handle, name, H5T_NATIVE_LLONG, &value);
}

void TableWriter::attribute(const std::string& name, double value) {
  impl_->attribute(impl_->handle, name, H5T_NATIVE_DOUBLE, &value);
}

void TableWriter::attribute(const std::string& name, const std::string& value) {
  impl_->text(impl_->handle, name, value);
}

void TableWriter::texts(const std::string& name, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.get(), H5T_VARIABLE);
  impl_->write(name, text.get(), {pointers.size()}, pointers.data());
}

void TableWriter::integers(const std::string& name, const std::vector<int>& values, std::size_t width) {
  if (values.empty()) return;
  impl_->write(name, H5T_NATIVE_INT, {values.size() / width, width}, values.data());
}

std::size_t TableWriter::table(const std::string& name, std::vector<std::size_t> row, Storage storage,
                               double step) {
  Table table;
  table.storage = storage;
  table.step = step;
  std::vector<hsize_t> now{0}, most{H5S_UNLIMITED}, chunk{kChunkRows};
  for (const std::size_t n : row) {
    table.row.push_back(n);
    table.width *= n;
    now.push_back(n);
    most.push_back(n);
    // Chunks of single columns, whose values hardly change from row to row.
    chunk.push_back(1);
  }
  if (table.width > 0) {
    const Handle space(H5Screate_simple(static_cast<int>(now.size()), now.data(), most.data()), H5Sclose);
    const Handle list = plainList();
    H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), kDeflate);
    table.set = Handle(H5Dcreate2(impl_->handle.get(), name.c_str(), typeOf(storage), space.get(),
                                  H5P_DEFAULT, list.get(), H5P_DEFAULT),
                       H5Dclose);
    impl_->expect(static_cast<bool>(table.set));
    impl_->check();
    if (storage != Storage::kDouble) impl_->attribute(table.set, "step", H5T_NATIVE_DOUBLE, &step);
  }
  impl_->tables.push_back(std::move(table));
  return impl_->tables.size() - 1;
}

void TableWriter::describe(std::size_t table, const std::string& unit, const std::string& columns) {
  const Handle& set = impl_->tables[table].set;
  if (!set) return;
  impl_->text(set, "unit", unit);
  if (!columns.empty()) impl_->text(set, "columns", columns);
}

void TableWriter::add(std::size_t table, double value) { impl_->tables[table].add(value); }

void TableWriter::add(std::size_t table, std::span<const double> values) {
  for (const double v : values) impl_->tables[table].add(v);
}

void TableWriter::nextTables() {
  impl_->flush();
  impl_->tables.clear();
}

void TableWriter::endRow() {
  if (++impl_->pending >= kChunkRows) impl_->flush();
}

void TableWriter::finish() {
  if (!impl_->handle) return;
  impl_->flush();
  impl_->close();
  impl_->check();
  seal(impl_->out.named());
  impl_->out.finish();
}

void TableWriter::commit() {
  finish();
  impl_->out.commit();
}

}  // namespace abstand::hdf5
