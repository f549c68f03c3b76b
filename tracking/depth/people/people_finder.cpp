// Finds people in images of a fixed depth camera.
#include "tracking/depth/people/people_finder.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/depth/people/body_area.hpp"
#include "tracking/depth/people/cell_owners.hpp"

namespace abstand::tracking {
namespace {

// m: new persons are this far from others (kPeopleApart otherwise) if their heads are so low that they are
// likelier the back of a chair, or a part of the other.
constexpr double kSplitLow = 0.8;
constexpr float kLowestOfNew = 1.2f;  // m
// Cells of shoulders (Head::shoulders) of a new person, of one with less than kSmallBody (m^2) of surface,
// and of one whose head is that low. Most heads of people have more than 4, but fewer in some images with
// raised arms; all but one of 554 low ones have at least 19. Backs of chairs have 0 to 4, in some images 8;
// boxes on a post 3 to 8, and 0.05 to 0.12 m^2. People have 0.08 m^2 and more in the image in which they are
// found; 0.06 if the back of a chair hides all but the head and the shoulders.
constexpr int kMinShoulders = 3, kMinShouldersOfSmall = 10, kMinShouldersOfLow = 12;
constexpr double kFewestBody = 0.055, kSmallBody = 0.13;
// m^2: a new person this near (kSplitLow) to another has so much of a body of its own; a bucket that is
// lifted has less. Half of a trunk that faces the camera.
constexpr double kBodyBeside = 0.15;
// m, m^2: surface of a new person that is so near to the middle of a known one is the known one's.
constexpr double kConnectedWithin = 0.2, kConnectedArea = 0.02;
// Cells of shoulders with which the head may be a piece of its own, as seen from above. A hand above a thing
// has up to 14.
constexpr int kSureShoulders = 19;
constexpr double kLyingReach = 0.7;  // m, from the middle of a person who lies
constexpr std::size_t kMinPixels = 30;
constexpr int kEveryOfBackground = 3;  // rows and columns of background that are looked at

std::size_t pixelsOf(const DepthCamera& camera) {
  return static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
}

/// Whether a known object is nearer than `z` (m) at a pixel.
bool hides(const DepthImage& known, std::size_t pixel, float z) {
  return known.z[pixel] > 0.0f && known.z[pixel] < z;
}

}  // namespace

/// Axes of the plan view in the camera's frame, for the points of rays (x, y, 1).
class PeopleFinder::PlanAxes {
 public:
  /// The parts of a row of the image.
  struct Row {
    float up, ahead, right;
  };
  explicit PlanAxes(const FloorPlane& plane) : height_{static_cast<float>(plane.height)} {
    const Vector3d ahead = (Vector3d::UnitZ() - plane.up.z() * plane.up).normalized();
    up_ = plane.up.cast<float>();
    ahead_ = ahead.cast<float>();
    right_ = ahead.cross(plane.up).cast<float>();
  }
  Row row(float y) const {
    return {up_.y() * y + up_.z(), ahead_.y() * y + ahead_.z(), right_.y() * y + right_.z()};
  }
  /// Slope of a ray.
  float slopeAt(const Row& row, float x) const { return up_.x() * x + row.up; }
  /// m above the floor, of the point of a ray at depth `z` (m).
  float heightAt(const Row& row, float x, float z) const { return z * slopeAt(row, x) + height_; }
  int cellAt(const Row& row, float x, float z) const {
    return PlanView::cellAt(static_cast<double>(z * (right_.x() * x + row.right)),
                            static_cast<double>(z * (ahead_.x() * x + row.ahead)));
  }

