// Reads marker sets, finds their markers in a file, and places them on a rig.
#include "tracking/markers/marker_set.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/recording/name_index.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr std::uintmax_t kMaxSetBytes = 1 << 20;
constexpr std::size_t kMaxMarkers = 500;
constexpr std::size_t kFewestMarkers = 6, kFewestSegments = 3;
constexpr double kFarthestPlace = 5.0;                  // shares
constexpr double kMinSpread = 0.001, kMaxSpread = 0.5;  // m

struct Word {
  std::string_view text;
  int column;
};

/// The words of a line with their columns, starting at `from`.
std::vector<Word> wordsFrom(std::string_view line, std::size_t from) {
  std::vector<Word> words;
  while (true) {
    from = line.find_first_not_of(" \t\r", from);
    if (from == std::string_view::npos) return words;
    const std::size_t to = std::min(line.find_first_of(" \t\r", from), line.size());
    words.push_back({line.substr(from, to - from), static_cast<int>(from) + 1});
    from = to;
  }
}

double numberIn(const Word& word, double min, double max, SourcePos pos) {
  const auto value = parseDouble(word.text);
  if (value && *value >= min && *value <= max) return *value;
  pos.column = word.column;
  throw ParseError(pos, "found " + text::inQuotes(word.text) + ", expected a number from " +
                            formatDouble(min) + " to " + formatDouble(max));
}

std::optional<RigSegment> parseSegment(std::string_view name) {
  for (std::size_t i = 0; i < kRigSegments; ++i)
    if (segmentName(segmentAt(i)) == name) return segmentAt(i);
  return std::nullopt;
}

std::vector<std::string> segmentNames() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kRigSegments; ++i) names.emplace_back(segmentName(segmentAt(i)));
  return names;
}

/// Parses "SEGMENT FORWARD OUTWARD ALONG [SPREAD]" after the colon.
SetMarker parseMarker(std::string_view line, std::size_t colon, SourcePos pos) {
  SetMarker marker;
  marker.names = namesBetweenBars(line.substr(0, colon), pos);
  const auto words = wordsFrom(line, colon + 1);
  pos.column = words.empty() ? static_cast<int>(colon) + 1 : words.front().column;
  if (words.size() != 4 && words.size() != 5)
    throw ParseError(pos, "found " + std::to_string(words.size()) +
                              " words, expected 'LABEL: SEGMENT FORWARD OUTWARD ALONG [SPREAD]'");
  const auto segment = parseSegment(words[0].text);
  if (!segment) {
    const auto near = nearestName(std::string(words[0].text), segmentNames());
    throw ParseError(pos, "found " + text::inQuotes(words[0].text) + ", expected a segment of the body",
                     near.empty() ? "" : "did you mean '" + near + "'?");
  }
  marker.segment = *segment;
  for (int k = 0; k < 3; ++k)
    marker.place[k] = numberIn(words[static_cast<std::size_t>(k) + 1], -kFarthestPlace, kFarthestPlace, pos);
  if (words.size() == 5) marker.spread = numberIn(words[4], kMinSpread, kMaxSpread, pos);
  return marker;
}

Vector3d placeOn(const BodyRig& rig, const SetMarker& marker) {
  const RigSegment s = marker.segment;
  const Vector3d far = farJoint(rig, s);
  const double outward = (sideOf(s) < 0 ? -1.0 : 1.0) * marker.place.y() * halfExtent(rig[s].shape, 1);
  if (s == kFootLeft || s == kFootRight)
    return {marker.place.x() * far.x(), outward, marker.place.z() * far.z()};
  return {marker.place.x() * halfExtent(rig[s].shape, 0), outward, marker.place.z() * far.z()};
}

}  // namespace

double halfExtent(const geometry::Shape& shape, int axis) {
  if (const auto* e = std::get_if<geometry::Ellipsoid>(&shape)) return e->semi_axes[axis];
  if (const auto* c = std::get_if<geometry::Cuboid>(&shape)) return 0.5 * c->size[axis];
  ABSTAND_CHECK(!"parts are ellipsoids or cuboids");
}

