// Flood fill over depths, and the largest square by dynamic programming.
#include "tracking/depth/people/surface_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::tracking {
namespace {

struct PixelStep {
  int u, v;
};
constexpr std::array<PixelStep, 4> kFourSides{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// The next measured pixel in a direction; -1: none.
int nextMeasured(const DepthImage& image, std::size_t from, PixelStep side) {
  const int u = static_cast<int>(from) % image.width, v = static_cast<int>(from) / image.width;
  for (int step = 1; step <= SurfacePieces::kBridge; ++step) {
    const int x = u + step * side.u, y = v + step * side.v;
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return -1;
    if (image.at(x, y) != 0.0f) return y * image.width + x;
  }
  return -1;
}

}  // namespace

SurfacePieces::SurfacePieces(const DepthCamera& camera) : camera_(camera) {
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  piece_of_.assign(pixels, -1);
  side_.assign(pixels, 0);
  covered_.assign(pixels, 0);
  pixels_.reserve(pixels);
  pieces_.reserve(pixels);
}

void SurfacePieces::clear() {
  std::fill(piece_of_.begin(), piece_of_.end(), -1);
  pixels_.clear();
  pieces_.clear();
}

void SurfacePieces::divide(const DepthImage& image, std::span<const std::uint8_t> labels,
                           std::uint8_t label) {
  clear();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label && piece_of_[i] < 0) grow(i, image, labels, label);
}

SurfacePiece SurfacePieces::pieceAt(std::size_t pixel, const DepthImage& image,
                                    std::span<const std::uint8_t> labels, std::uint8_t label) {
  clear();
  if (labels[pixel] != label) return {};
  grow(pixel, image, labels, label);
  return pieces_.front();
}

void SurfacePieces::grow(std::size_t seed, const DepthImage& image, std::span<const std::uint8_t> labels,
                         std::uint8_t label) {
  const auto number = static_cast<int>(pieces_.size());
  SurfacePiece piece{pixels_.size(), 0, 0.0};
  pixels_.push_back(static_cast<std::uint32_t>(seed));
  piece_of_[seed] = number;
  for (std::size_t k = piece.begin; k < pixels_.size(); ++k) {
    const std::size_t i = pixels_[k];
    const float z = image.z[i];
    piece.area += areaOf(z);
    for (const PixelStep& side : kFourSides) {
      const int next = nextMeasured(image, i, side);
      if (next < 0) continue;
      const auto j = static_cast<std::size_t>(next);
      if (labels[j] != label || piece_of_[j] >= 0 || std::abs(image.z[j] - z) >= stepAt(z)) continue;
      piece_of_[j] = number;
      pixels_.push_back(static_cast<std::uint32_t>(j));
    }
  }
  piece.end = pixels_.size();
  pieces_.push_back(piece);
}

SurfacePieces::Outlines SurfacePieces::outlines(const SurfacePiece& piece, const DepthImage& image,
                                                std::span<const std::uint8_t> is_thing) {
  Outlines outlines;
  const std::span<const std::uint32_t> own = pixels(piece);
  const int number = piece_of_[own.front()];
  const auto width = static_cast<std::uint32_t>(image.width);
  const std::uint32_t highest = *std::min_element(own.begin(), own.end());
  const auto end_rows = static_cast<std::uint32_t>(kEnd * camera_.fy / static_cast<double>(image.z[highest]));
  const std::span<int> covered = std::span(covered_).first(pieces_.size());
  std::fill(covered.begin(), covered.end(), 0);
  for (const std::uint32_t i : own) {
    const bool is_end = i / width <= highest / width + end_rows;
    for (const PixelStep& side : kFourSides) {
      const int next = nextMeasured(image, i, side);
      const auto j = static_cast<std::size_t>(std::max(0, next));
      if (next >= 0 && piece_of_[j] == number) continue;
      const bool is_nearer = image.z[j] < image.z[i] - stepAt(image.z[i]), is_other = piece_of_[j] >= 0;
      const bool of_thing = is_thing[j] != 0;
      const auto kind = next < 0                ? &PieceOutline::unknown
                        : is_nearer             ? (of_thing ? &PieceOutline::behind : &PieceOutline::hidden)
                        : is_other && !of_thing ? &PieceOutline::beside
                                                : &PieceOutline::free;
      ++(outlines.whole.*kind);
      if (side.v < 0) ++(outlines.above.*kind);
      if (is_end) ++(outlines.end.*kind);
      if (is_end && next >= 0 && is_nearer && is_other) ++covered[static_cast<std::size_t>(piece_of_[j])];
    }
  }
  const auto most = std::max_element(covered.begin(), covered.end());
  if (*most > 0) outlines.covers = static_cast<int>(most - covered.begin());
  return outlines;
}

double SurfacePieces::areaWithin(const SurfacePiece& piece, const DepthImage& image,
                                 std::span<const int> cell_of, const PlanView::Place& place,
                                 double radius) const {
  double area = 0.0;
  for (const std::uint32_t i : pixels(piece))
    if (cell_of[i] >= 0 && (PlanView::placeOf(cell_of[i]) - place).norm() < radius)
      area += areaOf(image.z[i]);
  return area;
}

double SurfacePieces::breadth(const SurfacePiece& piece, const DepthImage& image) {
  const auto begin = pixels_.begin() + static_cast<std::ptrdiff_t>(piece.begin);
  std::sort(begin, begin + static_cast<std::ptrdiff_t>(piece.size()));
  const int number = piece_of_[*begin];
  const auto width = static_cast<std::size_t>(image.width);
  float breadth = 0.0f;
  for (const std::uint32_t i : pixels(piece)) {
    const bool is_inside = i >= width && i % width > 0;
    const auto before = [&](std::size_t distance) -> int {
      return is_inside && piece_of_[i - distance] == number ? side_[i - distance] : 0;
    };
    side_[i] = static_cast<std::uint16_t>(1 + std::min({before(1), before(width), before(width + 1)}));
    breadth = std::max(breadth, static_cast<float>(side_[i]) * image.z[i]);
  }
  return static_cast<double>(breadth) / camera_.fx;
}

}  // namespace abstand::tracking
