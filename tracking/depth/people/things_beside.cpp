// Shape of pieces, and memory of each pixel.
#include "tracking/depth/people/things_beside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracking/depth/people/body_area.hpp"
#include "tracking/depth/people/learned_background.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kFewestPixels = 30;  // of a piece that counts
constexpr std::uint8_t kForgetAfter = 5;   // images
constexpr float kNewest = 0.1f;            // weight of the newest depth
// m, highest point: lower people may lie; higher ones stand. Hands are raised higher by people who sit.
constexpr double kSeatedTop = 1.0, kStandingTop = 1.5;
constexpr double kOnFloor = 0.2;      // m, lowest point of what stands on the floor
constexpr double kSeatHeight = 0.45;  // m; the legs of a chair may be too thin to be seen
constexpr double kHighestLeg = 1.15;  // m; the hip of somebody 1.92 m tall is seen up to 1.08 m
// Shares of an outline: noise; hidden, of a thing; unknown, of a thing and of its end; above a thing.
constexpr double kNoise = 0.05, kHidden = 0.1, kUnknown = 0.3, kUnknownEnd = 0.4, kFreeAbove = 0.6,
                 kHiddenAbove = 0.3;
constexpr int kRounds = 2;  // a thing may hide parts of others

/// m; half of what background is allowed to vary, so that a hand on a thing is not taken for it.
float thingNoise(float z) { return 0.5f * depthNoise(z); }

}  // namespace

ThingsBeside::ThingsBeside(const DepthCamera& camera) : camera_(camera), pieces_(camera) {
  things_.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  is_thing_.resize(things_.size());
}

void ThingsBeside::expect(std::span<const ThingPixel> things) {
  if (things.size() != things_.size()) return;
  std::copy(things.begin(), things.end(), things_.begin());
  noted_ = true;
}

void ThingsBeside::look(const DepthImage& image) {
  if (!noted_) return;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    ThingPixel& thing = things_[i];
    const float z = image.z[i];
    if (thing.images == 0 || z == 0.0f) continue;
    thing.past = z > thing.z + thingNoise(z) ? static_cast<std::uint8_t>(thing.past + 1) : std::uint8_t{0};
    if (thing.past >= kForgetAfter) thing = {};
  }
}

bool ThingsBeside::isAt(std::size_t pixel, float z) const {
  const ThingPixel& thing = things_[pixel];
  return thing.images >= kImages && std::abs(thing.z - z) < thingNoise(z);
}

bool ThingsBeside::has(std::size_t pixel, float z) const {
  if (!noted_) return false;
  // Edges flicker: beside a thing is more of it.
  const auto width = static_cast<std::size_t>(camera_.width);
  if (isAt(pixel, z)) return true;
  if (pixel < width || pixel + width >= things_.size()) return false;
  return isAt(pixel - 1, z) || isAt(pixel + 1, z) || isAt(pixel - width, z) || isAt(pixel + width, z);
}

void ThingsBeside::note(std::size_t pixel, float z) {
  noted_ = true;
  ThingPixel& thing = things_[pixel];
  if (thing.images == 0 || std::abs(thing.z - z) >= thingNoise(z)) {
    if (thing.images < kImages) thing = {z, 1, 0};
    return;
  }
  thing.z += kNewest * (z - thing.z);
  if (thing.images < kImages) ++thing.images;
}

