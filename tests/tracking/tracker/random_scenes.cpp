// Draws.
#include "tests/tracking/tracker/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/tracking/tracker/beside_things.hpp"
#include "tests/tracking/tracker/postures.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::testing {
namespace {

using enum humanmodel::Joint;

constexpr double kBeforeWall = 1.2;  // m, at least, of the hips
constexpr double kSeatAhead = 0.44;  // m, from the middle of the seat to the feet of who sits

class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t clip) : seed_(seed * 1000003 + clip) {}
  double unit() { return randomUnit(seed_, next_++); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double share) { return unit() < share; }
  template <typename List>
  const auto& oneOf(const List& list) {
    return list[std::min(list.size() - 1,
                         static_cast<std::size_t>(unit() * static_cast<double>(list.size())))];
  }

 private:
  std::uint64_t seed_, next_{0};
};

struct View {
  double distance, height, azimuth;  // m, m, degrees from the front to the left
  Vector3d aim;                      // m, from the middle of the place on the floor
  std::uint64_t body_seed;
  double clothing;  // m
};

View drawView(Draws& draws) {
  View view{};
  view.distance = draws.between(1.0, 5.0);
  view.height = draws.between(0.5, 2.8);
  view.azimuth = std::floor(draws.between(0.0, 360.0));
  view.aim = {draws.between(-0.2, 0.2), draws.between(-0.2, 0.2), draws.between(0.6, 1.1)};
  view.body_seed = 1 + static_cast<std::uint64_t>(1000.0 * draws.unit());
  view.clothing = draws.chance(0.3) ? draws.between(0.0, 0.02) : 0.0;
  return view;
}

/// What camera number `camera` sees: `view`, that of the first one, or likewise from another side.
View viewFrom(const View& view, std::size_t camera) {
  if (camera == 0) return view;
  constexpr double kSmallest = 50.0, kLargest = 180.0;  // degrees between two cameras
  Draws draws(view.body_seed, 4000 + camera);
  View other = drawView(draws);
  other.azimuth = view.azimuth + draws.between(kSmallest, kLargest) * static_cast<double>(camera);
  other.body_seed = view.body_seed;
  other.clothing = view.clothing;
  return other;
}

std::string textOf(const View& view) {
  char text[100];
  std::snprintf(text, sizeof text, "at %.1f m, %.1f m high, from %.0f", view.distance, view.height,
                view.azimuth);
  return text;
}

Vector3d hipsOf(const humanmodel::SkeletonFrame& frame) { return 0.5 * (frame[kHipLeft] + frame[kHipRight]); }

/// The camera looks at the mean place of a person who stays before the wall.
ClipPlan planOf(const View& view, const std::vector<humanmodel::SkeletonFrame>& frames) {
  ClipPlan plan;
  Vector3d place = Vector3d::Zero();
  for (const humanmodel::SkeletonFrame& frame : frames) place += hipsOf(frame);
  place /= static_cast<double>(frames.size());
  place.z() = 0.0;
  const double angle = unit::deg(view.azimuth);
  plan.eye = place + Vector3d(view.distance * std::cos(angle), view.distance * std::sin(angle), view.height);
  plan.look = place + view.aim;
  plan.clothing = view.clothing;
  plan.body_seed = view.body_seed;
  plan.room = true;
  const Vector3d ahead = (plan.look - plan.eye).cwiseProduct(Vector3d(1.0, 1.0, 0.0)).normalized();
  for (const humanmodel::SkeletonFrame& frame : frames)
    plan.wall = std::max(plan.wall, ahead.dot(hipsOf(frame) - plan.look) + kBeforeWall);
  return plan;
}

std::vector<std::filesystem::path> captures() {
  return {debianBvh("Boxing_Toes.bvh"),
          debianBvh("01_01.bvh"),
          debianBvh("01_03.bvh"),
          sharedData("mocap/bvh/rokoko_jesse_dance.bvh"),
          sharedData("mocap/bvh/fair1_wave_hello.bvh"),
          sharedData("mocap/bvh/cmu_jumping_jacks_3dsmax_names.bvh"),
          sharedData("mocap/bvh/mocapbank_test.bvh"),
          sharedData("mocap/bvh/cmu_12_01_walk_motionbuilder.bvh"),
          sharedData("mocap/asfamc/11_01.amc"),
          sharedData("kinect/uiprmd_kinect_v2/m05_s01_e01_positions.txt"),
          sharedData("kinect/uiprmd_kinect_v2/m07_s01_e01_positions.txt")};
}

/// Nothing to make if the capture is missing.
RandomScene drawCapture(const std::string& name, Draws draws) {
  constexpr double kLong = 4.0;  // s
  const std::filesystem::path file = draws.oneOf(captures());
  if (!exists(file)) return {};
  const double share = draws.unit();
  const View view = drawView(draws);
  char begin[20];
  std::snprintf(begin, sizeof begin, " %.2f", share);
  return {name, file.stem().string() + begin + ", " + textOf(view), [=](std::size_t camera) {
            const tracking::Recording recording = tracking::openRecording(file);
            const double first = recording.frames.front().t, last = recording.frames.back().t;
            ClipPlan plan;
            plan.recording = file;
            plan.start = first + share * std::max(0.0, last - first - kLong);
            plan.end = plan.start + kLong;
            std::vector<humanmodel::SkeletonFrame> frames = simulate(plan).truth;
            const ClipPlan seen = planOf(viewFrom(view, camera), frames);
            return simulate(seen, std::move(frames), {});
          }};
}

