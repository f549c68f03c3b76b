// Names, limits, bounds, areas and mass properties of the shapes.
#include "core/geometry/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::geometry {
namespace {

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;  // clang 14 needs it

/// How a shape is written on the command line.
struct Spelling {
  std::string_view name;
  std::string_view numbers;
  std::size_t count;
};
constexpr std::array<Spelling, std::variant_size_v<Shape>> kSpellings{{{"sphere", "r", 1},
                                                                       {"ellipsoid", "a,b,c", 3},
                                                                       {"cuboid", "x,y,z", 3},
                                                                       {"cylinder", "r,l", 2},
                                                                       {"capsule", "r,l", 2}}};

void checkDimension(const Shape& shape, std::string_view what, double value, bool may_be_zero = false) {
  if (value >= kMinDimension && value <= kMaxDimension) return;
  if (may_be_zero && value == 0.0) return;
  throw UsageError(std::string(shapeName(shape)) + ": " + std::string(what) + " is " + formatDouble(value) +
                   " m, expected " + (may_be_zero ? "0 or " : "") + "between " + formatDouble(kMinDimension) +
                   " and " + formatDouble(kMaxDimension) + " m");
}

/// Carlson's R_G, symmetric and homogeneous of degree 1/2, by R_F and R_D with duplication
/// (Carlson 1995, Numerical computation of real or complex elliptic integrals; NIST DLMF 19.36).
double carlsonG(Vector3d v) {
  std::sort(v.begin(), v.end());
  // With the middle value last, the terms of R_G (DLMF 19.21.10) all have the same sign.
  const double x0 = v[0], y0 = v[2], z0 = v[1];
  constexpr double kDuplicationError = 1e-3;  // the truncated series then is exact to about 1e-17

  double x = x0, y = y0, z = z0;
  double scale = 1.0;
  double sum = 0.0;
  for (;;) {
    const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    const double mean_f = (x + y + z) / 3.0;
    const double mean_d = (x + y + 3.0 * z) / 5.0;
    const Vector3d f = (mean_f - Vector3d(x, y, z).array()) / mean_f;
    const Vector3d d = (mean_d - Vector3d(x, y, z).array()) / mean_d;
    if (f.cwiseAbs().maxCoeff() < kDuplicationError && d.cwiseAbs().maxCoeff() < kDuplicationError) {
      const double e2 = f.x() * f.y() - f.z() * f.z();
      const double e3 = f.prod();
      const double rf =
          (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean_f);
      const double xy = d.x() * d.y(), zz = d.z() * d.z();
      const double d2 = xy - 6.0 * zz;
      const double d3 = (3.0 * xy - 8.0 * zz) * d.z();
      const double d4 = 3.0 * (xy - zz) * zz;
      const double d5 = xy * zz * d.z();
      const double series = 1.0 - 3.0 * d2 / 14.0 + d3 / 6.0 + 9.0 * d2 * d2 / 88.0 - 3.0 * d4 / 22.0 -
                            9.0 * d2 * d3 / 52.0 + 3.0 * d5 / 26.0;
      const double rd = 3.0 * sum + scale * series / (mean_d * std::sqrt(mean_d));
      return 0.5 * (z0 * rf - (x0 - z0) * (y0 - z0) * rd / 3.0 + std::sqrt(x0 * y0 / z0));
    }
    sum += scale / (std::sqrt(z) * (z + lambda));
    scale *= 0.25;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
  }
}

}  // namespace

std::string_view shapeName(const Shape& shape) { return kSpellings[shape.index()].name; }

Vector3d dimensionsOf(const Shape& shape) {
  struct Dimensions {
    Vector3d operator()(const Sphere& s) const { return {s.radius, 0.0, 0.0}; }
    Vector3d operator()(const Ellipsoid& s) const { return s.semi_axes; }
    Vector3d operator()(const Cuboid& s) const { return s.size; }
    Vector3d operator()(const Cylinder& s) const { return {s.radius, s.length, 0.0}; }
    Vector3d operator()(const Capsule& s) const { return {s.radius, s.length, 0.0}; }
  };
  return std::visit(Dimensions{}, shape);
}

std::optional<Shape> shapeOf(std::size_t kind, const Vector3d& v) {
  switch (kind) {
    case 0:
      return Sphere{v.x()};
    case 1:
      return Ellipsoid{v};
    case 2:
      return Cuboid{v};
    case 3:
      return Cylinder{v.x(), v.y()};
    case 4:
      return Capsule{v.x(), v.y()};
    default:
      return std::nullopt;
  }
}

void validate(const Shape& shape) {
  std::visit(Overload{[&](const Sphere& s) { checkDimension(shape, "radius", s.radius); },
                      [&](const Ellipsoid& s) {
                        for (const double a : s.semi_axes) checkDimension(shape, "semi-axis", a);
                      },
                      [&](const Cuboid& s) {
                        for (const double a : s.size) checkDimension(shape, "size", a);
                      },
                      [&](const Cylinder& s) {
                        checkDimension(shape, "radius", s.radius);
                        checkDimension(shape, "length", s.length);
                      },
                      [&](const Capsule& s) {
                        checkDimension(shape, "radius", s.radius);
                        checkDimension(shape, "length", s.length, true);
                      }},
             shape);
}

