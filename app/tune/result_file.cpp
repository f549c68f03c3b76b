#include "app/tune/result_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/hdf5/table_reader.hpp"
#include "app/tune/exposure_file.hpp"
#include "app/tune/result_key.hpp"
#include "app/tune/stored_limits.hpp"
#include "app/tune/stored_terms.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::tune {
namespace {

constexpr double kDistanceStep = 1e-5;  // m
constexpr double kPointStep = 1e-3;     // m
// m/s. Speeds are rounded up, those of pairs farther apart than kPointsWithin to coarse steps; receding
// bodies have speed 0.
constexpr double kPairSpeedStep = 1.0 / 512.0, kFarSpeedStep = 1.0 / 16.0;
// m: nearest points of pairs farther apart are omitted.
constexpr double kPointsWithin = 0.5;
constexpr std::size_t kMaxNames = 10000;

/// Part, link, t, distance, clearance, speeds of robot and person, robot's mass; time and closing speed of
/// the hardest contact on the way, excluded, force, energy, share, pressure, its share, quasi-static,
/// tool, the robot's mass at that contact.
constexpr std::size_t kApproachColumns = 19;
/// Margin, decided, t, clearance, bound, pose, sampling: links first, then pairs.
constexpr std::size_t kNeedColumns = 7;

/// Attribute `cold_start_every`, frames, of a pass without warm starts; 0: one cold start at the beginning.
constexpr long long kColdStarts = 1;

std::optional<run::RunSummary::WarmStart> warmStartOf(const hdf5::TableReader& in, const std::string& file) {
  const long long block = in.integer("cold_start_every");
  const double tolerance = in.number("far_tolerance");
  if (block < 0 || !(tolerance >= 0.0 && tolerance <= query::kMaxFarTolerance))
    throw ParseError({file}, "found warm starts with impossible numbers, expected frames and a share to 0.1");
  if (block == kColdStarts) return std::nullopt;
  return run::RunSummary::WarmStart{static_cast<std::size_t>(block), tolerance};
}

/// One line of tab-separated fields; times and shares that do not apply are empty.
std::string reservationLine(const run::Reservation& r) {
  const auto number = [](const std::optional<double>& v) { return v ? formatDouble(*v) : std::string(); };
  return r.kind + "\t" + std::to_string(static_cast<int>(r.fails)) + "\t" + number(r.t0) + "\t" +
         number(r.t1) + "\t" + number(r.share) + "\t" + r.text;
}

run::Reservation reservationOf(const std::string& line, const std::string& file) {
  std::array<std::string, 6> fields;
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < fields.size(); ++i) {
    const auto tab = line.find('\t', begin);
    if (tab == std::string::npos)
      throw ParseError({file}, "found a damaged reservation, expected six fields");
    fields[i] = line.substr(begin, tab - begin);
    begin = tab + 1;
  }
  fields.back() = line.substr(begin);
  const auto fails = parseDouble(fields[1]);
  if (!fails || !(*fails >= 0.0 && *fails <= static_cast<double>(scene::Severity::kAlways)))
    throw ParseError({file}, "found a reservation of an unknown kind, expected one of this version");
  return {fields[0],
          fields[5],
          parseDouble(fields[2]),
          parseDouble(fields[3]),
          parseDouble(fields[4]),
          static_cast<scene::Severity>(static_cast<int>(*fails)),
          ""};
}

/// `count` needs, starting at row `first`.
std::vector<MarginNeed> needsOf(const std::vector<double>& table, std::size_t first, std::size_t count,
                                const std::string& file) {
  std::vector<MarginNeed> needs;
  for (std::size_t i = first; i < first + count; ++i) {
    const double* v = table.data() + i * kNeedColumns;
    if (std::isnan(v[0]) || v[0] < 0.0)
      throw ParseError({file}, "found an invalid needed margin, expected metres");
    needs.push_back({v[0], v[1] != 0.0, v[2], v[3], v[4], v[5], v[6]});
  }
  return needs;
}