Vector3d farJoint(const BodyRig& rig, RigSegment s) {
  const auto joint = [&](humanmodel::Joint j) { return rig.p_joint[static_cast<std::size_t>(j)]; };
  switch (s) {
    case kPelvis:
      return rig[kChest].p_parent;
    case kChest:
      return rig[kHead].p_parent;
    case kHead:
      return joint(humanmodel::Joint::kHeadTop);
    case kHandLeft:
      return joint(humanmodel::Joint::kHandLeft);
    case kHandRight:
      return joint(humanmodel::Joint::kHandRight);
    case kFootLeft:
      return joint(humanmodel::Joint::kToeLeft);
    case kFootRight:
      return joint(humanmodel::Joint::kToeRight);
    default:
      // Arms and legs: the only child segment.
      for (std::size_t i = index(s) + 1; i < kRigSegments; ++i)
        if (rig.parts[i].parent == s) return rig.parts[i].p_parent;
      ABSTAND_CHECK(!"a limb ends at another segment");
  }
}

MarkerSet parseMarkerSet(std::string_view text, const std::filesystem::path& file) {
  MarkerSet set;
  set.file = file;
  std::set<std::string> seen;
  SourcePos pos{file.string()};
  for (std::size_t from = 0; from < text.size();) {
    ++pos.line;
    const auto to = std::min(text.find('\n', from), text.size());
    const auto line = text.substr(from, to - from);
    from = to + 1;
    const auto bare = trimmed(line);
    if (bare.empty() || bare.front() == '#') continue;
    const auto colon = line.find(':');
    if (colon == std::string_view::npos)
      throw ParseError({pos.file, pos.line, 1}, "found " + text::inQuotes(bare) + ", expected 'key: value'");
    const auto key = trimmed(line.substr(0, colon));
    const auto value = trimmed(line.substr(colon + 1));
    if (key == "name")
      set.name = value;
    else if (key == "origin")
      set.origin = value;
    else if (key == "licence")
      set.licence = value;
    else if (key == "prefix")
      set.prefixes = namesBetweenBars(value, pos);
    else if (key == "requires")
      set.required = namesBetweenBars(value, pos);
    else {
      set.markers.push_back(parseMarker(line, colon, pos));
      for (const auto& name : set.markers.back().names)
        if (!seen.insert(plainName(name)).second)
          throw ParseError({pos.file, pos.line, 1},
                           "found " + text::inQuotes(name) + " a second time, expected it once");
      if (set.markers.size() > kMaxMarkers)
        throw ParseError({pos.file, pos.line, 1},
                         "found more than " + std::to_string(kMaxMarkers) + " markers, expected fewer");
    }
  }
  if (set.name.empty()) throw ParseError({file.string()}, "found no 'name:' line, expected the set's name");
  if (set.markers.empty()) throw ParseError({file.string()}, "found no marker, expected at least one");
  return set;
}

MarkerSet loadMarkerSet(const std::filesystem::path& file) {
  return parseMarkerSet(readFile(file, kMaxSetBytes), file);
}

std::vector<MarkerSet> loadMarkerSets(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".markers") files.push_back(it->path());
  std::sort(files.begin(), files.end());
  std::vector<MarkerSet> sets;
  for (const auto& file : files) sets.push_back(loadMarkerSet(file));
  return sets;
}

MarkerMatch matchMarkers(const MarkerSet& set, const BodyRig& rig, std::span<const std::string> names) {
  MarkerMatch match;
  match.set = set.name;
  const NameIndex index(names, set.prefixes);
  for (const auto& name : set.required)
    if (index.find(name) < 0) return match;
  for (const SetMarker& marker : set.markers) {
    FoundMarker found;
    for (const auto& name : marker.names) {
      found.points = index.points(name);
      if (!found.points.empty()) break;
    }
    if (found.points.empty()) {
      match.not_found.push_back(marker.names.front());
      continue;
    }
    for (const int i : found.points)
      found.label += (found.label.empty() ? "" : " + ") + names[static_cast<std::size_t>(i)];
    found.segment = marker.segment;
    found.p_S = placeOn(rig, marker);
    found.spread = marker.spread;
    match.markers.push_back(std::move(found));
  }
  return match;
}

bool isEnough(const MarkerMatch& match) {
  std::set<RigSegment> segments;
  for (const auto& m : match.markers) segments.insert(m.segment);
  return match.markers.size() >= kFewestMarkers && segments.size() >= kFewestSegments;
}

std::optional<MarkerMatch> chooseMarkerSet(std::span<const MarkerSet> sets, const BodyRig& rig,
                                           std::span<const std::string> names) {
  std::optional<MarkerMatch> best;
  for (const auto& set : sets) {
    MarkerMatch match = matchMarkers(set, rig, names);
    if (!isEnough(match)) continue;
    const auto key = [](const MarkerMatch& m) {
      return std::tuple(-std::ssize(m.markers), m.not_found.size());
    };
    if (!best || key(match) < key(*best)) best = std::move(match);
  }
  return best;
}

}  // namespace abstand::tracking