 private:
  Eigen::Vector3f up_, ahead_, right_;
  float height_;  ///< m, of the camera
};

PeopleFinder::PeopleFinder(const DepthCamera& camera, const PeopleFinderOptions& options)
    : camera_(camera),
      options_(options),
      things_(camera),
      pieces_(camera),
      is_object_(pixelsOf(camera), 0),
      background_(pixelsOf(camera), options.learn_after),
      followed_(camera, options.keep, options.without_head) {
  floor_given_ = !camera.X_WC.matrix().isIdentity(0.0);
  if (floor_given_) people_.floor = plane_ = floorOfWorld(camera.X_WC);
  cell_of_.assign(pixelsOf(camera), -1);
  objects_.reserve(pixelsOf(camera));
  columns_.assign(static_cast<std::size_t>(camera.width), 0);
  people_.label.assign(pixelsOf(camera), 0);
  for (int u = 0; u < camera.width; ++u) x_.push_back(static_cast<float>((u - camera.cx) / camera.fx));
  for (int v = 0; v < camera.height; ++v) y_.push_back(static_cast<float>((v - camera.cy) / camera.fy));
  heads_.reserve(kMaxPeople);
  people_.persons.reserve(kMaxPeople);
}

void PeopleFinder::expect(SeenBefore seen) {
  followed_.expect(std::move(seen.arrivals));
  things_.expect(seen.things);
}

void PeopleFinder::findFloor(double t, const DepthImage& image) {
  if (floor_given_ || people_.floor || t < next_floor_) return;
  people_.floor = floor_finder_.find(image, camera_, options_.seed);
  if (people_.floor) plane_ = *people_.floor;
  next_floor_ = t + 0.5;
}

/// Without a floor: a level plane through the lowest one percent of the points.
void PeopleFinder::estimateFloorFromScene(const DepthImage& image) {
  constexpr int kBins = 1000;
  constexpr double kLowest = -5.0, kBin = 0.01;  // m
  std::array<std::uint32_t, kBins> count{};
  std::uint32_t total = 0;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u) {
      const float z = image.at(u, v);
      if (!(z > 0.0f && z < static_cast<float>(options_.farthest))) continue;
      const double up = static_cast<double>(-z * y_[static_cast<std::size_t>(v)]);
      const double bin = (up - kLowest) / kBin;
      if (bin < 0.0 || bin >= kBins) continue;
      ++count[static_cast<std::size_t>(bin)];
      ++total;
    }
  std::uint32_t below = 0;
  std::size_t bin = 0;
  while (bin + 1 < kBins && (below += count[bin]) * 100 < total) ++bin;
  plane_ = {-Vector3d::UnitY(), -(kLowest + kBin * static_cast<double>(bin))};
}

void PeopleFinder::projectToPlan(const DepthImage& image, const DepthImage* known) {
  const PlanAxes axes(plane_);
  project(image, known, axes);
  if (furniture_.find(plan_)) removeFurniture(image, known, axes);
}

/// Columns of row `v` whose depths are within the gate and not of the background; with `notes_background`
/// also some that are. Computed without branches, as which pixels are follows no pattern.
std::span<const int> PeopleFinder::columnsToProject(const DepthImage& image, int v, bool notes_background) {
  const auto nearest = static_cast<float>(options_.nearest), farthest = static_cast<float>(options_.farthest);
  std::size_t i = static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width), count = 0;
  for (int u = 0; u < image.width; ++u, ++i) {
    const float z = image.z[i];
    const bool is_noted = notes_background & (u % kEveryOfBackground == 0);
    columns_[count] = u;
    count += static_cast<std::size_t>((z > nearest) & (z < farthest) & (!background_.has(i, z) | is_noted));
  }
  return std::span(columns_).first(count);
}

