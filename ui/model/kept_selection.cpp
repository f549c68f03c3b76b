#include "ui/model/kept_selection.hpp"

namespace abstand::ui {

void KeptSelection::keep(const Selection& selection, const view::SceneOutline& outline) {
  clear();
  const auto name = [&](int object) { return outline.objects[static_cast<std::size_t>(object)].name; };
  for (const int object : selection.objects()) objects_.push_back(name(object));
  if (selection.pair() < 0) return;
  const auto [a, b] = outline.pairs[static_cast<std::size_t>(selection.pair())];
  pair_ = {name(a), name(b)};
}

void KeptSelection::restore(Selection& selection, const view::SceneOutline& outline) const {
  const auto name = [&](int object) -> const std::string& {
    return outline.objects[static_cast<std::size_t>(object)].name;
  };
  if (!pair_.first.empty())
    for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
      const auto [a, b] = outline.pairs[p];
      if (name(a) == pair_.first && name(b) == pair_.second)
        return selection.setPair(static_cast<int>(p), a, b);
    }
  std::vector<int> objects;
  for (int i = 0; i < static_cast<int>(outline.objects.size()); ++i)
    if (std::find(objects_.begin(), objects_.end(), name(i)) != objects_.end()) objects.push_back(i);
  selection.setObjects(std::move(objects));
}

void KeptSelection::clear() {
  objects_.clear();
  pair_ = {};
}

}  // namespace abstand::ui
