#include "tests/bench/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/math/quantile.hpp"

namespace abstand::bench {
namespace {

constexpr double kNear = 0.1;       // m, where a distance matters most
constexpr double kRounding = 1e-9;  // m, of the reference itself

const char* workName(Work work) {
  switch (work) {
    case Work::kDistance:
      return "distances";
    case Work::kContact:
      return "contact depth";
    case Work::kCollide:
      return "collision test";
    case Work::kSmallest:
      return "smallest distance";
  }
  return "";
}

/// Three significant digits, never with an exponent.
std::string digits(double v) {
  constexpr int kMaxDecimals = 5;
  if (!std::isfinite(v)) return "";
  if (std::abs(v) < std::pow(10.0, -kMaxDecimals)) return "0";
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(v)))), 0, kMaxDecimals);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, v);
  return text;
}

using Times = std::map<std::size_t, double>;

/// Of the frames that are in `frames` too.
std::vector<double> common(const Times& times, const Times& frames) {
  std::vector<double> v;
  for (const auto& [frame, time] : frames)
    if (const auto it = times.find(frame); it != times.end()) v.push_back(it->second);
  return v;
}

/// Calls fn(answer, FCL's answer) for every pair of the frames that both were asked.
template <class Answers, class Fn>
void forCommon(const Answers& answers, const Answers& reference, Fn&& fn) {
  for (const auto& [frame, exact] : reference) {
    const auto it = answers.find(frame);
    for (std::size_t p = 0; it != answers.end() && p < exact.size(); ++p) fn(it->second[p], exact[p].value);
  }
}

/// Distances of one engine against FCL's.
struct Errors {
  std::vector<double> near, far;  ///< m below kNear; share of the distance beyond
  std::size_t pairs{0}, breaches{0};

  void add(const Answer& a, double truth) {
    ++pairs;
    // Written so that NaN is a breach. Who certifies nothing breaks nothing.
    if (!std::isnan(a.bound) && !(a.value - a.bound <= std::max(0.0, truth) + kRounding)) ++breaches;
    if (truth <= 0.0) return;
    const double error = std::abs(std::max(0.0, a.value) - truth);
    if (truth < kNear)
      near.push_back(error);
    else
      far.push_back(error / truth);
  }
};

/// Who touches, against FCL.
struct Touching {
  std::size_t pairs{0}, touching{0}, missed{0}, invented{0};

  void add(const Answer& a, double truth) {
    ++pairs;
    const bool says = a.value > 0.5, is = truth > 0.5;
    touching += is;
    missed += is && !says;
    invented += says && !is;
  }
};

}  // namespace

std::size_t Ledger::indexOf(const BenchScene& scene) {
  const auto it = std::ranges::find(scenes_, &scene);
  if (it != scenes_.end()) return static_cast<std::size_t>(it - scenes_.begin());
  scenes_.push_back(&scene);
  return scenes_.size() - 1;
}

void Ledger::add(const BenchScene& scene, Work work, Kind kind, std::size_t frame, double seconds,
                 std::span<const Answer> answers) {
  Row& row = rows_[{indexOf(scene), work, kind}];
  const double us = 1e6 * seconds;
  const auto [it, fresh] = row.times.try_emplace(frame, us);
  it->second = std::min(it->second, us);
  if (work == Work::kDistance || work == Work::kCollide)
    row.answers[frame].assign(answers.begin(), answers.end());
}

const Ledger::Row* Ledger::find(std::size_t scene, Work work, Kind kind) const {
  const auto it = rows_.find({scene, work, kind});
  return it == rows_.end() ? nullptr : &it->second;
}

void Ledger::print(std::ostream& out) const {
  printTimes(out);
  out << "\n";
  printAccuracy(out);
}

void Ledger::printTimes(std::ostream& out) const {
  out << "| scene | pairs | triangles | work | Abstand | FCL | FCL / Abstand | Bullet hulls | Bullet / "
         "Abstand "
         "|\n|---|---:|---:|---|---:|---:|---:|---:|---:|\n";
  for (std::size_t s = 0; s < scenes_.size(); ++s) {
    for (const Work work : {Work::kDistance, Work::kContact, Work::kCollide, Work::kSmallest}) {
      const Row* ours = find(s, work, Kind::kAbstand);
      if (!ours) continue;
      out << "| " << scenes_[s]->what << " | " << scenes_[s]->pairs.size() << " | " << scenes_[s]->triangles()
          << " | " << workName(work) << " |";
      for (const Kind kind : kKinds) {
        const Row* row = find(s, work, kind);
        const auto times = row ? common(row->times, row->times) : std::vector<double>{};
        const double median = lowerQuantile(times, 0.5);
        if (row) out << " " << digits(median) << " / " << digits(lowerQuantile(times, 0.99));
        out << " |";
        if (kind == Kind::kAbstand) continue;
        if (row) out << " " << digits(median / lowerQuantile(common(ours->times, row->times), 0.5));
        out << " |";
      }
      out << "\n";
    }
  }
}

void Ledger::printAccuracy(std::ostream& out) const {
  out << "| scene | engine | distances compared | error below 100 mm: median / p99 / largest [mm] | beyond: "
         "largest [%] | bounds violated | contacts compared | missed contacts | false contacts |\n"
         "|---|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for (std::size_t s = 0; s < scenes_.size(); ++s) {
    const Row* distances = find(s, Work::kDistance, Kind::kFcl);
    const Row* contacts = find(s, Work::kCollide, Kind::kFcl);
    for (const Kind kind : {Kind::kAbstand, Kind::kBullet}) {
      Errors e;
      if (const Row* row = find(s, Work::kDistance, kind); row && distances)
        forCommon(row->answers, distances->answers, [&](const Answer& a, double truth) { e.add(a, truth); });
      Touching t;
      if (const Row* row = find(s, Work::kCollide, kind); row && contacts)
        forCommon(row->answers, contacts->answers, [&](const Answer& a, double truth) { t.add(a, truth); });
      if (e.pairs + t.pairs == 0) continue;
      const auto near = [&](double part) { return digits(1e3 * lowerQuantile(e.near, part)); };
      out << "| " << scenes_[s]->what << " | " << kindName(kind) << " | " << e.pairs << " | "
          << (e.near.empty() ? "" : near(0.5) + " / " + near(0.99) + " / " + near(1.0)) << " | "
          << digits(100.0 * lowerQuantile(e.far, 1.0)) << " | "
          << (kind == Kind::kAbstand ? std::to_string(e.breaches) : "") << " | " << t.pairs << " | "
          << t.missed << " of " << t.touching << " | " << t.invented << " |\n";
    }
  }
}

}  // namespace abstand::bench
