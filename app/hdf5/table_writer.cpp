#include "app/hdf5/table_writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "app/hdf5/chunk_encoder.hpp"
#include "app/hdf5/file_seal.hpp"
#include "app/hdf5/hdf5_handle.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::hdf5 {
namespace {

// Rows of a chunk at most: HDF5 reads whole chunks, so those of a shorter table have only its rows.
constexpr hsize_t kChunkRows = 1024;
constexpr int kDeflate = 1;
constexpr std::size_t kStripBytes = 64;  // a cache line
constexpr std::size_t kMetadataBytes = std::size_t{4} << 20;

// Numbers are kept in memory as in the file.
static_assert(std::endian::native == std::endian::little);

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

/// Whole steps, rounded down and clipped. The smallest integer represents NaN.
template <class Integer>
Integer steps(double value, double step) {
  constexpr Integer kMax = std::numeric_limits<Integer>::max();
  const double exact = value / step;
  if (!(exact > -static_cast<double>(kMax)))
    return std::isnan(exact) ? std::numeric_limits<Integer>::min() : static_cast<Integer>(-kMax);
  if (exact >= static_cast<double>(kMax)) return kMax;
  // Without std::floor(), which is a call.
  const auto towards_zero = static_cast<Integer>(exact);
  return static_cast<Integer>(towards_zero - (exact < static_cast<double>(towards_zero)));
}

/// Creation properties without time stamps.
Handle plainList() {
  Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list.get(), false);
  return list;
}

/// Rows are only appended, so the library need not keep what says where earlier chunks are: 32 MB by default.
void limitMetadata(hid_t access) {
  H5AC_cache_config_t config{};
  config.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  if (H5Pget_mdc_config(access, &config) < 0) return;
  config.max_size = kMetadataBytes;
  config.initial_size = std::min(config.initial_size, config.max_size);
  H5Pset_mdc_config(access, &config);
}

/// A table that grows by rows. Rows are kept in memory, in the file's type, until they fill a chunk.
struct Table {
  std::string name, unit, columns;
  std::vector<hsize_t> row;
  hsize_t width{1}, rows{0}, chunk_rows{0};
  Storage storage{Storage::kDouble};
  double step{1.0};
  Handle set;  ///< once a chunk is full, or the table complete
  std::vector<std::byte> buffer;

  std::size_t size() const {
    return storage == Storage::kDouble    ? sizeof(double)
           : storage == Storage::kSteps32 ? sizeof(std::int32_t)
                                          : sizeof(std::int16_t);
  }
  void add(std::span<const double> values) {
    const std::size_t at = buffer.size();
    buffer.resize(at + values.size() * size());
    std::byte* to = buffer.data() + at;
    const auto put = [&](auto number) {
      std::memcpy(to, &number, sizeof number);
      to += sizeof number;
    };
    if (storage == Storage::kDouble)
      for (const double v : values) put(v);
    else if (storage == Storage::kSteps32)
      for (const double v : values) put(steps<std::int32_t>(v, step));
    else
      for (const double v : values) put(steps<std::int16_t>(v, step));
  }

  std::size_t rowsKept() const { return buffer.size() / (width * size()); }

  /// Writes the full chunks, or all rows.
  bool flush(ChunkEncoder& encoder, bool all) {
    const std::size_t bytes = width * size();
    std::size_t left = rowsKept(), done = 0;
    while (left >= chunk_rows || (all && left > 0)) {
      const std::size_t count = std::min<std::size_t>(left, chunk_rows);
      if (!writeChunks(encoder, buffer.data() + done * bytes, count)) return false;
      done += count;
      left -= count;
    }
    buffer.erase(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(done * bytes));
    return true;
  }

