#include "tracking/recording_format.hpp"

#include "core/base/text_file.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/kinect/irds.hpp"
#include "tracking/kinect/ui_prmd.hpp"
#include "tracking/kinect/utd_mhad.hpp"
#include "tracking/point_recording.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand {
namespace {

namespace fs = std::filesystem;

Recording readBvh(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  return readBvhRecording(std::move(bytes), file.string(), options);
}

Recording readCsv(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  return readSkeletonCsv(bytes, file.string(), options);
}

Recording readIrds(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  IrdsReader reader(bytes, file.string());
  return readPoints(reader, file.string(), options);
}

Recording readUiPrmd(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  const fs::path other_file = uiPrmdPartner(file);
  const std::string other = readFile(other_file);
  const bool is_angles = other_file.filename().string().find("positions") != std::string::npos;
  const auto [places, places_file] = is_angles ? std::pair(&other, &other_file) : std::pair(&bytes, &file);
  const auto [angles, angles_file] = is_angles ? std::pair(&bytes, &file) : std::pair(&other, &other_file);
  UiPrmdReader reader(*places, places_file->string(), *angles, angles_file->string());
  return readPoints(reader, file.string(), options);
}

Recording readMat(std::string, const fs::path& file, const RecordingOptions& options) {
  UtdMhadReader reader(file);
  return readPoints(reader, file.string(), options);
}

constexpr RecordingFormat kFormats[]{
    {"bvh", "begins with HIERARCHY", looksLikeBvh, readBvh},
    {"kinect-v2-csv", "a first line with JointName and TrackingStatus", looksLikeIrdsCsv, readIrds},
    {"kinect-v2-txt", "begins with Version0.1", looksLikeIrdsText, readIrds},
    {"ui-prmd", "66 numbers a line", looksLikeUiPrmd, readUiPrmd},
    {"utd-mhad", "a MATLAB file with d_skel", looksLikeMat, readMat},
    {"csv", "a first line 't,JOINT.x,...'", looksLikeSkeletonCsv, readCsv}};

}  // namespace

std::span<const RecordingFormat> allRecordingFormats() { return kFormats; }

}  // namespace abstand
