// Fuzzes the reader of results. Its checksum keeps other bytes from the HDF5 library, so the input says what
// a file of right checksum holds: which tables, of which sizes, with which numbers. Only ParseError may come
// out, and what was read can be judged.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "app/hdf5/table_writer.hpp"
#include "app/tune/margin_events.hpp"
#include "app/tune/margin_table.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/result_key.hpp"
#include "core/base/error.hpp"

namespace {

using namespace abstand;

/// Takes choices and numbers off the input; behind its end everything is 0, which means "as it should be".
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  std::uint8_t byte() { return at_ < end_ ? *at_++ : 0; }
  /// True for one of eight bytes.
  bool rarely() { return byte() % 8 == 7; }
  /// Near what a result has there, or anything.
  double number(double usual) {
    const std::uint8_t kind = byte();
    if (kind < 160) return usual;
    if (kind < 200) return usual + (static_cast<int>(byte()) - 128) / 64.0;
    static constexpr std::array kOdd{0.0,     -1.0,   1e300, -1e300,    65535.0,
                                     65536.0, 1e-320, kNaN,  kInfinity, -kInfinity};
    if (kind < 240) return kOdd[byte() % kOdd.size()];
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  std::string text(const std::string& usual) {
    if (!rarely()) return usual;
    std::string some;
    for (int i = byte() % 16; i > 0; --i) some += static_cast<char>(byte());
    return some;
  }
  std::size_t count(std::size_t usual) { return rarely() ? byte() % 5 : usual; }

 private:
  const std::uint8_t *at_, *end_;
};

/// A result of a few frames, as ResultWriter writes it but for what the input changes.
class OddResult {
 public:
  OddResult(const std::filesystem::path& file, Choices& choices) : out_(file), in_(choices) {}

  void write() {
    attributes();
    lists();
    const std::size_t frames = 1 + in_.byte() % 4, parts = 2;
    table("t", frames, {}, [](std::size_t row, std::size_t) { return 0.1 * static_cast<double>(row); });
    table("part_values", frames, {parts, 10},
          [](std::size_t, std::size_t i) { return i % 10 == 6 || i % 10 == 9 ? 1.0 : 0.3; });
    table("part_separation", frames, {parts, 2}, [](std::size_t, std::size_t) { return 0.5; });
    table("part_speeds", frames, {parts, 2}, [](std::size_t, std::size_t) { return 0.5; });
    table("worst_separation", parts, {10}, [](std::size_t, std::size_t) { return 0.5; });
    table("pairs", 2, {3},
          [](std::size_t row, std::size_t i) { return i == 0 ? 0.0 : static_cast<double>(row); });
    table("needs", 5, {7}, [](std::size_t, std::size_t) { return 0.1; });
    table("approaches", in_.byte() % 3, {19}, [](std::size_t, std::size_t) { return 0.5; });
    table("part_contact", frames, {parts}, [](std::size_t, std::size_t) { return 0.5; });
    out_.texts("contact_excluded", {"part1"});
    table("enclosed", parts, {2}, [](std::size_t, std::size_t) { return 0.5; });
    out_.texts("clamped", {"part2"});
    out_.texts("stated", {in_.text("limit")});
    // link, region, force, energy, pressure, share
    table("part_contacts", frames, {parts, 6},
          [](std::size_t, std::size_t i) { return i % 6 < 2 ? 0.0 : 0.5; });
    table("worst_contacts", parts, {8},
          [](std::size_t, std::size_t i) { return i == 2 || i == 3 ? 0.0 : 0.5; });
    out_.texts("frame_regions", {in_.text("chest")});
    out_.texts("separation_terms", {in_.text("near\t0.5\tan edition\t")});
    out_.texts("contact_regions",
               {in_.text("chest\tsternum\t140\ta\t\t2\ta\t\t1200000\ta\t\t25000\ta\t\t40\ta\tb")});
    out_.texts("files", {in_.text("0123\tscene.yaml")});
    out_.texts("people", {in_.text("person\t1.750 m")});
    out_.commit();
  }

