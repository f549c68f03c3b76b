// Closed forms of contact forces under the volume law.
#include "core/verify/closed_contact.hpp"

#include <array>
#include <cmath>

namespace abstand::verify {

double ballInBallForce(double r, double R, double c) {
  // With w = c^2 + r^2 - 2 c r u, the squared distance from the centre of R.
  const double a = c * c + r * r, b = 2.0 * c * r;
  const double from = (c - r) * (c - r), to = R * R, u = (a - to) / b;
  const auto primitive = [a](double w) { return 2.0 / 3.0 * a * std::pow(w, 1.5) - 0.4 * std::pow(w, 2.5); };
  return 2.0 * kPi * r * r * (0.5 * R * (1.0 - u * u) - (primitive(to) - primitive(from)) / (b * b));
}

double capVolume(double r, double depth) { return kPi * depth * depth * (3.0 * r - depth) / 3.0; }

Submerged submerged(const geometry::TriangleMesh& mesh, const Transform& X_WB) {
  // Each triangle, clipped at z = 0, spans pyramids with a point of that plane; the cut face has no volume.
  Submerged sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vector3d, 4> cut;
    std::size_t corners = 0;
    for (int i = 0; i < 3; ++i) {
      const Vector3d p = X_WB * mesh.corner(t, i), q = X_WB * mesh.corner(t, (i + 1) % 3);
      if (p.z() <= 0.0) cut[corners++] = p;
      if ((p.z() <= 0.0) != (q.z() <= 0.0)) cut[corners++] = p + (q - p) * (p.z() / (p.z() - q.z()));
    }
    for (std::size_t k = 1; k + 1 < corners; ++k) {
      const double volume = cut[0].cross(cut[k]).dot(cut[k + 1]) / 6.0;
      sum.volume += volume;
      sum.centroid += 0.25 * volume * (cut[0] + cut[k] + cut[k + 1]);
    }
  }
  if (sum.volume > 0.0) sum.centroid /= sum.volume;
  return sum;
}

double pinInHoleForce(double r, double R, double offset, double length) {
  // rho = R at cos(phi) = (R^2 - r^2 - offset^2) / (2 r offset). Simpson's rule over the pressed half.
  const double max_phi = std::acos(std::min(1.0, (R * R - r * r - offset * offset) / (2.0 * r * offset)));
  constexpr int kIntervals = 2000;  // error below 1e-12 of the force: the integrand is smooth
  double sum = 0.0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double phi = max_phi * i / kIntervals;
    const double rho = std::sqrt(r * r + offset * offset + 2.0 * r * offset * std::cos(phi));
    const double weight = i == 0 || i == kIntervals ? 1.0 : (i % 2 ? 4.0 : 2.0);
    sum += weight * (rho - R) * std::cos(phi);
  }
  return 2.0 * length * r * sum * max_phi / (3.0 * kIntervals);
}

}  // namespace abstand::verify
