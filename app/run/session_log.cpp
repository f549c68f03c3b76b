#include "app/run/session_log.hpp"

#include <hdf5.h>

#include <cerrno>

#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand::run {
namespace {

constexpr hsize_t kChunkFrames = 256;
constexpr int kDeflate = 1;

/// A dataset that grows by one row at a time; rows are gathered in memory, a chunk at a time.
class GrowingTable {
 public:
  GrowingTable(hid_t file, const char* name, std::vector<hsize_t> row) : row_(std::move(row)) {
    std::vector<hsize_t> now{0}, most{H5S_UNLIMITED}, chunk{kChunkFrames};
    for (hsize_t n : row_) {
      width_ *= n;
      now.push_back(n);
      most.push_back(n);
      chunk.push_back(n);
    }
    if (width_ == 0) return;
    const hid_t space = H5Screate_simple(static_cast<int>(now.size()), now.data(), most.data());
    const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(plist, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_deflate(plist, kDeflate);
    H5Pset_obj_track_times(plist, false);  // the same input gives the same file
    set_ = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, plist, H5P_DEFAULT);
    H5Pclose(plist);
    H5Sclose(space);
  }
  ~GrowingTable() {
    if (set_ >= 0) H5Dclose(set_);
  }
  GrowingTable(const GrowingTable&) = delete;
  GrowingTable& operator=(const GrowingTable&) = delete;

  void add(double v) { buffer_.push_back(v); }

  bool flush() {
    if (set_ < 0 || buffer_.empty()) return true;
    const hsize_t rows = buffer_.size() / width_;
    std::vector<hsize_t> start{rows_}, count{rows}, all{rows_ + rows};
    for (hsize_t n : row_) {
      start.push_back(0);
      count.push_back(n);
      all.push_back(n);
    }
    bool good = H5Dset_extent(set_, all.data()) >= 0;
    const hid_t space = H5Dget_space(set_);
    good =
        good && H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0;
    const hid_t memory = H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr);
    good = good && H5Dwrite(set_, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, buffer_.data()) >= 0;
    H5Sclose(memory);
    H5Sclose(space);
    rows_ += rows;
    buffer_.clear();
    return good;
  }

 private:
  std::vector<hsize_t> row_;
  hsize_t width_{1}, rows_{0};
  hid_t set_{-1};
  std::vector<double> buffer_;
};