Posture ahead(Posture p, double by) {
  p.hips.x() += by;
  p.reach += by;
  p.foot += by;
  return p;
}

/// Both hands somewhere around the trunk; `lowest`: m.
void drawHands(Draws& draws, double lowest, Posture& left, Posture& right) {
  for (Posture* p : {&left, &right}) {
    p->reach = p->hips.x() + draws.between(-0.1, 0.5);
    p->aside = draws.between(0.1, 0.6);
    p->low = draws.between(lowest, 1.9);
    // Not in the trunk or the head.
    if (p->reach < p->hips.x() + 0.2) p->aside = std::max(p->aside, 0.28);
    p->elbows = {draws.between(-0.8, 0.2), draws.between(0.4, 1.0), draws.between(-0.8, 0.1)};
  }
}

struct Kind {
  const char* name;
  bool bench, chair;
};

/// Two lists of postures that differ in the arms: one for either side of the person.
struct BothSides {
  std::vector<Posture> left, right;
  void add(const Posture& l, const Posture& r, double after, double held) {
    const double t = left.empty() ? 0.0 : left.back().t + after;
    for (const double at : {t, t + held}) {
      left.push_back(l);
      right.push_back(r);
      left.back().t = right.back().t = at;
    }
  }
};

void drawStep(Draws& draws, const Kind& kind, bool first, Posture& left, Posture& right) {
  const double at = draws.unit();
  const bool stands = kind.bench || at < (first ? 0.6 : 0.4);
  Posture p = standing(0.0);
  if (stands) {
    p.loins = draws.between(0.0, 0.35);
    p.back = p.loins + draws.between(0.0, 0.3);
    p.head = p.back + draws.between(-0.3, 0.4);
    p.hips.x() -= 0.2 * p.loins;
  } else if (kind.chair) {
    p = ahead(seated(0.0), -kSeatAhead);
    p.back = draws.between(-0.1, 0.4);
  } else if (at < 0.7) {
    p = kneeling(0.0);
    p.back = draws.between(0.0, 0.4);
  } else if (at < 0.85) {
    p = squatting(0.0);
  } else {
    p = bent(0.0);
  }
  left = right = p;
  // Hands of people who bend are at the floor.
  if (stands || at < 0.85 || kind.chair)
    drawHands(draws, kind.bench ? 1.0 : stands ? 0.75 : 0.55, left, right);
}

RandomScene drawPosed(const std::string& name, Draws draws) {
  const double of_furniture = draws.unit();
  const Kind kind = of_furniture < 0.15   ? Kind{"at a bench", true, false}
                    : of_furniture < 0.35 ? Kind{"chair", false, true}
                    : of_furniture < 0.55 ? Kind{"thing", false, false}
                                          : Kind{"posed", false, false};
  const double stature = draws.chance(0.5) ? draws.between(1.50, 1.75) : draws.between(1.65, 1.95);
  BothSides sides;
  const int steps = 3 + static_cast<int>(3.0 * draws.unit());
  for (int i = 0; i < steps; ++i) {
    Posture left, right;
    drawStep(draws, kind, i == 0, left, right);
    const double after = draws.between(0.8, 1.5);
    sides.add(left, right, after, draws.between(0.2, 0.9));
  }
  std::vector<FurnitureBox> furniture;
  if (kind.bench) furniture = {{{0.45, -0.8, 0.0}, {0.95, 0.8, 0.9}}};
  if (kind.chair) furniture = boxesOf(Thing::kChair, {-kSeatAhead, 0.0});
  if (std::string(kind.name) == "thing") {
    constexpr std::array kThings{Thing::kChair,    Thing::kCrate, Thing::kCart,
                                 Thing::kCupboard, Thing::kTable, Thing::kStand};
    const double angle = draws.between(0.0, 2.0 * kPi), away = draws.between(1.0, 1.6);
    furniture = boxesOf(draws.oneOf(kThings), away * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  const View view = drawView(draws);
  char size[30];
  std::snprintf(size, sizeof size, " %.2f m, ", stature);
  return {name, kind.name + (size + textOf(view)), [=](std::size_t camera) {
            const double scale = stature / kPosedStature;
            std::vector<humanmodel::SkeletonFrame> frames = posedFrames(sides.left);
            const std::vector<humanmodel::SkeletonFrame> right = posedFrames(sides.right);
            for (std::size_t i = 0; i < frames.size(); ++i) {
              for (const humanmodel::Joint j : {kElbowRight, kWristRight, kHandRight})
                frames[i].set(j, right[i][j]);
              for (Vector3d& p : frames[i].p) p *= scale;
            }
            std::vector<FurnitureBox> boxes = furniture;
            for (FurnitureBox& box : boxes) {
              box.low *= scale;
              box.high *= scale;
            }
            const ClipPlan plan = planOf(viewFrom(view, camera), frames);
            return simulate(plan, std::move(frames), std::move(boxes));
          }};
}

}  // namespace

std::vector<RandomScene> randomScenes(std::uint64_t seed, int count) {
  std::vector<RandomScene> scenes;
  for (int i = 0; i < count; ++i) {
    const std::string name = "random_" + std::to_string(seed) + "_" + std::to_string(i);
    Draws draws(seed, static_cast<std::uint64_t>(i));
    RandomScene scene = draws.chance(0.5) ? drawCapture(name, draws) : drawPosed(name, draws);
    if (scene.make) scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace abstand::testing
