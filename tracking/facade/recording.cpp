#include "abstand/recording.hpp"

#include "humanmodel/facade/skeleton_frame.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand {

struct Recording::Impl {
  tracking::Recording recording;
  std::vector<Skeleton> frames;
};

Recording Recording::open(const std::filesystem::path& file, const RecordingOptions& options) {
  tracking::RecordingOptions o;
  o.format = options.format;
  o.units = options.units;
  o.up = options.up;
  o.rate = options.rate;
  auto impl = std::make_shared<Impl>();
  impl->recording = tracking::openRecording(file, o);
  for (const auto& frame : impl->recording.frames) impl->frames.push_back(facade::skeletonOf(frame));
  return Recording(std::move(impl));
}

const std::vector<Skeleton>& Recording::frames() const { return impl_->frames; }

const Skeleton& Recording::at(double t) const {
  const humanmodel::SkeletonFrame* frame = &impl_->recording.at(t);
  return impl_->frames[static_cast<std::size_t>(frame - impl_->recording.frames.data())];
}

double Recording::duration() const { return impl_->recording.report.duration; }
double Recording::stature() const { return impl_->recording.report.stature; }
const std::string& Recording::format() const { return impl_->recording.report.format; }
const std::string& Recording::units() const { return impl_->recording.report.units.name; }
const std::string& Recording::up() const { return impl_->recording.report.up.axis; }
const std::vector<std::string>& Recording::warnings() const { return impl_->recording.report.warnings; }

}  // namespace abstand
