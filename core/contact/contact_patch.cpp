#include "core/contact/contact_patch.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/connected_triangles.hpp"

namespace abstand::contact {
namespace {

/// m: boxes are widened by it, far more than rounding moves a corner.
constexpr double kBoxSlack = 1e-9;

/// What a search leaves behind, so that the next one need not allocate it.
struct PatchMemory {
  PlacedVertices points;
  std::vector<std::uint32_t> hiding;  ///< triangles that may hide the patch
  std::vector<PatchTriangle> open;
  ConnectedTriangles connected;
  ContactPatch patch;
};

class PatchSearch {
 public:
  PatchSearch(const ContactSurface& surface, const ContactPlace& place, double x, PatchMemory& memory)
      : surface_{surface}, x_{x}, radius_{place.body_radius}, memory_{memory}, points_{memory.points} {
    const Vector3d u_B = place.n_B.unitOrthogonal(), v_B = place.n_B.cross(u_B);
    Matrix3d R_PB;
    R_PB << u_B.transpose(), v_B.transpose(), place.n_B.transpose();
    R_PB_ = R_PB;
    p_B_ = place.p_B;
    points_.begin(surface.mesh(), R_PB, place.p_B);
    const ContactSurface::Nearest contact = surface.nearest(place.p_B);
    contact_height_ = place.n_B.dot(contact.point - place.p_B);
    start_ = *std::max_element(corners(contact.triangle).begin(), corners(contact.triangle).end(),
                               [&](std::uint32_t a, std::uint32_t b) { return height(a) < height(b); });
  }

  const ContactPatch& search() {
    ConnectedTriangles& connected = memory_.connected;
    connectedAbove(surface_, points_, start_, contact_height_ - x_, connected);
    const double top = height(connected.foremost);
    if (top > contact_height_) connectedAbove(surface_, points_, connected.foremost, top - x_, connected);
    ContactPatch& result = memory_.patch;
    result.pieces.clear();
    result.back.clear();
    result.floor = 0.0;
    result.body_radius = radius_;
    result.foremost_B = surface_.mesh().vertices[connected.foremost];
    result.offset = top - contact_height_;
    for (const std::uint32_t t : connected.triangles) result.pieces.push_back(triangle(t));
    if (!divideForCurve({radius_, x_, contact_height_ - x_}, memory_.open, result.pieces)) {
      result.pieces.clear();
      return result;
    }
    result.floor = topOf(result.pieces, top) - x_;
    addBacks(top - x_, result);
    return result;
  }

 private:
  const std::array<std::uint32_t, 3>& corners(std::uint32_t t) const { return surface_.mesh().triangles[t]; }
  double height(std::uint32_t vertex) const { return points_[vertex].z(); }
  PatchTriangle triangle(std::uint32_t t) const {
    return {points_[corners(t)[0]], points_[corners(t)[1]], points_[corners(t)[2]]};
  }

  /// Upper bound of the height of the body's foremost point, relative to the curved person.
  double topOf(const std::vector<PatchTriangle>& pieces, double flat_top) const {
    if (std::isinf(radius_)) return flat_top;
    double top = contact_height_;
    for (const PatchTriangle& piece : pieces)
      for (const Vector3d& c : piece)
        top = std::max(top, c.z() - c.head<2>().squaredNorm() / (2.0 * radius_));
    return std::min(flat_top, top + kPieceError * x_);
  }

  /// Triangles of the clusters whose box reaches above `level` and over a piece; no other triangle can hide a
  /// piece.
  void findHiding(double level, const std::vector<PatchTriangle>& pieces) const {
    Vector3d lower = Vector3d::Constant(kInfinity), upper = -lower;
    for (const PatchTriangle& piece : pieces)
      for (const Vector3d& c : piece) {
        lower = lower.cwiseMin(c);
        upper = upper.cwiseMax(c);
      }
    lower.z() = level;
    upper.z() = kInfinity;
    const Matrix3d spread = R_PB_.cwiseAbs();
    memory_.hiding.clear();
    for (std::size_t i = 0; i < surface_.clusters(); ++i) {
      const ContactSurface::Cluster cluster = surface_.cluster(i);
      const Vector3d centre = R_PB_ * (cluster.centre - p_B_);
      const Vector3d half = spread * cluster.half + Vector3d::Constant(kBoxSlack);
      if ((centre + half - lower).minCoeff() < 0.0 || (upper - centre + half).minCoeff() < 0.0) continue;
      memory_.hiding.insert(memory_.hiding.end(), cluster.triangles.begin(), cluster.triangles.end());
    }
    // Sums are taken in the order of the mesh.
    std::sort(memory_.hiding.begin(), memory_.hiding.end());
  }

  void addBacks(double level, ContactPatch& patch) const {
    findHiding(level, patch.pieces);
    for (const std::uint32_t t : memory_.hiding) {
      const PatchTriangle c = triangle(t);
      if (std::max({c[0].z(), c[1].z(), c[2].z()}) < level) continue;
      PatchPolygon polygon;
      polygon.corners.fill(Vector3d::Zero());  // all of them are copied
      for (const Vector3d& corner : c) polygon.add(corner);
      if (polygon.area() < 0.0) patch.back.push_back(polygon);
    }
  }

  const ContactSurface& surface_;
  double x_, radius_;
  PatchMemory& memory_;
  PlacedVertices& points_;
  Matrix3d R_PB_;
  Vector3d p_B_;
  double contact_height_{0.0};
  std::uint32_t start_{0};
};

}  // namespace

double PatchPolygon::area() const {
  double twice = 0.0;
  for (int i = 1; i + 1 < count; ++i) {
    const Vector3d a = corner(i) - corner(0), b = corner(i + 1) - corner(0);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

const ContactPatch& contactPatch(const ContactSurface& surface, const ContactPlace& place, double x) {
  static thread_local PatchMemory memory;
  return PatchSearch(surface, place, x, memory).search();
}

}  // namespace abstand::contact
