#include "tracking/registry/recording_format.hpp"

#include "core/base/text_file.hpp"
#include "tracking/acclaim/acclaim_recording.hpp"
#include "tracking/bvh/bvh_recording.hpp"
#include "tracking/c3d/c3d_reader.hpp"
#include "tracking/compact/compact_recording.hpp"
#include "tracking/kinect/irds.hpp"
#include "tracking/kinect/ui_prmd.hpp"
#include "tracking/kinect/utd_mhad.hpp"
#include "tracking/markers/point_recording.hpp"
#include "tracking/table/skeleton_csv.hpp"
#include "tracking/table/skeleton_json.hpp"
#include "tracking/trc/trc_reader.hpp"

namespace abstand::tracking {
namespace {

namespace fs = std::filesystem;

Recording readBvh(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  return readBvhRecording(std::move(bytes), file.string(), options);
}

Recording readCsv(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  return readSkeletonCsv(bytes, file.string(), options);
}

/// For readers that only need the bytes.
template <typename Reader>
Recording readWith(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  Reader reader(bytes, file.string());
  return readPoints(reader, file.string(), options);
}

Recording readAmc(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  const fs::path asf_file = findAsf(file, options.skeleton);
  const std::string asf = readFile(asf_file);
  AcclaimPoints reader(asf, asf_file.string(), bytes, file.string());
  Recording recording = readPoints(reader, file.string(), options);
  recording.report.notes.push_back(
      "the skeleton is that of " + asf_file.filename().string() +
      (options.skeleton.empty() ? ", found next to the file" : ", given by the user"));
  return recording;
}

Recording readAsf(std::string bytes, const fs::path& file, const RecordingOptions& options) {
  AcclaimPoints reader(bytes, file.string(), {}, {});
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

constexpr RecordingFormat kFormats[]{
    {"bvh", "begins with HIERARCHY", looksLikeBvh, readBvh},
    {"amc", "begins with #!OML:ASF or :FULLY-SPECIFIED", looksLikeAmc, readAmc},
    {"asf", "keywords with a colon, :bonedata among them", looksLikeAsf, readAsf},
    {"c3d", "key 0x50 in its second byte", looksLikeC3d, readWith<C3dReader>},
    {"trc", "begins with PathFileType", looksLikeTrc, readWith<TrcReader>},
    {"kinect-v2-csv", "a first line with JointName and TrackingStatus", looksLikeIrdsCsv,
     readWith<IrdsReader>},
    {"kinect-v2-txt", "begins with Version0.1", looksLikeIrdsText, readWith<IrdsReader>},
    {"ui-prmd", "66 numbers a line", looksLikeUiPrmd, readUiPrmd},
    {"utd-mhad", "a MATLAB file with d_skel", looksLikeMat, readWith<UtdMhadReader>},
    {"compact", "begins with ABSTREC1", looksLikeCompact, readWith<CompactReader>},
    {"jsonl", "an object with \"joints\" a line", looksLikeSkeletonJson, readWith<SkeletonJsonReader>},
    {"csv", "a first line 't,JOINT.x,...'", looksLikeSkeletonCsv, readCsv}};

}  // namespace

std::span<const RecordingFormat> allRecordingFormats() { return kFormats; }

}  // namespace abstand::tracking
