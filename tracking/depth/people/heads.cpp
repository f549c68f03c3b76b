// Peaks of a head's breadth, and the bodies below them.
#include "tracking/depth/people/heads.hpp"

#include "tracking/depth/people/body_area.hpp"
#include "tracking/depth/people/shared_trunk.hpp"

namespace abstand::tracking {
namespace {

// Dimensions of a head above its body, m and m^2. Heads of adults are 0.14 to 0.16 m broad and 0.18 to 0.21 m
// long, and shoulders begin a third of a metre below the vertex (ANSUR II).
constexpr double kHeadRadius = 0.16;  // points as high as the head are within this distance ...
constexpr double kBesideHead = 0.32;  // ... and hardly any between that and this one
constexpr double kHeadDrop = 0.22;    // as high: at most this much lower
constexpr double kMaxBeside = 0.5;    // cells beside a head, relative to those of the head
// Cells of shoulders, or of arms at their height, and by how much (m) they are lower.
constexpr double kShouldersFrom = 0.12, kShouldersTo = 0.30, kHighShoulder = 0.20, kLowShoulder = 0.45;
constexpr int kMinHeadCells = 3;
constexpr double kBodyFrom = 0.3, kBodyTo = 0.8;  // share of the head's height

bool isHead(const PlanView& plan, int cell) {
  const float top = plan.cell(cell).top;
  int head = 0, beside = 0;
  bool is_highest = true;
  plan.around(PlanView::placeOf(cell), kBesideHead, [&](int i, double distance) {
    const float other = plan.cell(i).top;
    if (other < top - static_cast<float>(kHeadDrop)) return;
    if (distance > kHeadRadius) {
      ++beside;
      return;
    }
    ++head;
    if (other > top || (other == top && i < cell)) is_highest = false;
  });
  return is_highest && head >= kMinHeadCells && beside <= kMaxBeside * head;
}

/// Whether another, larger one is a peak of the same person.
bool hasLargerPeak(const PlanView& plan, const std::vector<Head>& heads, const Head& head) {
  return std::any_of(heads.begin(), heads.end(), [&](const Head& other) {
    const float top = std::min(plan.cell(head.cell).top, plan.cell(other.cell).top);
    return (other.body > head.body || (other.body == head.body && other.cell < head.cell)) &&
           shareTrunk(plan, head.place, other.place, static_cast<double>(top));
  });
}

/// A raised fist has no trunk of its own below. The head with the smallest body is dropped first; its surface
/// goes to the others.
void dropHeadsWithoutBody(const PlanView& plan, std::vector<Head>& heads) {
  while (!heads.empty()) {
    for (Head& head : heads) {
      head.body = 0.0;
      const auto height = static_cast<double>(plan.cell(head.cell).top);
      const auto first = static_cast<std::size_t>(kBodyFrom * height / PlanView::kSlab);
      const auto last = static_cast<std::size_t>(kBodyTo * height / PlanView::kSlab);
      plan.around(head.place, kBodyRadius, [&](int i, double distance) {
        for (const Head& other : heads)
          if ((other.place - PlanView::placeOf(i)).norm() < distance) return;
        for (std::size_t slab = first; slab <= last; ++slab)
          head.body += static_cast<double>(plan.cell(i).area[slab]);
      });
    }
    const auto smallest = std::min_element(heads.begin(), heads.end(),
                                           [](const Head& a, const Head& b) { return a.body < b.body; });
    const auto dropped = smallest->body < kMinBody
                             ? smallest
                             : std::find_if(heads.begin(), heads.end(), [&](const Head& head) {
                                 return hasLargerPeak(plan, heads, head);
                               });
    if (dropped == heads.end()) return;
    heads.erase(dropped);
  }
}

int shouldersOf(const PlanView& plan, const Head& head) {
  const float top = plan.cell(head.cell).top;
  int cells = 0;
  plan.around(head.place, kShouldersTo, [&](int i, double distance) {
    const auto drop = static_cast<double>(top - plan.cell(i).top);
    cells += distance > kShouldersFrom && drop > kHighShoulder && drop < kLowShoulder;
  });
  return cells;
}

}  // namespace

void findHeads(const PlanView& plan, const HeadHeights& heights, std::size_t max, std::vector<Head>& heads) {
  heads.clear();
  for (const int i : plan.used()) {
    const float top = plan.cell(i).top;
    if (top < static_cast<float>(heights.lowest) || top > static_cast<float>(heights.highest) ||
        !plan.occupied(i) || !isHead(plan, i))
      continue;
    if (heads.size() == max) break;
    heads.push_back({i, PlanView::placeOf(i)});
  }
  // Keeps the higher of two heads that are too near.
  for (std::size_t a = 0; a < heads.size(); ++a)
    for (std::size_t b = heads.size(); b-- > a + 1;)
      if ((heads[a].place - heads[b].place).norm() < kHeadsApart) {
        if (plan.cell(heads[b].cell).top > plan.cell(heads[a].cell).top) heads[a] = heads[b];
        heads.erase(heads.begin() + static_cast<std::ptrdiff_t>(b));
      }
  dropHeadsWithoutBody(plan, heads);
  for (Head& head : heads) head.shoulders = shouldersOf(plan, head);
}

}  // namespace abstand::tracking
