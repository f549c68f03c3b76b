#include "app/tune/part_tables.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tune {
namespace {

/// Columns of one part, in file order.
const char* const kPartColumns[] = {"clearance",   "between", "braking", "distance", "bound",
                                    "uncertainty", "link",    "age",     "latency",  "tool"};
constexpr std::size_t kPartColumnCount = std::size(kPartColumns);
/// m: stands for an infinite missing distance of an unseen part; files contain no infinity.
constexpr double kAllMissing = 1e4;
constexpr double kNoLink = 65535.0;  // above the largest number of names
/// t (none: it was kept), link, clearance, speeds of robot and person, the terms, permitted speed, time
/// broken.
constexpr std::size_t kSeparationColumns = 11;
/// Columns of the predicted contact of one part, in file order.
constexpr std::size_t kContactColumns = 6;
/// Frames that are read at once.
constexpr std::size_t kFramesInBlock = 4096;

std::optional<SeparationMoment> worstMoment(const double* worst) {
  if (std::isnan(worst[0])) return std::nullopt;
  // NaN is treated as no link, too.
  const bool any = worst[1] >= 0.0 && worst[1] <= kNoLink;
  return SeparationMoment{worst[0], static_cast<std::uint16_t>(any ? worst[1] : kNoLink),
                          worst[2], worst[3],
                          worst[4], {worst[5], worst[6], worst[7], worst[8]},
                          worst[9]};
}

/// Undoes what the conversion of a unit did to a number of whole steps.
double wholeSteps(double value) { return std::round(value / kContactStep) * kContactStep; }

/// Adds the columns of a contact, whose numbers are whole steps.
void addContact(const FrameContact& c, std::vector<double>& row) {
  if (!(c.share > 0.0))
    row.insert(row.end(), kContactColumns, kNaN);
  else if (c.region == kNoRegion)
    row.insert(row.end(), {kNaN, kNaN, kNaN, kNaN, kNaN, kInfiniteShare});
  else
    row.insert(row.end(),
               {static_cast<double>(c.link), static_cast<double>(c.region), wholeSteps(c.force),
                wholeSteps(c.energy), wholeSteps(std::min(c.pressure * kPerSquareCentimetre, kMaxContact)),
                wholeSteps(std::min(c.share, kInfiniteShare))});
}

/// Reads the columns of a contact.
FrameContact contactOf(const double* v, const PartTableNames& names, const std::string& file) {
  FrameContact contact;
  if (std::isnan(v[5])) return contact;
  contact.share = v[5] >= kInfiniteShare ? kInfinity : v[5];
  if (!(contact.share > 0.0))
    throw ParseError({file}, "found a predicted contact with a share that is not positive");
  if (std::isnan(v[1])) return contact;
  if (!(v[0] >= 0.0 && v[0] < static_cast<double>(names.links) && v[1] >= 0.0 &&
        v[1] < static_cast<double>(names.regions)))
    throw ParseError({file}, "found a predicted contact with an unknown link or region");
  if (!(v[2] >= 0.0 && v[3] >= 0.0 && v[4] >= 0.0))
    throw ParseError({file}, "found a predicted contact with a number below 0");
  contact.link = static_cast<std::uint16_t>(v[0]);
  contact.region = static_cast<std::uint16_t>(v[1]);
  contact.force = v[2];
  contact.energy = v[3];
  contact.pressure = v[4] >= kMaxContact ? kInfinity : v[4] / kPerSquareCentimetre;
  return contact;
}

/// Fills the lists of parts, block by block.
class PartLists {
 public:
  PartLists(const hdf5::TableReader& in, const PartTableNames& names, const std::string& file)
      : in_{in}, names_{names}, file_{file} {
    for (const auto& [table, width] :
         std::initializer_list<std::pair<const char*, std::size_t>>{{"part_values", kPartColumnCount},
                                                                    {"part_separation", 2},
                                                                    {"part_speeds", 2},
                                                                    {"part_contact", 1},
                                                                    {"part_contacts", kContactColumns}})
      in.expect(table, names.frames, width * names.parts.size());
  }

