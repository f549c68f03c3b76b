#include "humanmodel/body_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace abstand::humanmodel {
namespace {

constexpr double kRows = static_cast<double>(kCellRows);
// Component of a unit vector above which a second side is named too.
constexpr double kNamed = 0.5;

struct CellIndex {
  std::size_t side, x, y;
};

CellIndex indexOf(std::size_t cell) {
  return {cell / (kCellRows * kCellRows), cell / kCellRows % kCellRows, cell % kCellRows};
}

/// Direction of a point on a side; `x` and `y` in rows of cells.
Vector3d onSide(std::size_t side, double x, double y) {
  const std::size_t axis = side / 2;
  const auto slope = [](double row) { return std::tan(0.25 * std::numbers::pi * (2.0 * row / kRows - 1.0)); };
  Vector3d u;
  u[static_cast<int>(axis)] = side % 2 == 0 ? 1.0 : -1.0;
  u[static_cast<int>((axis + 1) % 3)] = slope(x);
  u[static_cast<int>((axis + 2) % 3)] = slope(y);
  return u.normalized();
}

}  // namespace

std::size_t cellOf(const Vector3d& u) {
  int axis = 0;
  const double largest = u.cwiseAbs().maxCoeff(&axis);
  const std::size_t side = 2 * static_cast<std::size_t>(axis) + (u[axis] < 0.0 ? 1 : 0);
  const auto row = [&](int a) {
    const double angle = std::atan(u[a] / largest) * 4.0 / std::numbers::pi;
    return static_cast<std::size_t>(std::clamp(std::floor(0.5 * (angle + 1.0) * kRows), 0.0, kRows - 1.0));
  };
  return (side * kCellRows + row((axis + 1) % 3)) * kCellRows + row((axis + 2) % 3);
}

std::array<Vector3d, 4> cellCorners(std::size_t cell) {
  const CellIndex i = indexOf(cell);
  const auto x = static_cast<double>(i.x), y = static_cast<double>(i.y);
  std::array<Vector3d, 4> corners{onSide(i.side, x, y), onSide(i.side, x + 1.0, y),
                                  onSide(i.side, x + 1.0, y + 1.0), onSide(i.side, x, y + 1.0)};
  if (i.side % 2 == 1) std::swap(corners[1], corners[3]);
  return corners;
}

Vector3d cellMiddle(std::size_t cell) {
  const CellIndex i = indexOf(cell);
  return onSide(i.side, static_cast<double>(i.x) + 0.5, static_cast<double>(i.y) + 0.5);
}

Vector3d surfacePoint(const geometry::Shape& shape, const Vector3d& u) {
  const Vector3d half = 0.5 * geometry::bounds(shape).extent();
  const bool box = std::holds_alternative<geometry::Cuboid>(shape);
  return half.cwiseProduct(box ? Vector3d(u / u.cwiseAbs().maxCoeff()) : u.normalized());
}

std::string cellPlace(std::size_t cell) {
  static constexpr const char* kNames[3][2] = {
      {"front", "back"}, {"left", "right"}, {"upper end", "lower end"}};
  const Vector3d u = cellMiddle(cell);
  const auto name = [&](int axis) { return kNames[axis][u[axis] < 0.0 ? 1 : 0]; };
  const int side = static_cast<int>(indexOf(cell).side / 2);
  std::string place = name(side);
  int second = (side + 1) % 3;
  if (std::abs(u[(side + 2) % 3]) > std::abs(u[second])) second = (side + 2) % 3;
  if (std::abs(u[second]) > kNamed) place += std::string(", ") + name(second);
  return place;
}

}  // namespace abstand::humanmodel
