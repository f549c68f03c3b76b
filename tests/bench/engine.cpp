#include "tests/bench/engine.hpp"

namespace abstand::bench {

std::string_view kindName(Kind kind) {
  switch (kind) {
    case Kind::kAbstand:
      return "Abstand";
    case Kind::kFcl:
      return "FCL";
    case Kind::kBullet:
      return "Bullet hulls";
  }
  return {};
}

std::unique_ptr<Engine> open(Kind kind, const BenchScene& scene) {
  switch (kind) {
    case Kind::kAbstand:
      return openAbstand(scene);
#ifdef ABSTAND_BENCH_FCL
    case Kind::kFcl:
      return openFcl(scene);
#endif
#ifdef ABSTAND_BENCH_BULLET
    case Kind::kBullet:
      return openBullet(scene);
#endif
    default:
      return nullptr;
  }
}

bool available(Kind kind) {
  switch (kind) {
#ifdef ABSTAND_BENCH_FCL
    case Kind::kFcl:
      return true;
#endif
#ifdef ABSTAND_BENCH_BULLET
    case Kind::kBullet:
      return true;
#endif
    default:
      return kind == Kind::kAbstand;
  }
}

}  // namespace abstand::bench