  /// Of all parts, or of the only one at index `first_part`.
  void read(std::span<PartClearance> parts, std::size_t first_part) const {
    const std::vector<double> t = in_.table("t", names_.frames, 1);
    for (PartClearance& part : parts) {
      reserveFrames(names_.frames, part);
      part.track.t = t;
    }
    const std::size_t n = parts.size();
    const bool all = n == names_.parts.size();
    for (std::size_t first = 0; first < names_.frames; first += kFramesInBlock) {
      const std::size_t count = std::min(kFramesInBlock, names_.frames - first);
      const auto rows = [&](const char* table, std::size_t width) {
        return all ? in_.rows(table, first, count, n * width)
                   : in_.rowsOf(table, first_part, first, count, width);
      };
      const std::vector<double> values = rows("part_values", kPartColumnCount),
                                separation = rows("part_separation", 2), speeds = rows("part_speeds", 2),
                                contact = rows("part_contact", 1),
                                contacts = rows("part_contacts", kContactColumns);
      for (std::size_t p = 0; p < n; ++p)
        for (std::size_t i = 0; i < count; ++i) {
          const std::size_t at = i * n + p;
          addValues(values.data() + at * kPartColumnCount, parts[p]);
          addMissing(separation[2 * at], share(separation[2 * at + 1]), parts[p].separation);
          parts[p].robot_speed.push_back(speeds[2 * at]);
          parts[p].person_speed.push_back(speeds[2 * at + 1]);
          parts[p].contact_scale.push_back(share(contact[at]));
          parts[p].contact.push_back(contactOf(contacts.data() + at * kContactColumns, names_, file_));
        }
    }
    for (const PartClearance& part : parts) {
      try {
        margin::validate(part.track);
      } catch (const UsageError& e) {
        throw ParseError({file_}, e.what());
      }
    }
  }

 private:
  void addValues(const double* v, PartClearance& part) const {
    part.track.clearance.push_back(v[0]);
    part.track.between.push_back(v[1]);
    part.track.braking.push_back(v[2]);
    part.distance.push_back(v[3]);
    part.bound.push_back(v[4]);
    part.uncertainty.push_back(v[5]);
    if (!(v[6] >= 0.0 && v[6] < static_cast<double>(names_.links)))
      throw ParseError({file_}, "found the number of a link that is not among the links");
    part.link.push_back(static_cast<std::uint16_t>(v[6]));
    part.age_uncertainty.push_back(v[7]);
    part.latency_uncertainty.push_back(v[8]);
    part.tool.push_back(toolOf(v[9], names_.tools, file_));
  }
  static void addMissing(double missing, double scale, PartSeparation& separation) {
    separation.missing.push_back(std::isnan(missing)      ? -kInfinity
                                 : missing >= kAllMissing ? kInfinity
                                                          : missing);
    separation.speed_scale.push_back(scale);
  }
  double share(double value) const {
    if (!(value >= 0.0 && value <= 1.0))
      throw ParseError({file_}, "found a permitted share of the speed outside of 0 to 1");
    return value;
  }

  const hdf5::TableReader& in_;
  const PartTableNames& names_;
  const std::string& file_;
};

}  // namespace

double toolNumber(std::uint16_t tool) { return tool == kNoTool ? 0.0 : tool + 1.0; }

std::uint16_t toolOf(double number, std::size_t tools, const std::string& file) {
  if (!(number >= 0.0 && number <= static_cast<double>(tools)))
    throw ParseError({file}, "found the number of a tool that is not among the tools");
  return number < 1.0 ? kNoTool : static_cast<std::uint16_t>(number - 1.0);
}

void PartTableWriter::begin(std::size_t parts, hdf5::TableWriter& out) {
  using hdf5::Storage;
  t_ = out.table("t", {});
  values_ = out.table("part_values", {parts, kPartColumnCount});
  separation_ = out.table("part_separation", {parts, 2}, Storage::kSteps32, kSpeedStep);
  speeds_ = out.table("part_speeds", {parts, 2}, Storage::kSteps32, kSpeedStep);
  contact_ = out.table("part_contact", {parts}, Storage::kSteps32, kSpeedStep);
  contacts_ = out.table("part_contacts", {parts, kContactColumns}, Storage::kSteps32, kContactStep);
  out.describe(contacts_, "1, 1, N, J, N/cm^2, 1", "link region force energy pressure share");
  out.texts("part_columns", {std::begin(kPartColumns), std::end(kPartColumns)});
}

