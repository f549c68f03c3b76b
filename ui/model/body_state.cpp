#include "ui/model/body_state.hpp"

#include <algorithm>
#include <cmath>

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

/// Of a body: what is not checked hides nothing that is near.
int rankOf(PairLevel level) {
  switch (level) {
    case PairLevel::kUnknown:
      return 0;
    case PairLevel::kApart:
      return 1;
    case PairLevel::kPaused:
      return 2;
    case PairLevel::kNear:
      return 3;
    case PairLevel::kLost:
      return 4;
    case PairLevel::kInside:
      return 5;
    case PairLevel::kTouching:
      break;
  }
  return 6;
}

QString wordsOf(const BodyState& state, double least) {
  const bool touches = state.level == PairLevel::kTouching;
  const double force = (touches ? state.contact_force : state.virtual_force).norm();
  if (!isBroken(state.level)) return {};
  if (!(force > 0.0) || force < least) return touches ? tr("touching") : tr("inside margin");
  return touches ? tr("touching, %1 N").arg(fixed(force, 1))
                 : tr("inside margin, virtual %1 N").arg(fixed(force, 1));
}

}  // namespace

QString BodyState::words(double least) const { return wordsOf(*this, least); }

void findBodyStates(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot,
                    std::vector<BodyState>& states) {
  states.assign(snapshot.objects.size(), {});
  for (std::size_t p = 0; p < std::min(outline.pairs.size(), snapshot.pairs.size()); ++p) {
    const view::PairSnapshot& pair = snapshot.pairs[p];
    const auto [a, b] = outline.pairs[p];
    const PairLevel level = pairLevel(snapshot, pair, outline.pairs[p]);
    const ForceKind kind = pair.paused ? ForceKind::kNone : forceKind(pair.result);
    const auto take = [&](int object, const Vector3d& force) {
      BodyState& state = states[static_cast<std::size_t>(object)];
      if (kind != ForceKind::kNone)
        (kind == ForceKind::kContact ? state.contact_force : state.virtual_force) += force;
      const int rank = rankOf(level), before = rankOf(state.level);
      const bool nearer =
          state.pair < 0 ||
          pair.result.distance < snapshot.pairs[static_cast<std::size_t>(state.pair)].result.distance;
      if (rank < before || (rank == before && !nearer)) return;
      state.level = level;
      state.pair = static_cast<int>(p);
    };
    take(a, pair.result.force_a);
    take(b, -pair.result.force_a);
  }
}

}  // namespace abstand::ui