ThingsBeside::Extent ThingsBeside::extentOf(const SurfacePiece& piece, const DepthImage& image,
                                            const FloorPlane& floor) const {
  Extent extent{kInfinity, -kInfinity};
  for (const std::uint32_t i : pieces_.pixels(piece)) {
    const double u = static_cast<double>(i % static_cast<std::uint32_t>(image.width));
    const double v = static_cast<double>(i / static_cast<std::uint32_t>(image.width));
    const Vector3d ray((u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy, 1.0);
    const double height = floor.above(static_cast<double>(image.z[i]) * ray);
    extent.low = std::min(extent.low, height);
    extent.high = std::max(extent.high, height);
  }
  return extent;
}

bool ThingsBeside::isThing(const SurfacePiece& piece, const DepthImage& image, const Extent& extent,
                           bool stands, const SurfacePieces::Outlines& outlines) {
  const PieceOutline &whole = outlines.whole, &above = outlines.above, &end = outlines.end;
  if (extent.low >= kSeatHeight) return false;
  const bool ends = end.hidden + end.unknown <= kHidden * end.all();
  const bool is_apart = whole.beside + whole.hidden + whole.behind <= kNoise * whole.all() &&
                        whole.unknown <= kUnknown * whole.all();
  if (ends && is_apart) return true;
  if (stands && extent.low < kOnFloor) {
    const bool is_post = extent.high > kHighestLeg && whole.hidden <= kHidden * whole.all() &&
                         end.unknown <= kUnknownEnd * end.all();
    if (ends || is_post) return true;
  }
  const bool ends_above =
      above.free > kFreeAbove * above.all() || (stands && above.hidden < kHiddenAbove * above.all());
  return ends_above && pieces_.breadth(piece, image) > kBroad;
}

void ThingsBeside::take(const SurfacePiece& piece, const DepthImage& image, std::span<std::uint8_t> labels) {
  for (const std::uint32_t i : pieces_.pixels(piece)) {
    labels[i] = 0;
    is_thing_[i] = 1;
    note(i, image.z[i]);
  }
}

/// Sets is_thing_ of all rows in which the pieces, or what is beside them, are.
void ThingsBeside::markThings(const DepthImage& image) {
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max(), last = 0;
  for (const SurfacePiece& piece : pieces_.pieces())
    for (const std::uint32_t i : pieces_.pixels(piece)) {
      first = std::min(first, i);
      last = std::max(last, i);
    }
  const std::size_t beside = SurfacePieces::kBridge * static_cast<std::size_t>(image.width);
  const std::size_t begin = first < beside ? 0 : first - beside;
  const std::size_t end = std::min(image.z.size(), last + beside + 1);
  for (std::size_t i = begin; i < end; ++i) is_thing_[i] = image.z[i] > 0.0f && has(i, image.z[i]);
}

/// The piece with most surface near the middle of the body; null: none.
const SurfacePiece* ThingsBeside::trunkOf(const DepthImage& image, std::span<const int> cell_of,
                                          const PlanView::Place& place) const {
  const SurfacePiece* trunk = nullptr;
  double most = 0.0;
  for (const SurfacePiece& piece : pieces_.pieces()) {
    const double area = pieces_.areaWithin(piece, image, cell_of, place, kBodyRadius);
    if (area > most) most = area, trunk = &piece;
  }
  return trunk;
}

void ThingsBeside::find(const DepthImage& image, const FloorPlane& floor, std::span<const int> cell_of,
                        const PlanView::Place& place, std::uint8_t label, std::span<std::uint8_t> labels) {
  pieces_.divide(image, labels, label);
  const std::vector<SurfacePiece>& pieces = pieces_.pieces();
  const auto large = std::count_if(pieces.begin(), pieces.end(),
                                   [](const SurfacePiece& piece) { return piece.size() >= kFewestPixels; });
  if (large < 2) return;
  const SurfacePiece* trunk = trunkOf(image, cell_of, place);
  if (!trunk) return;
  const double top = extentOf(*trunk, image, floor).high;
  if (top < kSeatedTop) return;
  const bool stands = top > kStandingTop;
  markThings(image);
  for (int round = 0; round < kRounds; ++round)
    for (const SurfacePiece& piece : pieces) {
      const bool is_thing = is_thing_[pieces_.pixels(piece).front()] != 0;
      if (&piece == trunk || is_thing || piece.size() < kFewestPixels) continue;
      const SurfacePieces::Outlines outlines = pieces_.outlines(piece, image, is_thing_);
      if (!isThing(piece, image, extentOf(piece, image, floor), stands, outlines)) continue;
      take(piece, image, labels);
      const bool is_covered = outlines.end.hidden > kHidden * outlines.end.all();
      if (!stands || !is_covered || outlines.covers < 0) continue;
      const SurfacePiece& carried = pieces[static_cast<std::size_t>(outlines.covers)];
      if (&carried != trunk) take(carried, image, labels);
    }
}

}  // namespace abstand::tracking
