// abstand skeleton: reads a recording, reports its interpretation, and converts it.
#include "app/cli/command_line.hpp"
#include "app/cli/doctor_text.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"
#include "humanmodel/recording_lengths.hpp"
#include "tracking/compact/compact_recording.hpp"
#include "tracking/recording/joint_map_writer.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/recording/required_person.hpp"
#include "tracking/registry/open_recording.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::cli {
namespace {

struct SkeletonArguments {
  std::string file, out, compact, filter, map;
  double fill{0.0};  ///< s
  bool doctor{false}, fit_lengths{false}, predict{false};
  safety::MotionBounds bounds{2.0, kInfinity, 0.0, 0.0};
  tracking::RecordingOptions options;
};

/// A value that is positive if known; otherwise null.
nlohmann::ordered_json known(double value) {
  return value > 0.0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json markersJson(const tracking::MarkerReport& m) {
  nlohmann::ordered_json used = nlohmann::json::array(), ignored = nlohmann::json::array(),
                         swaps = nlohmann::json::array(), bones = nlohmann::ordered_json::object();
  for (const auto& u : m.used)
    used.push_back({{"marker", u.label},
                    {"segment", u.segment},
                    {"rms", u.rms},
                    {"shift", u.shift},
                    {"seen", u.seen},
                    {"misplaced", u.misplaced}});
  for (const auto& [label, why] : m.ignored) ignored.push_back({{"marker", label}, {"why", why}});
  for (const auto& s : m.swaps) swaps.push_back({{"a", s.a}, {"b", s.b}, {"frames", s.frames}});
  for (const auto& [bone, length] : m.bones) bones[bone] = length;
  return {{"set", m.set},          {"reason", m.reason},
          {"rms", known(m.rms)},   {"stature", known(m.stature)},
          {"bones", bones},        {"used", used},
          {"ignored", ignored},    {"swaps", swaps},
          {"frames_lost", m.lost}, {"frames_unseen", m.unseen}};
}

nlohmann::ordered_json proportionsJson(const std::vector<tracking::BoneProportion>& bones) {
  nlohmann::ordered_json all = nlohmann::json::array();
  for (const auto& bone : bones)
    all.push_back({{"part", bone.part},
                   {"length", bone.length},
                   {"usual", bone.usual},
                   {"off", bone.off()},
                   {"odd", bone.isOdd()}});
  return all;
}

nlohmann::ordered_json subjectJson(const tracking::SubjectFacts& s) {
  nlohmann::ordered_json sizes = nlohmann::ordered_json::object();
  for (const auto& [name, size] : s.sizes) sizes[name] = size;
  return {{"name", s.name}, {"height", known(s.height)}, {"mass", known(s.mass)}, {"sizes", sizes}};
}

std::string subjectText(const tracking::SubjectFacts& s) {
  if (s.empty()) return {};
  std::string text = "subject stated in the file:";
  if (!s.name.empty()) text += " " + s.name + ";";
  if (s.height > 0.0) text += format(" stature %.3f m;", s.height);
  if (s.mass > 0.0) text += format(" %.1f kg;", s.mass);
  for (const auto& [name, size] : s.sizes) text += format(" %s %.3f m;", name.c_str(), size);
  text.back() = '\n';
  return text;
}

nlohmann::ordered_json reportJson(const tracking::Recording& recording) {
  const tracking::RecordingReport& r = recording.report;
  return {{"format", r.format},
          {"frames", recording.frames.size()},
          {"rate", known(r.rate)},
          {"rate_reason", r.rate_reason},
          {"clock_start", known(recording.clock_start)},
          {"duration", r.duration},
          {"units_guess", r.units.name},
          {"units_reason", r.units.reason},
          {"scale", r.scale},
          {"up", r.up.axis},
          {"up_reason", r.up.reason},
          {"sides", r.sides.found},
          {"sides_reason", r.sides.reason},
          {"stature", known(r.stature)},
          {"stature_reason", r.person.stature_reason},
          {"subject", r.person.subject.empty() ? nlohmann::ordered_json() : subjectJson(r.person.subject)},
          {"joint_map", r.joint_map},
          {"joint_map_reason", r.map_use.reason},
          {"joints_guessed", r.map_use.is_guess},
          {"markers", r.markers.reason.empty() ? nlohmann::ordered_json() : markersJson(r.markers)},
          {"joints", r.joints},
          {"mapped", r.mapped},
          {"not_mapped", r.not_mapped},
          {"missing_parts", r.missing_parts},
          {"twist_from_orientations", r.person.twisted},
          {"gaps", r.gaps},
          {"swaps", r.swaps},
          {"proportions", proportionsJson(r.person.proportions)},
          {"repairs", r.repairs},
          {"notes", r.notes},
          {"warnings", r.warnings}};
}

nlohmann::ordered_json lengthsJson(const humanmodel::LengthFit& fit) {
  nlohmann::ordered_json bones = nlohmann::json::array();
  for (const auto& b : fit.bones)
    bones.push_back({{"part", humanmodel::partName(b.part)},
                     {"length", b.median},
                     {"spread", b.spread},
                     {"model", b.model},
                     {"residual", b.residual}});
  return {{"stature", fit.stature},
          {"stature_spread", fit.stature_spread},
          {"rms_residual", fit.rms},
          {"bones", bones}};
}

std::string lengthsText(const humanmodel::LengthFit& fit) {
  std::string text = format(
      "stature from the bones: %.3f m, +- %.3f m between bones; RMS deviation from the model %.1f mm\n",
      fit.stature, fit.stature_spread, 1e3 * fit.rms);
  for (const auto& b : fit.bones)
    text += format("  %-14s %6.1f mm (5 %% to 95 %%: %5.1f mm), model %6.1f mm, %+6.1f mm\n",
                   std::string(humanmodel::partName(b.part)).c_str(), 1e3 * b.median, 1e3 * b.spread,
                   1e3 * b.model, 1e3 * b.residual);
  return text;
}

std::string join(const std::vector<std::string>& words) {
  std::string s;
  for (const auto& w : words) s += (s.empty() ? "" : ", ") + w;
  return s;
}

std::string markersText(const tracking::MarkerReport& m) {
  if (m.reason.empty()) return {};
  if (m.set.empty()) return "marker set: none: " + m.reason + " (--marker-set)\n";
  std::string text = "marker set: " + m.set + ": " + m.reason + " (--marker-set)\n";
  text += format("RMS marker residual: %.1f mm\n", 1000.0 * m.rms);
  for (const auto& u : m.used) {
    text += format("  %-16s %-16s %5.1f mm RMS, %5.1f mm from its nominal position", u.label.c_str(),
                   u.segment.c_str(), 1000.0 * u.rms, 1000.0 * u.shift);
    if (u.misplaced > 0) text += format(", misplaced in %zu of %zu frames", u.misplaced, u.seen);
    text += "\n";
  }
  text += "bones:";
  for (const auto& [bone, length] : m.bones) text += format(" %s %.3f m", bone.c_str(), length);
  return text + "\n";
}

std::string reportText(const tracking::Recording& recording, const std::string& file) {
  const tracking::RecordingReport& r = recording.report;
  const std::string rate = r.rate > 0.0 ? format("at %.6g Hz", r.rate) : "at an unknown rate";
  std::string text = format("%s: %s, %zu frames %s, %.2f s\n", file.c_str(), r.format.c_str(),
                            recording.frames.size(), rate.c_str(), r.duration);
  text += "time: " + r.rate_reason + " (--rate)\n";
  text += format("units: %s (%.6g m per unit): %s (--units)\n", r.units.name.c_str(), r.scale,
                 r.units.reason.c_str());
  text += format("up: %s: %s (--up)\n", r.up.axis.c_str(), r.up.reason.c_str());
  text += format("left and right: %s: %s (--mirror)\n", r.sides.found.c_str(), r.sides.reason.c_str());
  text += r.stature > 0.0 ? format("stature: %.3f m: %s\n", r.stature, r.person.stature_reason.c_str())
                          : "stature: unknown\n";
  text += subjectText(r.person.subject);
  text += "joint map: " + (r.joint_map.empty() ? "none" : r.joint_map) +
          (r.map_use.reason.empty() ? "" : ": " + r.map_use.reason) + " (--joint-map)\n";
  text += markersText(r.markers);
  for (const auto& [part, joints] : r.mapped) text += "  " + part + ": " + join(joints) + "\n";
  if (!r.not_mapped.empty()) text += "not mapped: " + join(r.not_mapped) + "\n";
  if (!r.person.twisted.empty())
    text += "twist from the orientations of the file: " + join(r.person.twisted) + "\n";
  if (!r.missing_parts.empty()) text += "parts without motion: " + join(r.missing_parts) + "\n";
  if (r.gaps > 0) text += format("frames with gaps: %zu\n", r.gaps);
  for (const auto& n : r.notes) text += "note: " + n + "\n";
  for (const auto& w : r.warnings) text += "warning: " + w + "\n";
  return text;
}

/// Refuses options that would have no effect.
void checkOptions(const SkeletonArguments& args) {
  if (!args.filter.empty() && args.out.empty() && args.compact.empty())
    throw UsageError("filter: found neither --out nor --write, expected one of these files to smooth");
  const std::string& set = args.options.marker_set;
  if (!args.options.joint_map.empty() && set != "auto" && set != "none")
    throw UsageError("joint-map: found a marker set too, expected only one of them");
}

int runSkeleton(const CommandLine& line, const SkeletonArguments& args) {
  checkOptions(args);
  tracking::Recording recording = tracking::openRecording(args.file, args.options);
  auto json = reportJson(recording);
  std::string text = reportText(recording, args.file);
  if (recording.report.mapped.empty()) {
    if (!args.map.empty()) writeFile(args.map, tracking::jointMapText(recording.report));
    line.print(json, text);
    tracking::requirePerson(recording.report, args.file);
  }
  if (args.doctor) {
    const tracking::DoctorReport doctor = tracking::examine(recording);
    json["doctor"] = doctorJson(doctor);
    text += doctorText(doctor);
  }
  if (args.fit_lengths) {
    const auto fit = humanmodel::fitLengths({}, recording.frames);
    json["lengths"] = fit ? lengthsJson(*fit) : nlohmann::ordered_json();
    text += fit ? lengthsText(*fit) : "stature from the bones: unknown, no bone has both ends\n";
  }
  if (args.predict) {
    constexpr double kAhead[] = {0.05, 0.1, 0.2, 0.5};
    const auto trials = tracking::tryPredictions(recording, args.bounds, kAhead);
    json["prediction"] = predictionJson(trials, args.bounds);
    text += predictionText(trials, args.bounds);
  }
  if (args.fill > 0.0) {
    const tracking::GapFill fill = tracking::fillGaps(recording.frames, args.fill);
    text += format("gap filling: %zu positions filled, %zu left\n", fill.filled, fill.left);
    json["filled"] = fill.filled;
  }
  if (!args.filter.empty()) {
    if (!(recording.report.rate > 0.0))
      throw UsageError("filter: found a single frame, expected a recording");
    tracking::smooth(recording.frames, recording.report.rate, *tracking::parseSmoothing(args.filter));
  }
  if (!args.map.empty()) writeFile(args.map, tracking::jointMapText(recording.report));
  if (!args.out.empty()) tracking::writeSkeletonCsv(std::filesystem::path(args.out), recording);
  if (!args.compact.empty()) tracking::writeCompact(std::filesystem::path(args.compact), recording);
  line.print(json, text);
  return kDone;
}

}  // namespace

void addSkeleton(CLI::App& root, CommandLine& line) {
  auto* command = addCommand(root, line, "skeleton", "reads, reports and converts a recording of a person",
                             "abstand skeleton boxing.bvh --out boxing.csv");
  auto args = std::make_shared<SkeletonArguments>();
  command->add_option("FILE", args->file, "the recording")->required();
  command->add_option("--format", args->options.format, "auto, or " + join(tracking::recordingFormats()));
  command->add_option("--units", args->options.units, "auto, m, cm, mm, inches, cmu, or metres per unit");
  command->add_option("--up", args->options.up, "auto, x, y, z, -x, -y, -z");
  command->add_option("--rate", args->options.rate, "Hz: frame i is at t = i / rate")
      ->check(CLI::Range(1e-3, 1e6));
  command->add_option("--mirror", args->options.mirror,
                      "none, axes (of the file are left-handed) or sides (names are exchanged)");
  command->add_option("--joint-map", args->options.joint_map,
                      "joint map file; markers that it maps are used as joints and are not solved");
  command->add_option("--marker-set", args->options.marker_set,
                      "auto, none (joints are marker midpoints) or a marker set file");
  command->add_option("--skeleton", args->options.skeleton, "the ASF file of an AMC file");
  line.output(command->add_option("--out", args->out, "CSV of the canonical joints (m, z up)"));
  line.output(command->add_option("--write", args->compact, "the same in Abstand's compact format"));
  line.output(
      command->add_option("--write-map", args->map,
                          "writes the joint map used, as read by --joint-map; a template if no part moves"));
  command->add_flag_callback(
      "--no-repair", [args] { args->options.repair = false; },
      "do not restore bones that a conversion to BVH has dropped");
  command->add_flag("--doctor", args->doctor,
                    "reports bone lengths, gaps, jitter, jumps and swaps, and the effect of filters");
  auto* predict =
      command->add_flag("--predict", args->predict,
                        "reports how far ahead joints can be predicted, and whether speed bounds hold");
  command->add_option("--person-speed", args->bounds.speed, "m/s, the bound that --predict tries (2)")
      ->check(CLI::Range(0.0, 100.0))
      ->needs(predict);
  command
      ->add_option("--person-acceleration", args->bounds.acceleration,
                   "acceleration bound in m/s^2 that --predict tries (default: none)")
      ->check(CLI::Range(0.0, 1e6))
      ->needs(predict);
  command->add_flag("--fit-lengths", args->fit_lengths,
                    "compares stature and bone lengths with those of the model");
  command->add_option("--fill", args->fill, "fills gaps of up to this length in s in the output")
      ->check(CLI::Range(0.0, 3600.0));
  command
      ->add_option("--filter", args->filter,
                   "filter of the output: one-euro, butterworth or butterworth-both-ways")
      ->check(CLI::IsMember({"one-euro", "butterworth", "butterworth-both-ways"}));
  command->callback([&line, args] { line.run = [&line, args] { return runSkeleton(line, *args); }; });
}

}  // namespace abstand::cli