void PeopleFinder::project(const DepthImage& image, const DepthImage* known, const PlanAxes& axes) {
  plan_.clear();
  objects_.clear();
  std::fill(cell_of_.begin(), cell_of_.end(), -1);
  const bool has_floor = people_.floor.has_value();
  for (int v = 0; v < image.height; ++v) {
    const PlanAxes::Row row = axes.row(y_[static_cast<std::size_t>(v)]);
    for (const int u : columnsToProject(image, v, furniture_.any() && v % kEveryOfBackground == 0)) {
      const std::size_t i =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(u);
      const float z = image.z[i], x = x_[static_cast<std::size_t>(u)];
      if (known && known->z[i] > 0.0f && z > known->z[i] - 0.06f) continue;
      const bool is_background = background_.has(i, z);
      if (!is_background && things_.has(i, z)) continue;
      const float h = axes.heightAt(row, x, z);
      // A variation along the ray is scaled by its slope in height.
      const float sole = has_floor ? 0.02f + depthNoise(z) * std::abs(axes.slopeAt(row, x)) : 0.0f;
      if (h < sole || h >= static_cast<float>(PlanView::kHighest)) continue;
      const int cell = axes.cellAt(row, x, z);
      if (cell < 0) continue;
      if (is_background) {
        furniture_.noteBackground(cell, h);
        continue;
      }
      cell_of_[i] = cell;
      objects_.push_back(static_cast<std::uint32_t>(i));
      addToPlan(static_cast<std::uint32_t>(i), image, known, h);
    }
  }
  plan_.join();
}

/// Adds a pixel whose surface is `h` (m) above the floor to its cell.
void PeopleFinder::addToPlan(std::uint32_t i, const DepthImage& image, const DepthImage* known, float h) {
  constexpr int kBorderRows = 2;     // of the image, at its upper border
  constexpr int kBorderColumns = 4;  // at its sides, where a Kinect's noise leaves pixels out
  const auto width = static_cast<std::uint32_t>(image.width);
  const auto u = static_cast<int>(i % width), v = static_cast<int>(i / width);
  const float z = image.z[i];
  const int cell = cell_of_[i];
  const double area = static_cast<double>(z * z) * (1.0 / (camera_.fx * camera_.fy));
  plan_.add(cell, static_cast<double>(h), area);
  if (background_.hasSettled(i, z)) plan_.addSettled(cell, area, static_cast<double>(background_.drift(i)));
  if (known && (hides(*known, i - (u > 0), z) || hides(*known, i + (u + 1 < image.width), z)))
    plan_.markBesideKnown(cell);
  if (v < kBorderRows) plan_.markCut(cell);
  if (u < kBorderColumns || u >= image.width - kBorderColumns) plan_.markSide(cell);
}

/// The plan view again, without what is furniture.
void PeopleFinder::removeFurniture(const DepthImage& image, const DepthImage* known, const PlanAxes& axes) {
  plan_.clear();
  const auto width = static_cast<std::uint32_t>(image.width);
  std::size_t kept = 0;
  for (const std::uint32_t i : objects_) {
    const float h = axes.heightAt(axes.row(y_[i / width]), x_[i % width], image.z[i]);
    if (h < furniture_.topOf(cell_of_[i])) {
      cell_of_[i] = -1;
      continue;
    }
    objects_[kept++] = i;
    addToPlan(i, image, known, h);
  }
  objects_.resize(kept);
  plan_.join();
}

/// Heads that no known person has are those of new people.
void PeopleFinder::addHeads(double t, const DepthImage& image) {
  // The highest first: a bar in the hand of a person who sits is lower than the head.
  std::sort(heads_.begin(), heads_.end(), [&](const Head& a, const Head& b) {
    const float top_a = plan_.cell(a.cell).top, top_b = plan_.cell(b.cell).top;
    return top_a != top_b ? top_a > top_b : a.cell < b.cell;
  });
  for (const Head& head : heads_) {
    const Place place = middleOfBody(plan_, head.place);
    const bool is_low = plan_.cell(head.cell).top < kLowestOfNew;
    const int fewest = is_low                   ? kMinShouldersOfLow
                       : head.body < kSmallBody ? kMinShouldersOfSmall
                                                : kMinShoulders;
    bool is_new = !followed_.full() && head.shoulders >= fewest && head.body >= kFewestBody;
    const double apart = is_low ? kSplitLow : kPeopleApart;
    bool is_near = false;
    for (const FollowedPerson& person : followed_.all()) {
      if (!person.here || (person.born == t && !is_low)) continue;
      const double distance = (person.place - place).norm();
      is_new = is_new && distance >= apart && (distance >= kSplitLow || head.body >= kBodyBeside);
      is_near = is_near || distance < kSplitLow;
    }
    if (is_new && is_near) is_new = hasOwnBody(head, image);
    if (is_new) followed_.add(t, plan_, place);
  }
}

