#include "app/session/unchecked_pairs.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace abstand::session {
namespace {

using view::UncheckedReason;

/// For each two bodies the last rule that spoke of them.
class PairMarks {
 public:
  enum Mark : std::uint8_t { kOpen, kChecked, kAdjacent, kListed, kExcluded };

  explicit PairMarks(const view::SceneOutline& outline) : n_(outline.objects.size()), marks_(n_ * n_, kOpen) {
    for (std::size_t i = 0; i < n_; ++i) index_.emplace(outline.objects[i].name, i);
  }

  void set(std::size_t a, std::size_t b, Mark mark) { marks_[std::min(a, b) * n_ + std::max(a, b)] = mark; }
  /// By name; the place of the two in marks().
  std::optional<std::size_t> set(const std::string& a, const std::string& b, Mark mark) {
    const auto i = index_.find(a), k = index_.find(b);
    if (i == index_.end() || k == index_.end()) return std::nullopt;
    set(i->second, k->second, mark);
    return std::min(i->second, k->second) * n_ + std::max(i->second, k->second);
  }
  std::size_t place(std::size_t a, std::size_t b) const { return a * n_ + b; }
  Mark at(std::size_t place) const { return static_cast<Mark>(marks_[place]); }

 private:
  std::size_t n_;
  std::vector<std::uint8_t> marks_;
  std::unordered_map<std::string, std::size_t> index_;
};

UncheckedReason reasonOf(PairMarks::Mark mark, const view::SceneOutline::ObjectInfo& a,
                         const view::SceneOutline::ObjectInfo& b) {
  if (mark == PairMarks::kAdjacent) return UncheckedReason::kAdjacent;
  if (mark == PairMarks::kListed) return UncheckedReason::kListed;
  if (mark == PairMarks::kOpen && a.group == b.group)
    return a.human ? UncheckedReason::kOnePerson : UncheckedReason::kOneGroup;
  return UncheckedReason::kExcluded;
}

}  // namespace

void addUnchecked(const scene_file::PairsDescription& rules, const std::vector<std::pair<int, int>>& adjacent,
                  view::SceneOutline& outline) {
  PairMarks marks(outline);
  std::map<std::size_t, int> notes;
  if (rules.exclude_adjacent)
    for (const auto& [a, b] : adjacent)
      marks.set(static_cast<std::size_t>(a), static_cast<std::size_t>(b), PairMarks::kAdjacent);
  for (const scene_file::DroppedPair& dropped : rules.dropped) {
    const auto place = marks.set(dropped.a, dropped.b, PairMarks::kListed);
    if (!place || dropped.reason.empty()) continue;
    auto& known = outline.unchecked_notes;
    const auto note = std::find(known.begin(), known.end(), dropped.reason);
    notes[*place] = static_cast<int>(note - known.begin());
    if (note == known.end()) known.push_back(dropped.reason);
  }
  for (const auto& [a, b] : rules.exclude) marks.set(a, b, PairMarks::kExcluded);
  for (const auto& [a, b] : outline.pairs)
    marks.set(static_cast<std::size_t>(a), static_cast<std::size_t>(b), PairMarks::kChecked);

  const std::size_t n = outline.objects.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const std::size_t place = marks.place(a, b);
      if (marks.at(place) == PairMarks::kChecked) continue;
      view::UncheckedPair pair{static_cast<int>(a), static_cast<int>(b),
                               reasonOf(marks.at(place), outline.objects[a], outline.objects[b])};
      if (const auto note = notes.find(place); note != notes.end() && pair.reason == UncheckedReason::kListed)
        pair.note = note->second;
      outline.unchecked.push_back(pair);
    }
}

}  // namespace abstand::session