/// Reads pairs of indices of parts and links.
void readPairs(const hdf5::TableReader& in, std::size_t parts, PassResult& pass, const std::string& file) {
  const std::size_t count = in.extents("pairs").rows;
  const std::vector<double> pairs = in.table("pairs", count, 3);
  for (std::size_t p = 0; p < count; ++p) {
    const double part = pairs[3 * p], link = pairs[3 * p + 1];
    if (!(part >= 0.0 && part < static_cast<double>(parts) && link >= 0.0 &&
          link < static_cast<double>(pass.links.size())))
      throw ParseError({file}, "found a pair of an unknown part or link");
    pass.pairs.push_back({static_cast<std::uint16_t>(part), static_cast<std::uint16_t>(link),
                          toolOf(pairs[3 * p + 2], pass.tools.size(), file)});
  }
  const std::vector<double> needs = in.table("needs", pass.links.size() + count, kNeedColumns);
  pass.link_needs = needsOf(needs, 0, pass.links.size(), file);
  pass.pair_needs = needsOf(needs, pass.links.size(), count, file);
}

std::vector<Approach> approachesOf(const hdf5::TableReader& in, std::size_t parts, const PassResult& pass,
                                   const std::string& file) {
  const std::size_t links = pass.links.size();
  const std::size_t count = in.extents("approaches").rows;
  const std::vector<double> v = in.table("approaches", count, kApproachColumns);
  const std::vector<std::string> regions = in.texts("approach_regions");
  if (regions.size() != count)
    throw ParseError({file}, "found approaches without regions, expected one for each");
  std::vector<Approach> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double* a = v.data() + i * kApproachColumns;
    if (!(a[0] >= 0.0 && a[0] < static_cast<double>(parts) && a[1] >= 0.0 &&
          a[1] < static_cast<double>(links)))
      throw ParseError({file}, "found an approach of an unknown part or link");
    Approach approach;
    approach.part = static_cast<std::uint16_t>(a[0]);
    approach.link = static_cast<std::uint16_t>(a[1]);
    approach.tool = toolOf(a[17], pass.tools.size(), file);
    approach.t = a[2], approach.distance = a[3], approach.clearance = a[4];
    approach.motion.robot_speed = a[5], approach.motion.person_speed = a[6],
    approach.motion.robot_mass = a[7];
    approach.contact = {
        a[8],       a[9],
        regions[i], a[10] != 0.0,
        a[11],      a[12],
        a[13],      a[14],
        a[15],      a[16] != 0.0 ? contact::ContactKind::kQuasiStatic : contact::ContactKind::kTransient,
        a[18]};
    all.push_back(std::move(approach));
  }
  return all;
}

std::vector<humanmodel::EnclosedShare> enclosedOf(const hdf5::TableReader& in, std::size_t parts,
                                                  const std::string& file) {
  const std::vector<double> v = in.table("enclosed", parts, 2);
  std::vector<humanmodel::EnclosedShare> shares;
  for (std::size_t p = 0; p < parts; ++p) {
    shares.push_back({v[2 * p], v[2 * p + 1]});
    for (const double share : {v[2 * p], v[2 * p + 1]})
      if (!(share >= 0.0 && share <= 1.0))
        throw ParseError({file}, "found an enclosed share outside of 0 to 1");
  }
  return shares;
}

}  // namespace

ResultWriter::ResultWriter(const std::filesystem::path& file, const ContentKey& key,
                           hdf5::Compression compression)
    : out_(file, compression) {
  out_.attribute("abstand_result", kResultFormat);
  out_.attribute("key", key.hex());
  out_.attribute("version", resultVersion());
  out_.attribute("units", std::string("m, s"));
}

void ResultWriter::begin(const PassResult& names) {
  begun_ = true;
  std::vector<std::string> parts;
  for (const PartClearance& p : names.parts) parts.push_back(p.part);
  out_.texts("parts", parts);
  out_.texts("links", names.links);
  std::vector<int> pairs;
  for (const auto& p : names.pairs)
    pairs.insert(pairs.end(), {p.part, p.link, static_cast<int>(toolNumber(p.tool))});
  out_.texts("tools", names.tools);
  out_.integers("pairs", pairs, 3);
  using hdf5::Storage;
  distance_ = out_.table("distance", {names.pairs.size()}, Storage::kSteps32, kDistanceStep);
  bound_ = out_.table("bound", {names.pairs.size()}, Storage::kSteps32, kDistanceStep);
  uncertainty_ = out_.table("uncertainty", {names.pairs.size()}, Storage::kSteps32, kDistanceStep);
  points_ = out_.table("points", {names.pairs.size(), 6}, Storage::kSteps16, kPointStep);
  speeds_ = out_.table("pair_speeds", {names.pairs.size(), 2}, Storage::kSteps16, kPairSpeedStep);
  parts_.begin(names.parts.size(), out_);
}