 private:
  /// Writes `count` rows, one chunk a column.
  bool writeChunks(ChunkEncoder& encoder, const std::byte* first, std::size_t count) {
    std::vector<hsize_t> extents{rows + count}, offset(row.size() + 1, 0);
    extents.insert(extents.end(), row.begin(), row.end());
    if (H5Dset_extent(set.get(), extents.data()) < 0) return false;
    offset[0] = rows;
    // Some columns of all rows at once, so that a row is fetched into the cache only once for them.
    const std::size_t bytes = width * size(), strip = kStripBytes / size();
    std::vector<std::byte> strips(count * kStripBytes);
    for (std::size_t c = 0; c < width; ++c) {
      if (c % strip == 0) {
        const std::size_t wanted = std::min(kStripBytes, bytes - c * size());
        for (std::size_t r = 0; r < count; ++r)
          std::memcpy(strips.data() + r * kStripBytes, first + r * bytes + c * size(), wanted);
      }
      const auto chunk =
          encoder.encode({strips.data() + c % strip * size(), count, kStripBytes, size()}, chunk_rows);
      std::size_t rest = c;
      for (std::size_t d = row.size(); d > 0; rest /= row[--d]) offset[d] = rest % row[d - 1];
      if (H5Dwrite_chunk(set.get(), H5P_DEFAULT, chunk.filter_mask, offset.data(), chunk.bytes.size(),
                         chunk.bytes.data()) < 0)
        return false;
    }
    rows += count;
    return true;
  }
};

}  // namespace

struct TableWriter::Impl {
  Impl(const std::filesystem::path& name, Compression compression)
      : file(name), out(name), encoder(compression == Compression::kDeflate) {}

  std::filesystem::path file;
  OutputFile out;
  Handle handle;
  std::vector<Table> tables;
  ChunkEncoder encoder;
  hsize_t pending{0};
  std::string failure;  ///< first failure; empty: none

  /// Records the first failure while the library still knows its reason.
  void expect(bool good) {
    if (!good && failure.empty()) failure = systemReason();
  }
  void check() const {
    if (!failure.empty()) throw WriteError(file.string(), failure);
  }
  void flush(bool all) {
    for (Table& table : tables) {
      if (table.width == 0) continue;
      if (!table.set) create(table, all ? std::clamp<hsize_t>(table.rowsKept(), 1, kChunkRows) : kChunkRows);
      if (failure.empty()) expect(table.flush(encoder, all));
    }
    pending = 0;
    check();
  }
  void create(Table& table, hsize_t chunk_rows) {
    table.chunk_rows = chunk_rows;
    std::vector<hsize_t> now{0}, most{H5S_UNLIMITED}, chunk{chunk_rows};
    for (const hsize_t n : table.row) {
      now.push_back(n);
      most.push_back(n);
      // Chunks of single columns, whose values hardly change from row to row.
      chunk.push_back(1);
    }
    const Handle space(H5Screate_simple(static_cast<int>(now.size()), now.data(), most.data()), H5Sclose);
    const Handle list = plainList();
    H5Pset_chunk(list.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), kDeflate);
    table.set = Handle(H5Dcreate2(handle.get(), table.name.c_str(), typeOf(table.storage), space.get(),
                                  H5P_DEFAULT, list.get(), H5P_DEFAULT),
                       H5Dclose);
    expect(static_cast<bool>(table.set));
    check();
    if (table.storage != Storage::kDouble) attribute(table.set, "step", H5T_NATIVE_DOUBLE, &table.step);
    if (!table.unit.empty()) text(table.set, "unit", table.unit);
    if (!table.columns.empty()) text(table.set, "columns", table.columns);
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

TableWriter::TableWriter(const std::filesystem::path& file, Compression compression)
    : impl_(std::make_unique<Impl>(file, compression)) {
  startLibrary();
  const Handle list(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(list.get(), kSealBytes);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  limitMetadata(access.get());
  impl_->handle =
      Handle(H5Fcreate(impl_->out.named().c_str(), H5F_ACC_TRUNC, list.get(), access.get()), H5Fclose);
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
  table.name = name;
  table.storage = storage;
  table.step = step;
  for (const std::size_t n : row) {
    table.row.push_back(n);
    table.width *= n;
  }
  impl_->tables.push_back(std::move(table));
  return impl_->tables.size() - 1;
}

void TableWriter::describe(std::size_t table, const std::string& unit, const std::string& columns) {
  impl_->tables[table].unit = unit;
  impl_->tables[table].columns = columns;
}

void TableWriter::add(std::size_t table, double value) { impl_->tables[table].add({&value, 1}); }

void TableWriter::add(std::size_t table, std::span<const double> values) { impl_->tables[table].add(values); }

void TableWriter::nextTables() {
  impl_->flush(true);
  impl_->tables.clear();
}

void TableWriter::endRow() {
  if (++impl_->pending >= kChunkRows) impl_->flush(false);
}

void TableWriter::finish() {
  if (!impl_->handle) return;
  impl_->flush(true);
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