/// Whether the surface at a head is enough of a body, and no part of a known person, as a hand above a chair.
bool PeopleFinder::hasOwnBody(const Head& head, const DepthImage& image) {
  std::size_t seed = cell_of_.size();
  for (std::size_t i = 0; i < cell_of_.size(); ++i) {
    is_object_[i] = cell_of_[i] >= 0;
    if (cell_of_[i] == head.cell && seed == cell_of_.size()) seed = i;
  }
  if (seed == cell_of_.size()) return false;
  const SurfacePiece piece = pieces_.pieceAt(seed, image, is_object_, 1);
  const double own = pieces_.areaWithin(piece, image, cell_of_, head.place, kBodyRadius);
  double others = 0.0;
  for (const FollowedPerson& person : followed_.all())
    if (person.here) others += pieces_.areaWithin(piece, image, cell_of_, person.place, kConnectedWithin);
  return others < kConnectedArea && (own >= kBodyBeside || head.shoulders >= kSureShoulders);
}

/// People who lie have no head of that kind: those who are followed stay, others are new.
void PeopleFinder::followLying(double t) {
  lying_.find(plan_);
  for (const Place& place : lying_.places()) followed_.keepOrAdd(t, plan_, place, kLyingReach);
}

/// Likewise people whose heads are above the image.
void PeopleFinder::followHeadless(double t) {
  headless_.find(plan_);
  for (const Place& place : headless_.places()) followed_.keepOrAdd(t, plan_, place, kSplitLow);
}

/// Likewise people who sit on the floor, by their heads.
void PeopleFinder::followOnFloor(double t) {
  findHeads(plan_, kLowHeads, kMaxPeople, heads_);
  for (const Head& head : heads_)
    if (head.shoulders >= kSureShoulders && head.body >= kBodyBeside)
      followed_.keepOrAdd(t, plan_, middleOfBody(plan_, head.place), kSplitLow);
}

/// Likewise people who squat or bend with the head lower than the back.
void PeopleFinder::followCrouched(double t) {
  crouched_.find(t, plan_, [this](const Place& place) { return followed_.mayDisturb(place); });
  for (const Place& place : crouched_.places()) followed_.keepOrAddCrouched(t, plan_, place, kSplitLow);
}

void PeopleFinder::label() {
  std::fill(people_.label.begin(), people_.label.end(), std::uint8_t{0});
  for (const std::uint32_t i : objects_)
    people_.label[i] = static_cast<std::uint8_t>(plan_.cell(cell_of_[i]).owner + 1);
}

void PeopleFinder::dropUncovered(const DepthImage& image) {
  const std::vector<FollowedPerson>& people = followed_.all();
  for (std::size_t k = 0; k < people.size(); ++k) {
    const auto label = static_cast<std::uint8_t>(k + 1);
    if (!people[k].here || !people[k].suspect || !background_.continues(people_.label, label, image))
      continue;
    for (std::size_t i = 0; i < image.z.size(); ++i) {
      if (people_.label[i] != label) continue;
      people_.label[i] = 0;
      background_.set(i, image.z[i]);
    }
    followed_.withdraw(k);
  }
}