void ResultWriter::frame(const SettledFrame& settled, const PassResult& pass) {
  const WindowFrame& frame = settled.frame;
  if (!begun_) begin(pass);
  const std::size_t pairs = frame.distance.size();
  out_.add(distance_, frame.distance);
  row_.resize(6 * pairs);
  // The writer rounds down; one step more makes it an upper bound.
  for (std::size_t p = 0; p < pairs; ++p) row_[p] = frame.bound[p] + kDistanceStep;
  out_.add(bound_, {row_.data(), pairs});
  for (std::size_t p = 0; p < pairs; ++p)
    row_[p] = frame.uncertainty[p] > 0.0 ? frame.uncertainty[p] + kDistanceStep : 0.0;
  out_.add(uncertainty_, {row_.data(), pairs});
  for (std::size_t p = 0; p < pairs; ++p) {
    const double step = frame.distance[p] < kPointsWithin ? kPairSpeedStep : kFarSpeedStep;
    row_[2 * p] = step * std::ceil(std::max(0.0, settled.motions[p].robot_speed) / step);
    row_[2 * p + 1] = step * std::ceil(std::max(0.0, settled.motions[p].person_speed) / step);
  }
  out_.add(speeds_, {row_.data(), 2 * pairs});
  for (std::size_t p = 0; p < pairs; ++p) {
    const bool near = frame.distance[p] < kPointsWithin;
    for (int i = 0; i < 3; ++i) {
      row_[6 * p + static_cast<std::size_t>(i)] = near ? frame.on_part[p][i] : kNaN;
      row_[6 * p + 3 + static_cast<std::size_t>(i)] = near ? frame.on_link[p][i] : kNaN;
    }
  }
  out_.add(points_, row_);
  parts_.add(pass.parts, pass.parts.front().track.frames() - 1, out_);
  out_.endRow();
}

void ResultWriter::writeOptions(const TunedRecording& tuned, const TuneOptions& options) {
  out_.attribute("recording", tuned.recording);
  out_.attribute("frames", static_cast<long long>(tuned.frames));
  out_.attribute("t0", tuned.t0);
  out_.attribute("t1", tuned.t1);
  out_.attribute("unjudged", tuned.unjudged);
  out_.attribute("limit", options.pass.limit);
  out_.attribute("reaction_time", options.pass.braking.reaction_time);
  out_.attribute("deceleration", options.pass.braking.deceleration);
  out_.attribute("near", options.pass.near);
  out_.attribute("calibration_error", options.pass.calibration_error);
  out_.attribute("latency", options.pass.latency);
  safety::SeparationOptions::eachNumber(options.pass.separation,
                                        [&](const char* key, const double& value, const config::NumberRule&) {
                                          out_.attribute(std::string("separation_") + key, value);
                                        });
  out_.attribute("contact_limits", tuned.contact_limits);
  out_.attribute("separation_edition", tuned.separation_edition);
  out_.attribute("separation_table", tuned.separation_table);
  std::vector<std::string> terms;
  for (const CitedTerm& term : tuned.separation_terms) terms.push_back(termLine(term));
  out_.texts("separation_terms", terms);
  out_.texts("stated", options.stated);
  std::vector<std::string> regions;
  for (const contact::RegionLimits& region : tuned.regions) regions.push_back(regionLine(region));
  out_.texts("contact_regions", regions);
  out_.texts("frame_regions", tuned.pass.regions);
  out_.attribute("content", tuned.content);
  const auto& warm = tuned.warm_start;
  out_.attribute("cold_start_every", warm ? static_cast<long long>(warm->block) : kColdStarts);
  out_.attribute("far_tolerance", warm ? warm->far_tolerance : 0.0);
  std::vector<std::string> reservations;
  for (const run::Reservation& r : tuned.reservations) reservations.push_back(reservationLine(r));
  out_.texts("reservations", reservations);
  std::vector<std::string> excluded;
  for (const PartClearance& p : tuned.pass.parts)
    if (p.contact_excluded) excluded.push_back(p.part);
  out_.texts("contact_excluded", excluded);
  out_.texts("clamped", tuned.clamped);
  std::vector<std::string> people;
  for (const PersonNote& person : tuned.people) people.push_back(person.name + "\t" + person.text);
  out_.texts("people", people);
  std::vector<std::string> files;
  for (const InputFile& file : tuned.files) files.push_back(file.content + "\t" + file.name);
  out_.texts("files", files);
}