/// Once, before anything else of the library. Its own exit handler would write what a full disk refused
/// before, and crash over it; every file is closed here, so that it has nothing to do.
void startLibrary() {
  static const bool started = [] {
    H5dont_atexit();
    return H5open() >= 0;
  }();
  if (!started) throw WriteError("HDF5", std::string("the library does not start"));
  // The library prints its own stack of errors unless told not to; ours is one line.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// The system's reason in the library's stack of errors: `errno = 28, error message = 'No space left on
/// device'`.
std::string systemReason() {
  std::string reason;
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

void writeNames(hid_t file, const scene::Scene& scene) {
  std::vector<const char*> names;
  for (const scene::Object& o : scene.objects()) names.push_back(o.spec.name.c_str());
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, H5T_VARIABLE);
  const hsize_t count = names.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(plist, false);
  const hid_t set = H5Dcreate2(file, "objects", text, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  H5Pclose(plist);
  H5Dwrite(set, text, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data());
  H5Dclose(set);
  H5Sclose(space);
  H5Tclose(text);
}

void writePairs(hid_t file, const scene::Scene& scene) {
  std::vector<int> indices;
  for (const scene::Pair& p : scene.pairs()) {
    indices.push_back(static_cast<int>(p.a.index()));
    indices.push_back(static_cast<int>(p.b.index()));
  }
  if (indices.empty()) return;
  const hsize_t dims[2] = {scene.pairs().size(), 2};
  const hid_t space = H5Screate_simple(2, dims, nullptr);
  const hid_t plist = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(plist, false);
  const hid_t set = H5Dcreate2(file, "pairs", H5T_NATIVE_INT, space, H5P_DEFAULT, plist, H5P_DEFAULT);
  H5Pclose(plist);
  H5Dwrite(set, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, indices.data());
  H5Dclose(set);
  H5Sclose(space);
}

void writeVersion(hid_t file) {
  const int version = 1;
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t attribute = H5Acreate2(file, "abstand", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_INT, &version);
  H5Aclose(attribute);
  H5Sclose(space);
}

}  // namespace

struct SessionLog::Impl {
  explicit Impl(const std::filesystem::path& name) : file(name), out(name) {}

  std::filesystem::path file;
  OutputFile out;
  hid_t handle{-1};
  std::unique_ptr<GrowingTable> t, distance, bound, force, reach, q, effort, age;
  hsize_t pending{0};
  std::string failure;  ///< of the first failure; empty: none

  /// Notes the first failure, before the library forgets its reason.
  void expect(bool good) {
    if (!good && failure.empty()) failure = systemReason();
  }
  void flush() {
    for (auto* table : {&t, &distance, &bound, &force, &reach, &q, &effort, &age})
      if (*table && failure.empty()) expect((*table)->flush());
    pending = 0;
    if (!failure.empty()) throw WriteError(file.string(), failure);
  }
  void close() {
    // After a failure the library holds what it cannot write: nothing more is asked of it but to let go.
    for (auto* table : {&t, &distance, &bound, &force, &reach, &q, &effort, &age}) table->reset();
    if (handle >= 0) expect(H5Fflush(handle, H5F_SCOPE_GLOBAL) >= 0);
    if (handle >= 0) expect(H5Fclose(handle) >= 0);
    handle = -1;
  }
};

SessionLog::SessionLog(const std::filesystem::path& file, const session::Session& session, bool live)
    : impl_(std::make_unique<Impl>(file)) {
  startLibrary();
  impl_->handle = H5Fcreate(impl_->out.named().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  impl_->expect(impl_->handle >= 0);
  if (impl_->handle < 0) throw WriteError(file.string(), impl_->failure);
  const hsize_t pairs = session.scene().pairs().size(), joints = session.jointEfforts().size();
  writeVersion(impl_->handle);
  writeNames(impl_->handle, session.scene());
  writePairs(impl_->handle, session.scene());
  const auto table = [&](const char* name, std::vector<hsize_t> row) {
    return std::make_unique<GrowingTable>(impl_->handle, name, std::move(row));
  };
  impl_->t = table("t", {});
  impl_->distance = table("distance", {pairs});
  impl_->bound = table("bound", {pairs});
  impl_->force = table("force", {pairs, 3});
  impl_->reach = table("reach", {session.scene().objectCount()});
  impl_->q = table("q", {joints});
  impl_->effort = table("effort", {joints});
  if (live) impl_->age = table("age", {pairs});
}

SessionLog::~SessionLog() {
  if (impl_) impl_->close();
}

void SessionLog::write(double t, double shown, const session::Session& session,
                       const std::vector<query::PairResult>& results) {
  impl_->t->add(t);
  if (impl_->age)
    for (std::uint32_t i = 0; i < results.size(); ++i)
      impl_->age->add(session.scene().ageOf(PairId(i), shown));
  for (const auto& r : results) {
    impl_->distance->add(r.distance);
    impl_->bound->add(r.bound);
    for (int i = 0; i < 3; ++i) impl_->force->add(r.force_a[i]);
  }
  for (const scene::Object& o : session.scene().objects()) impl_->reach->add(o.reach);
  for (const auto& m : session.mechanisms())
    for (double q : m->q()) impl_->q->add(q);
  for (double e : session.jointEfforts()) impl_->effort->add(e);
  if (++impl_->pending >= kChunkFrames) impl_->flush();
}

void SessionLog::finish() {
  if (impl_->handle < 0) return;
  impl_->flush();
  impl_->close();
  if (!impl_->failure.empty()) throw WriteError(impl_->file.string(), impl_->failure);
  impl_->out.finish();
}

void SessionLog::commit() {
  finish();
  impl_->out.commit();
}

}  // namespace abstand::run
