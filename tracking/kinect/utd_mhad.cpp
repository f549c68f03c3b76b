#include "tracking/kinect/utd_mhad.hpp"

#include "core/base/error.hpp"
#include "tracking/kinect/kinect_joints.hpp"
#include "tracking/kinect/mat_variable.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kJoints = 20;
constexpr double kUtdMhadRate = 30.0;

}  // namespace

bool looksLikeMat(std::string_view bytes) { return bytes.starts_with("MATLAB "); }

UtdMhadReader::UtdMhadReader(std::string_view bytes, const std::string& file) {
  MatVariable skeleton = readMatVariable(bytes, "d_skel", file);
  const auto& size = skeleton.size;
  const bool fits = (size.size() == 2 || size.size() == 3) && size[0] == kJoints && size[1] == 3;
  if (!fits || skeleton.values.empty())
    throw ParseError({file}, "found d_skel of " + std::to_string(skeleton.values.size()) +
                                 " numbers in another form, expected 20 x 3 x frames");
  values_ = std::move(skeleton.values);
  frames_ = values_.size() / (kJoints * 3);

  facts_.format = "utd-mhad";
  facts_.rate = kUtdMhadRate;
  facts_.rate_reason = "no time in the file; the set was recorded at 30 Hz";
  facts_.sensor = kKinectError;
  facts_.unit = UnitChoice{"m", "Kinect v1 gives metres", 1.0, ""};
  facts_.up = UpChoice{"y", "the camera's up axis; a tilted camera is not corrected", ""};
}

std::span<const std::string> UtdMhadReader::names() const { return utdMhadJoints(); }

bool UtdMhadReader::next(PointFrame& frame) {
  if (next_ == frames_) return false;
  frame.clear(kJoints);
  frame.t = static_cast<double>(next_) / kUtdMhadRate;
  const double* first = values_.data() + next_ * kJoints * 3;
  for (std::size_t j = 0; j < kJoints; ++j) {
    const Vector3d p(first[j], first[kJoints + j], first[2 * kJoints + j]);
    if (p.allFinite() && p.cwiseAbs().maxCoeff() < kLargestCoordinate && !p.isZero(0.0)) frame.set(j, p);
  }
  ++next_;
  return true;
}

}  // namespace abstand::tracking