 private:
  void attributes() {
    for (const char* name : {"limit", "reaction_time", "deceleration", "near", "t0", "t1", "unjudged"})
      if (!in_.rarely()) out_.attribute(name, in_.number(0.1));
    const safety::SeparationOptions separation;
    safety::SeparationOptions::eachNumber(
        separation, [&](const char* key, const double& value, const config::NumberRule&) {
          const std::string name = std::string("separation_") + key;
          if (!in_.rarely()) return out_.attribute(name, in_.number(value));
          if (!in_.rarely()) out_.attribute(name, in_.text("0.1"));
        });
    for (const char* name : {"key", "version", "recording", "contact_limits", "separation_edition",
                             "separation_table", "content"})
      if (!in_.rarely()) out_.attribute(name, in_.text(name));
    out_.attribute("calibration_error", 0.0);
    out_.attribute("latency", 0.0);
    if (!in_.rarely()) out_.attribute("cold_start_every", in_.rarely() ? -1LL : 128LL);
    out_.attribute("far_tolerance", in_.number(0.002));
    out_.attribute("abstand_result", tune::kResultFormat + static_cast<long long>(in_.rarely()));
  }
  void lists() {
    std::vector<std::string> parts, links, reservations, regions;
    for (std::size_t i = in_.count(2); i > 0; --i) parts.push_back(in_.text("part" + std::to_string(i)));
    for (std::size_t i = in_.count(3); i > 0; --i) links.push_back(in_.text("link" + std::to_string(i)));
    for (std::size_t i = in_.count(1); i > 0; --i)
      reservations.push_back(in_.text("gap\t1\t0.5\t0.7\t0.1\ttext"));
    for (std::size_t i = in_.count(in_.byte() % 3); i > 0; --i) regions.push_back(in_.text("chest"));
    if (!in_.rarely()) out_.texts("parts", parts);
    if (!in_.rarely()) out_.texts("links", links);
    std::vector<std::string> tools;
    for (std::size_t i = in_.count(1); i > 0; --i) tools.push_back(in_.text("tool" + std::to_string(i)));
    if (!in_.rarely()) out_.texts("tools", tools);
    if (!in_.rarely()) out_.texts("reservations", reservations);
    if (!in_.rarely()) out_.texts("approach_regions", regions);
  }
  template <class Usual>
  void table(const char* name, std::size_t rows, std::vector<std::size_t> row, const Usual& usual) {
    if (in_.rarely()) return;
    out_.nextTables();
    rows = in_.count(rows);
    for (std::size_t& n : row) n = std::max<std::size_t>(1, in_.count(n));
    std::size_t width = 1;
    for (const std::size_t n : row) width *= n;
    static constexpr std::array kStorages{hdf5::Storage::kDouble, hdf5::Storage::kSteps32,
                                          hdf5::Storage::kSteps16};
    const hdf5::Storage storage = kStorages[in_.rarely() ? in_.byte() % 3u : 0u];
    const std::size_t number = out_.table(name, row, storage, 1.0 / 16384.0);
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t i = 0; i < width; ++i) out_.add(number, in_.number(usual(r, i)));
      out_.endRow();
    }
  }

  hdf5::TableWriter out_;
  Choices& in_;
};

void judge(const tune::StoredResult& stored) {
  const std::vector<tune::TunedRecording> alone{stored.tuned};
  for (const tune::PartClearance& p : stored.tuned.pass.parts) {
    ABSTAND_CHECK(p.link.size() == stored.tuned.frames && p.distance.size() == stored.tuned.frames);
    for (const std::uint16_t link : p.link) ABSTAND_CHECK(link < stored.tuned.pass.links.size());
    for (const std::uint16_t tool : p.tool)
      ABSTAND_CHECK(tool == tune::kNoTool || tool < stored.tuned.pass.tools.size());
    ABSTAND_CHECK(p.contact.size() == stored.tuned.frames);
    for (const tune::FrameContact& c : p.contact) {
      ABSTAND_CHECK(c.region == tune::kNoRegion ||
                    (c.region < stored.tuned.pass.regions.size() && c.link < stored.tuned.pass.links.size()));
      ABSTAND_CHECK(c.share >= 0.0 && c.force >= 0.0 && c.pressure >= 0.0);
    }
    if (p.separation.worst) ABSTAND_CHECK(p.separation.worst->link < stored.tuned.pass.links.size());
  }
  for (const auto& pair : stored.tuned.pass.pairs)
    ABSTAND_CHECK(pair.tool == tune::kNoTool || pair.tool < stored.tuned.pass.tools.size());
  for (const tune::Approach& a : stored.tuned.pass.approaches)
    ABSTAND_CHECK(a.part < stored.tuned.pass.parts.size() && a.link < stored.tuned.pass.links.size());
  tune::marginTable(alone, {0.0, 0.2}, stored.options);
  tune::marginEvents(alone.front(), 0.2, stored.options.margins());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto file =
      std::filesystem::temp_directory_path() / ("abstand-result-fuzz" + std::to_string(::getpid()) + ".h5");
  Choices choices(data, size);
  OddResult(file, choices).write();
  try {
    judge(tune::readResult(file));
  } catch (const ParseError&) {
  }
  return 0;
}