std::optional<Shape> parseShape(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto spelling = std::find_if(kSpellings.begin(), kSpellings.end(),
                                     [&](const Spelling& s) { return s.name == text.substr(0, colon); });
  if (spelling == kSpellings.end()) return std::nullopt;

  const std::string expected =
      ", expected " + std::string(spelling->name) + ":" + std::string(spelling->numbers) + " in metres";
  std::array<double, 3> v{};
  std::size_t count = 0;
  for (std::string_view rest = text.substr(colon + 1);;) {
    const auto comma = rest.find(',');
    const auto word = rest.substr(0, comma);
    const auto value = parseDouble(word);
    if (!value)
      throw UsageError(std::string(text) + ": found \"" + std::string(word) + "\" where a number stands" +
                       expected);
    if (count < v.size()) v[count] = *value;
    ++count;
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (count != spelling->count)
    throw UsageError(std::string(text) + ": found " + std::to_string(count) + " numbers" + expected);

  Shape shape = Sphere{v[0]};
  if (spelling->name == "ellipsoid") shape = Ellipsoid{{v[0], v[1], v[2]}};
  if (spelling->name == "cuboid") shape = Cuboid{{v[0], v[1], v[2]}};
  if (spelling->name == "cylinder") shape = Cylinder{v[0], v[1]};
  if (spelling->name == "capsule") shape = Capsule{v[0], v[1]};
  validate(shape);
  return shape;
}

Bounds bounds(const Shape& shape) {
  const Vector3d half =
      std::visit(Overload{[](const Sphere& s) -> Vector3d { return Vector3d::Constant(s.radius); },
                          [](const Ellipsoid& s) -> Vector3d { return s.semi_axes; },
                          [](const Cuboid& s) -> Vector3d { return 0.5 * s.size; },
                          [](const Cylinder& s) -> Vector3d {
                            return {s.radius, s.radius, 0.5 * s.length};
                          },
                          [](const Capsule& s) -> Vector3d {
                            return {s.radius, s.radius, 0.5 * s.length + s.radius};
                          }},
                 shape);
  return {-half, half};
}

double surfaceArea(const Shape& shape) {
  return std::visit(
      Overload{[](const Sphere& s) { return 4.0 * kPi * s.radius * s.radius; },
               [](const Ellipsoid& s) {
                 // DLMF 19.33.1
                 const Vector3d q = s.semi_axes.cwiseAbs2();
                 return 4.0 * kPi * carlsonG({q.x() * q.y(), q.x() * q.z(), q.y() * q.z()});
               },
               [](const Cuboid& s) {
                 return 2.0 * (s.size.x() * s.size.y() + s.size.y() * s.size.z() + s.size.z() * s.size.x());
               },
               [](const Cylinder& s) { return 2.0 * kPi * s.radius * (s.radius + s.length); },
               [](const Capsule& s) { return 2.0 * kPi * s.radius * (2.0 * s.radius + s.length); }},
      shape);
}

MassProperties massProperties(const Shape& shape) {
  MassProperties out;
  Vector3d moments;  // principal moments per unit of volume, m^2
  std::visit(Overload{[&](const Sphere& s) {
                        out.volume = 4.0 / 3.0 * kPi * std::pow(s.radius, 3);
                        moments.setConstant(0.4 * s.radius * s.radius);
                      },
                      [&](const Ellipsoid& s) {
                        out.volume = 4.0 / 3.0 * kPi * s.semi_axes.prod();
                        const Vector3d q = s.semi_axes.cwiseAbs2();
                        moments = (Vector3d::Constant(q.sum()) - q) / 5.0;
                      },
                      [&](const Cuboid& s) {
                        out.volume = s.size.prod();
                        const Vector3d q = s.size.cwiseAbs2();
                        moments = (Vector3d::Constant(q.sum()) - q) / 12.0;
                      },
                      [&](const Cylinder& s) {
                        const double rr = s.radius * s.radius;
                        out.volume = kPi * rr * s.length;
                        const double across = (3.0 * rr + s.length * s.length) / 12.0;
                        moments = {across, across, 0.5 * rr};
                      },
                      [&](const Capsule& s) {
                        const double r = s.radius, l = s.length;
                        const double middle = kPi * r * r * l;
                        const double ends = 4.0 / 3.0 * kPi * r * r * r;
                        out.volume = middle + ends;
                        // Two hemispheres with their centroids 3r/8 beyond the ends of the middle part.
                        const double across = middle * (l * l / 12.0 + r * r / 4.0) +
                                              ends * (0.4 * r * r + 0.25 * l * l + 0.375 * l * r);
                        const double along = 0.5 * middle * r * r + 0.4 * ends * r * r;
                        moments = Vector3d(across, across, along) / out.volume;
                      }},
             shape);
  out.inertia = (out.volume * moments).asDiagonal();
  return out;
}

}  // namespace abstand::geometry