void ResultWriter::writeEnclosed(const std::vector<humanmodel::EnclosedShare>& shares) {
  const std::size_t table = out_.table("enclosed", {2});
  for (const humanmodel::EnclosedShare& share : shares) {
    out_.add(table, share.at_stature);
    out_.add(table, share.all_statures);
    out_.endRow();
  }
}

void ResultWriter::writeApproaches(const std::vector<Approach>& all) {
  std::vector<std::string> regions;
  const std::size_t approaches = out_.table("approaches", {kApproachColumns});
  for (const Approach& a : all) {
    const ContactShare& c = a.contact;
    for (const double v :
         {static_cast<double>(a.part), static_cast<double>(a.link), a.t, a.distance, a.clearance,
          a.motion.robot_speed, a.motion.person_speed, a.motion.robot_mass, c.t, c.closing,
          c.excluded ? 1.0 : 0.0, c.force, c.energy, c.share, c.pressure, c.pressure_share,
          c.kind == contact::ContactKind::kQuasiStatic ? 1.0 : 0.0, toolNumber(a.tool), c.robot_mass})
      out_.add(approaches, v);
    out_.endRow();
    regions.push_back(c.region);
  }
  out_.texts("approach_regions", regions);
}

void ResultWriter::writeNeeds(const PassResult& pass) {
  const std::size_t needs = out_.table("needs", {kNeedColumns});
  for (const auto* list : {&pass.link_needs, &pass.pair_needs})
    for (const MarginNeed& n : *list) {
      for (const double v : {n.margin, n.decided ? 1.0 : 0.0, n.t, n.clearance, n.bound, n.pose, n.sampling})
        out_.add(needs, v);
      out_.endRow();
    }
}

void ResultWriter::commit(const TunedRecording& tuned, const TuneOptions& options) {
  const PassResult& pass = tuned.pass;
  if (!begun_) {
    begin(pass);
    for (std::size_t i = 0; i < pass.parts.front().track.frames(); ++i) {
      parts_.add(pass.parts, i, out_);
      out_.endRow();
    }
  }
  writeOptions(tuned, options);
  // The rows of the frames are complete; later tables have their own.
  out_.nextTables();
  writeApproaches(pass.approaches);
  out_.nextTables();
  writeNeeds(pass);
  out_.nextTables();
  writeWorstSeparation(pass.parts, out_);
  out_.nextTables();
  writeWorstContacts(pass.parts, out_);
  out_.nextTables();
  writeExposure(pass.exposure, out_);
  out_.nextTables();
  writeEnclosed(tuned.enclosed);
  out_.commit();
}

bool isResult(const std::filesystem::path& file, const ContentKey& key) {
  try {
    const hdf5::TableReader in(file);
    return in.integer("abstand_result") == kResultFormat && in.text("key") == key.hex();
  } catch (const ParseError&) {
    return false;
  }
}

FrameReader::FrameReader(const TunedRecording& recording) : recording_{recording}, in_{recording.file} {
  for (const PartClearance& p : recording.pass.parts) parts_.push_back(p.part);
  if (in_.integer("abstand_result") != kResultFormat || in_.text("recording") != recording.recording ||
      in_.texts("parts") != parts_ || in_.extents("t").rows != recording.frames)
    throw ParseError({recording.file.string()},
                     "found another result than before, expected that it stays while it is used");
}

