#include "tracking/kinect/utd_mhad.hpp"

#include <matio.h>

#include <cmath>
#include <memory>

#include "core/base/error.hpp"
#include "tracking/kinect/kinect_joints.hpp"
#include "tracking/message_text.hpp"

namespace abstand {
namespace {

constexpr const char* kVariable = "d_skel";
constexpr std::size_t kJoints = 20;
constexpr double kRate = 30.0;
/// zlib packs at most this many bytes into one (RFC 1951, at length 258 a bit pair); more is a lie.
constexpr std::uintmax_t kMostPacking = 1040;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, Close>;
using MatVariable = std::unique_ptr<matvar_t, Close>;

std::string sizeText(const matvar_t& v) {
  std::string s;
  for (int i = 0; i < v.rank; ++i) s += (i > 0 ? " x " : "") + std::to_string(v.dims[i]);
  return s;
}

/// The variable's head, without its data.
MatVariable findVariable(mat_t& file, const std::string& name) {
  std::string others;
  while (true) {
    MatVariable v(Mat_VarReadNextInfo(&file));
    if (!v) break;
    if (v->name && std::string_view(v->name) == kVariable) return v;
    if (others.size() < 200)
      others += (others.empty() ? "" : ", ") + inQuotes(v->name ? v->name : "") + " (" + sizeText(*v) + ")";
  }
  const bool is_depth = others.find("d_depth") != std::string::npos;
  throw ParseError({name},
                   (others.empty() ? std::string("found no variable") : "found " + others) +
                       ", expected the skeleton d_skel of 20 x 3 x frames",
                   is_depth ? "this is a depth recording, not a skeleton" : "");
}

std::size_t framesOf(const matvar_t& v, std::uintmax_t file_bytes, const std::string& name) {
  const bool fits = (v.rank == 2 || v.rank == 3) && v.dims[0] == kJoints && v.dims[1] == 3;
  const bool is_real = !v.isComplex && (v.class_type == MAT_C_DOUBLE || v.class_type == MAT_C_SINGLE);
  if (!fits || !is_real)
    throw ParseError({name}, "found d_skel of " + sizeText(v) + (is_real ? "" : " that are no real numbers") +
                                 ", expected real numbers, 20 x 3 x frames");
  const std::size_t frames = v.rank == 3 ? v.dims[2] : 1;
  if (frames == 0 || frames > file_bytes * kMostPacking / (kJoints * 3))
    throw ParseError({name}, "found a claim of " + std::to_string(frames) + " frames in a file of " +
                                 std::to_string(file_bytes) + " bytes, expected at least one and what fits");
  return frames;
}

}  // namespace

bool looksLikeMat(std::string_view bytes) { return bytes.starts_with("MATLAB "); }

UtdMhadReader::UtdMhadReader(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code ec;
  const auto bytes = std::filesystem::file_size(file, ec);
  if (ec || bytes > kMostBytes) throw ParseError({name}, "cannot be read, expected a file of at most 1 GB");
  Mat_LogInitFunc("abstand", [](int, char*) {});
  const MatFile mat(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
  if (!mat || Mat_GetVersion(mat.get()) != MAT_FT_MAT5)
    throw ParseError({name}, "found no MATLAB 5 file, expected one of version 5 to 7.2");
  const MatVariable v = findVariable(*mat, name);
  frames_ = framesOf(*v, bytes, name);

  values_.assign(kJoints * 3 * frames_, kNaN);
  std::vector<float> singles;
  const bool is_double = v->class_type == MAT_C_DOUBLE;
  if (!is_double) singles.assign(values_.size(), static_cast<float>(kNaN));
  void* into = is_double ? static_cast<void*>(values_.data()) : singles.data();
  int start[3]{0, 0, 0}, stride[3]{1, 1, 1}, edge[3]{static_cast<int>(kJoints), 3, static_cast<int>(frames_)};
  if (Mat_VarReadData(mat.get(), v.get(), into, start, stride, edge) != 0)
    throw ParseError({name}, "found d_skel cut short, expected " + sizeText(*v) + " numbers");
  if (!is_double) values_.assign(singles.begin(), singles.end());

  facts_.format = "utd-mhad";
  facts_.rate = kRate;
  facts_.rate_reason = "no time in the file; the set was recorded at 30 Hz";
  facts_.unit = UnitChoice{"m", "Kinect v1 gives metres", 1.0, ""};
  facts_.up = UpChoice{"y", "the camera's up; a camera that looks down or up is not corrected", ""};
}

std::span<const std::string> UtdMhadReader::names() const { return utdMhadJoints(); }

bool UtdMhadReader::next(PointFrame& frame) {
  if (next_ == frames_) return false;
  frame.clear(kJoints);
  frame.t = static_cast<double>(next_) / kRate;
  const double* first = values_.data() + next_ * kJoints * 3;
  for (std::size_t j = 0; j < kJoints; ++j) {
    const Vector3d p(first[j], first[kJoints + j], first[2 * kJoints + j]);
    if (p.allFinite() && p.cwiseAbs().maxCoeff() < kLargestCoordinate && !p.isZero(0.0)) frame.set(j, p);
  }
  ++next_;
  return true;
}

}  // namespace abstand