void PeopleFinder::describe(double t, const DepthImage& image) {
  const std::vector<FollowedPerson>& people = followed_.all();
  const float dt = std::isfinite(last_t_) ? static_cast<float>(t - last_t_) : 0.0f;
  struct Sum {
    Vector3d p{Vector3d::Zero()};
    FoundPerson person;
  };
  std::array<Sum, kMaxPeople> sums;
  for (std::size_t p = 0; p < people.size(); ++p) {
    sums[p].person.left = image.width;
    sums[p].person.above = image.height;
    sums[p].person.top = 0.0;
  }
  std::size_t i = 0;
  for (int v = 0; v < image.height; ++v)
    for (int u = 0; u < image.width; ++u, ++i) {
      const float z = image.z[i];
      if (people_.label[i] == 0) {
        if (z > 0.0f) background_.learn(i, z, dt);
        continue;
      }
      background_.cover(i);
      Sum& sum = sums[people_.label[i] - std::size_t{1}];
      const Vector3d p_C(static_cast<double>(z * x_[static_cast<std::size_t>(u)]),
                         static_cast<double>(z * y_[static_cast<std::size_t>(v)]), static_cast<double>(z));
      sum.p += p_C;
      FoundPerson& person = sum.person;
      ++person.pixels;
      person.left = std::min(person.left, u);
      person.right = std::max(person.right, u);
      person.above = std::min(person.above, v);
      person.below = std::max(person.below, v);
      person.top = std::max(person.top, plane_.above(p_C));
    }
  std::array<std::uint8_t, kMaxPeople + 1> number{};
  bool is_same = true;
  for (std::size_t p = 0; p < people.size(); ++p) {
    FoundPerson& person = sums[p].person;
    if (person.pixels >= kMinPixels) {
      person.id = people[p].id;
      person.foreseen = t < people[p].arrives;
      person.centroid = sums[p].p / static_cast<double>(person.pixels);
      people_.persons.push_back(person);
      number[p + 1] = static_cast<std::uint8_t>(people_.persons.size());
    }
    is_same = is_same && number[p + 1] == p + 1;
  }
  if (!is_same)
    for (std::uint8_t& l : people_.label) l = number[l];
}

const PeopleImage& PeopleFinder::find(double t, const DepthImage& image, const DepthImage* known) {
  ABSTAND_CHECK(image.width == camera_.width && image.height == camera_.height);
  ABSTAND_CHECK(!known || known->z.size() == image.z.size());
  people_.persons.clear();
  findFloor(t, image);
  if (!people_.floor) estimateFloorFromScene(image);
  things_.look(image);
  projectToPlan(image, known);
  findHeads(plan_, kHighHeads, kMaxPeople, heads_);
  followed_.follow(t, plan_, heads_);
  addHeads(t, image);
  followLying(t);
  followHeadless(t);
  followOnFloor(t);
  followCrouched(t);
  followed_.addExpected(t, plan_);
  const std::vector<FollowedPerson>& people = followed_.all();
  std::array<std::optional<Place>, kMaxPeople> places;
  for (std::size_t p = 0; p < people.size(); ++p)
    if (people[p].here) places[p] = people[p].place;
  assignCells(std::span(places).first(people.size()), plan_);
  label();
  dropUncovered(image);
  for (std::size_t p = 0; p < people.size(); ++p)
    if (people[p].here)
      things_.find(image, plane_, cell_of_, people[p].place, static_cast<std::uint8_t>(p + 1), people_.label);
  describe(t, image);
  last_t_ = t;
  return people_;
}

void PeopleFinder::mask(int id, std::vector<std::uint8_t>& is_person) const {
  std::uint8_t number = 0;
  for (std::size_t p = 0; p < people_.persons.size(); ++p)
    if (people_.persons[p].id == id) number = static_cast<std::uint8_t>(p + 1);
  is_person.resize(people_.label.size());
  for (std::size_t i = 0; i < is_person.size(); ++i) is_person[i] = number != 0 && people_.label[i] == number;
}

}  // namespace abstand::tracking
