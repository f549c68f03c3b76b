// Poses of two bodies that are difficult for a sampling engine.
#include "core/verify/adversarial_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abstand::verify {
namespace {

// m from the world's origin: a room, and the extent of large maps.
constexpr double kRoom = 2.0;
constexpr double kMap = 1000.0;

double gap(Random& random, double voxel) {
  constexpr std::array kVoxels{0.0, 0.0, 0.1, 0.5, 1.0, 3.0, -0.1, -0.5, -1.0};
  constexpr std::array kTiny{1e-9, -1e-9, 1e-6, -1e-6};
  if (random.chance(0.25)) return kTiny[random.below(kTiny.size())];
  return voxel * kVoxels[random.below(kVoxels.size())];
}

/// The pose of B in A that puts B's feature onto A's, with opposite `out` directions and a distance of `gap`.
Transform meet(const Feature& a, const Feature& b, double spin, double gap) {
  Matrix3d A, B;
  A << a.along, a.out.cross(a.along), a.out;
  B << b.along, b.out.cross(b.along), b.out;
  // Maps B's `out` to -z of A's feature, B's `along` to its x.
  const Matrix3d flip = Vector3d(1, -1, -1).asDiagonal();
  Transform X = Transform::Identity();
  X.linear() = A * Eigen::AngleAxisd(spin, Vector3d::UnitZ()).toRotationMatrix() * flip * B.transpose();
  X.translation() = a.point + gap * a.out - X.linear() * b.point;
  return X;
}

Feature someFace(const AdversarialBody& body, Random& random) {
  const std::size_t t = random.below(body.mesh.triangles.size());
  const double u = random.unit();
  return body.face(t, u, random.unit());
}
Feature someEdge(const AdversarialBody& body, Random& random) {
  const std::size_t t = random.below(body.mesh.triangles.size());
  const auto corner = static_cast<int>(random.below(3));
  return body.edge(t, corner, random.unit());
}
Feature someCorner(const AdversarialBody& body, Random& random) {
  const std::size_t t = random.below(body.mesh.triangles.size());
  return body.corner(t, static_cast<int>(random.below(3)));
}

/// A random angle, or one that makes edges parallel.
double someSpin(Random& random) {
  return random.chance(0.5) ? 0.5 * kPi * static_cast<double>(random.below(4))
                            : random.between(0.0, 2.0 * kPi);
}

Matrix3d rightAngles(Random& random) {
  Matrix3d R = Matrix3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    Matrix3d quarter = Matrix3d::Identity();
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    quarter(i, i) = quarter(j, j) = 0.0;
    quarter(i, j) = -1.0;
    quarter(j, i) = 1.0;
    for (std::size_t n = random.below(4); n > 0; --n) R = quarter * R;
  }
  return R;
}

Transform relativePose(const AdversarialBody& a, const AdversarialBody& b, PoseFamily family,
                       Random& random) {
  const double voxel = std::min(a.options.voxel_size, b.options.voxel_size);
  Transform X = Transform::Identity();
  switch (family) {
    case PoseFamily::kRandom:
      X.linear() = random.rotation();
      X.translation() = random.inCube(1.2 * (a.radius + b.radius));
      return X;
    case PoseFamily::kEdges: {
      const Feature on_a = someEdge(a, random), on_b = someEdge(b, random);
      const double spin = someSpin(random);
      return meet(on_a, on_b, spin, gap(random, voxel));
    }
    case PoseFamily::kTips: {
      const bool tip_on_a = random.chance(0.5);
      const Feature on_a = tip_on_a ? someCorner(a, random) : someFace(a, random);
      const Feature on_b = tip_on_a ? someFace(b, random) : someCorner(b, random);
      const double spin = someSpin(random);
      return meet(on_a, on_b, spin, gap(random, voxel));
    }
    case PoseFamily::kEdgeFace: {
      const bool edge_on_a = random.chance(0.5);
      const Feature on_a = edge_on_a ? someEdge(a, random) : someFace(a, random);
      const Feature on_b = edge_on_a ? someFace(b, random) : someEdge(b, random);
      const double spin = someSpin(random);
      return meet(on_a, on_b, spin, gap(random, voxel));
    }
    case PoseFamily::kFaces: {
      const Feature on_a = someFace(a, random), on_b = someFace(b, random);
      const double spin = someSpin(random);
      return meet(on_a, on_b, spin, gap(random, voxel));
    }
    case PoseFamily::kIdentical:
      if (random.chance(0.5)) X.translation() = random.inCube(gap(random, voxel));
      return X;
    case PoseFamily::kNested:
      X.linear() = random.rotation();
      X.translation() = random.inCube(0.3 * std::max(a.radius, b.radius));
      return X;
    case PoseFamily::kGrid:
      X.linear() = rightAngles(random);
      X.translation() =
          (random.inCube(1.2 * (a.radius + b.radius)) / (0.5 * voxel)).array().round() * 0.5 * voxel;
      return X;
    case PoseFamily::kFar: {
      X.linear() = random.chance(0.5) ? rightAngles(random) : random.rotation();
      const double distance = a.radius + b.radius + std::pow(10.0, random.between(-0.5, 3.0));
      X.translation() =
          distance * (random.chance(0.5) ? Vector3d(rightAngles(random).col(0)) : random.direction());
      return X;
    }
  }
  return X;
}

}  // namespace

const char* familyName(PoseFamily family) {
  constexpr std::array kNames{"anywhere",        "edge on edge",   "corner over face",
                              "edge along face", "coplanar faces", "identical poses",
                              "nested",          "on the grid",    "far apart"};
  static_assert(kNames.size() == kPoseFamilies);
  return kNames[static_cast<std::size_t>(family)];
}

AdversarialPose adversarialPose(const std::vector<AdversarialBody>& bodies, std::uint64_t seed,
                                std::uint64_t index) {
  Random random(seed, index);
  AdversarialPose pose;
  pose.family = static_cast<PoseFamily>(random.below(kPoseFamilies));
  pose.a = random.below(bodies.size());
  const bool same = pose.family == PoseFamily::kIdentical && random.chance(0.5);
  pose.b = same ? pose.a : random.below(bodies.size());
  pose.X_WA = Transform::Identity();
  if (!random.chance(0.2)) {
    pose.X_WA.linear() = random.rotation();
    pose.X_WA.translation() = random.inCube(random.chance(0.1) ? kMap : kRoom);
  }
  pose.X_WB = pose.X_WA * relativePose(bodies[pose.a], bodies[pose.b], pose.family, random);
  return pose;
}

}  // namespace abstand::verify