void PartTableWriter::add(const std::vector<PartClearance>& parts, std::size_t i, hdf5::TableWriter& out) {
  out.add(t_, parts.front().track.t[i]);
  row_.clear();
  for (const PartClearance& p : parts)
    row_.insert(row_.end(), {p.track.clearance[i], p.track.between[i], p.track.braking[i], p.distance[i],
                             p.bound[i], p.uncertainty[i], static_cast<double>(p.link[i]),
                             p.age_uncertainty[i], p.latency_uncertainty[i], toolNumber(p.tool[i])});
  out.add(values_, row_);
  row_.clear();
  for (const PartClearance& p : parts) row_.insert(row_.end(), {p.robot_speed[i], p.person_speed[i]});
  out.add(speeds_, row_);
  row_.clear();
  for (const PartClearance& p : parts) {
    const double missing = p.separation.missing[i];
    row_.insert(row_.end(),
                {missing == -kInfinity ? kNaN : std::min(missing, kAllMissing), p.separation.speed_scale[i]});
  }
  out.add(separation_, row_);
  row_.clear();
  for (const PartClearance& p : parts) row_.push_back(p.contact_scale[i]);
  out.add(contact_, row_);
  row_.clear();
  for (const PartClearance& p : parts) addContact(p.contact[i], row_);
  out.add(contacts_, row_);
}

void writeWorstSeparation(const std::vector<PartClearance>& all, hdf5::TableWriter& out) {
  const std::size_t worst = out.table("worst_separation", {kSeparationColumns});
  for (const PartClearance& p : all) {
    SeparationMoment none;
    none.t = kNaN;
    const SeparationMoment m = p.separation.worst.value_or(none);
    for (const double v :
         {m.t, static_cast<double>(m.link), m.clearance, m.robot_speed, m.person_speed, m.needed.person,
          m.needed.reaction, m.needed.stopping, m.needed.constant, m.permitted_speed, p.separation.broken})
      out.add(worst, v);
    out.endRow();
  }
}

void writeWorstContacts(const std::vector<PartClearance>& all, hdf5::TableWriter& out) {
  const std::size_t worst = out.table("worst_contacts", {2 + kContactColumns});
  std::vector<double> row;
  for (const PartClearance& p : all) {
    const ContactMoment moment = p.contacts.worst.value_or(ContactMoment{kNaN, {}});
    row = {moment.t, p.contacts.exceeded};
    addContact(moment.contact, row);
    out.add(worst, row);
    out.endRow();
  }
}

std::vector<PartClearance> readPartTables(const hdf5::TableReader& in, const PartTableNames& names,
                                          const std::string& file) {
  const std::vector<double> worst = in.table("worst_separation", names.parts.size(), kSeparationColumns);
  const std::vector<double> contacts = in.table("worst_contacts", names.parts.size(), 2 + kContactColumns);
  const std::vector<std::string> excluded = in.texts("contact_excluded");
  std::vector<PartClearance> parts(names.parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    PartClearance& part = parts[p];
    part.part = names.parts[p];
    part.contact_excluded = std::find(excluded.begin(), excluded.end(), part.part) != excluded.end();
    part.separation.worst = worstMoment(worst.data() + p * kSeparationColumns);
    part.separation.broken = worst[p * kSeparationColumns + kSeparationColumns - 1];
    if (!(part.separation.broken >= 0.0 && std::isfinite(part.separation.broken)))
      throw ParseError({file}, "found an invalid time of a broken protective distance, expected seconds");
    const double* contact = contacts.data() + p * (2 + kContactColumns);
    part.contacts.exceeded = contact[1];
    if (!std::isnan(contact[0])) part.contacts.worst = {contact[0], contactOf(contact + 2, names, file)};
    if (!(part.contacts.exceeded >= 0.0 && std::isfinite(part.contacts.exceeded)))
      throw ParseError({file}, "found an invalid time of exceeded contact limits, expected seconds");
    if (part.separation.worst && part.separation.worst->link >= names.links)
      throw ParseError({file}, "found the number of a link that is not among the links");
  }
  return parts;
}

void readPartFrames(const hdf5::TableReader& in, const PartTableNames& names, const std::string& file,
                    std::vector<PartClearance>& parts) {
  PartLists(in, names, file).read(parts, 0);
}

void readPartFrames(const hdf5::TableReader& in, const PartTableNames& names, const std::string& file,
                    std::size_t p, PartClearance& part) {
  PartLists(in, names, file).read({&part, 1}, p);
}

}  // namespace abstand::tune