PartTableNames FrameReader::names() const {
  const PassResult& pass = recording_.pass;
  return {parts_, pass.links.size(), pass.tools.size(), pass.regions.size(), recording_.frames};
}

void FrameReader::read(std::vector<PartClearance>& parts) const {
  readPartFrames(in_, names(), recording_.file.string(), parts);
}

void FrameReader::read(std::size_t p, PartClearance& part) const {
  readPartFrames(in_, names(), recording_.file.string(), p, part);
}

StoredResult readResult(const std::filesystem::path& file, std::size_t max_frames) {
  const hdf5::TableReader in(file);
  const auto fail = [&](const std::string& what) { throw ParseError({file.string()}, what); };
  if (const long long format = in.integer("abstand_result"); format != kResultFormat)
    fail("found a result of format " + std::to_string(format) + ", expected " +
         std::to_string(kResultFormat) + ": it was written by another version");
  StoredResult stored;
  stored.key = in.text("key");
  stored.version = in.text("version");
  TunedRecording& tuned = stored.tuned;
  tuned.recording = in.text("recording");
  tuned.t0 = in.number("t0");
  tuned.t1 = in.number("t1");
  tuned.unjudged = in.number("unjudged");
  stored.options.pass.limit = in.number("limit");
  stored.options.pass.near = in.number("near");
  stored.options.pass.calibration_error = in.number("calibration_error");
  stored.options.pass.latency = in.number("latency");
  tuned.contact_limits = in.text("contact_limits");
  for (const std::string& text : in.texts("contact_regions"))
    tuned.regions.push_back(regionOf(text, file.string()));
  tuned.separation_edition = in.text("separation_edition");
  tuned.separation_table = in.text("separation_table");
  for (const std::string& text : in.texts("separation_terms"))
    tuned.separation_terms.push_back(termOf(text, file.string()));
  tuned.content = in.text("content");
  tuned.warm_start = warmStartOf(in, file.string());
  safety::SeparationOptions::eachNumber(stored.options.pass.separation,
                                        [&](const char* key, double& value, const config::NumberRule&) {
                                          value = in.number(std::string("separation_") + key);
                                        });
  stored.options.pass.braking = {in.number("reaction_time"), in.number("deceleration")};
  for (const std::string& text : in.texts("reservations"))
    tuned.reservations.push_back(reservationOf(text, file.string()));
  tuned.clamped = in.texts("clamped");
  stored.options.stated = in.texts("stated");
  for (const std::string& text : in.texts("people")) {
    const auto tab = std::min(text.find('\t'), text.size());
    tuned.people.push_back({text.substr(0, tab), text.substr(std::min(tab + 1, text.size()))});
  }
  for (const std::string& text : in.texts("files")) {
    const auto tab = std::min(text.find('\t'), text.size());
    tuned.files.push_back({text.substr(std::min(tab + 1, text.size())), text.substr(0, tab)});
  }
  const std::vector<std::string> parts = in.texts("parts");
  tuned.pass.links = in.texts("links");
  tuned.pass.tools = in.texts("tools");
  tuned.pass.regions = in.texts("frame_regions");
  if (parts.empty() || parts.size() > kMaxNames || tuned.pass.links.empty() ||
      tuned.pass.links.size() > kMaxNames || tuned.pass.tools.size() > kMaxNames)
    fail("found no parts or no links, expected some");
  readPairs(in, parts.size(), tuned.pass, file.string());
  tuned.file = file;
  tuned.frames = in.extents("t").rows;
  const PartTableNames names{parts, tuned.pass.links.size(), tuned.pass.tools.size(),
                             tuned.pass.regions.size(), tuned.frames};
  tuned.pass.parts = readPartTables(in, names, file.string());
  if (tuned.frames <= max_frames / parts.size()) readPartFrames(in, names, file.string(), tuned.pass.parts);
  tuned.pass.approaches = approachesOf(in, parts.size(), tuned.pass, file.string());
  tuned.enclosed = enclosedOf(in, parts.size(), file.string());
  tuned.pass.exposure = readExposure(in, {parts.size(), tuned.pass.links.size()}, file.string());
  return stored;
}

}  // namespace abstand::tune
