// A ring of balls, the posed model, and the true skin.
#include "tests/tracking/tracker/certified_clip.hpp"

#include <algorithm>
#include <cmath>

#include "core/scene/directed_uncertainty.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "humanmodel/poser.hpp"
#include "tests/support/brute_force.hpp"

namespace abstand::testing {
namespace {

constexpr double kSpacing = 0.03;   // m, voxels and points
constexpr double kSameTime = 1e-6;  // s
constexpr int kAround = 8;

/// Distances (m) of the ring and heights (m) above the floor, which alternate.
struct Place {
  double away, height;
};
constexpr std::array<Place, 3> kPlaces{{{0.55, 0.30}, {0.75, 0.95}, {0.60, 1.50}}};

/// m, smallest distance of the skin to p.
double distanceTo(const std::vector<tracking::SkinPart>& skin, const Vector3d& p) {
  double least = kInfinity;
  for (const tracking::SkinPart& part : skin) {
    const geometry::TriangleMesh& mesh = part.mesh;
    for (const auto& triangle : mesh.triangles) {
      const Vector3d &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
                     &c = mesh.vertices[triangle[2]];
      const double size = std::sqrt(std::max((b - a).squaredNorm(), (c - a).squaredNorm()));
      if ((p - a).norm() - size >= least) continue;
      least = std::min(least, (p - nearestOfTriangle(p, a, b, c)).norm());
    }
  }
  return least;
}

std::vector<Vector3d> ringAbout(const std::vector<humanmodel::SkeletonFrame>& truth) {
  Vector3d middle = Vector3d::Zero();
  for (const humanmodel::SkeletonFrame& f : truth)
    middle += 0.5 * (f[humanmodel::Joint::kHipLeft] + f[humanmodel::Joint::kHipRight]);
  middle /= static_cast<double>(truth.size());
  std::vector<Vector3d> ring;
  for (int k = 0; k < kAround; ++k)
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
      const double angle = 2.0 * kPi * (k + static_cast<double>(i) / kPlaces.size()) / kAround;
      ring.emplace_back(middle.x() + kPlaces[i].away * std::cos(angle),
                        middle.y() + kPlaces[i].away * std::sin(angle), kPlaces[i].height);
    }
  return ring;
}

/// The parts of a model and the balls, with a pair for each of both.
class RingScene {
 public:
  RingScene(const humanmodel::HumanModel& model, const std::vector<Vector3d>& ring) : balls_{ring.size()} {
    const structure::HapticOptions options{.voxel_size = kSpacing, .point_spacing = kSpacing};
    for (std::size_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
      const humanmodel::HumanPart& part = model.part(static_cast<humanmodel::BodyPart>(i));
      const std::string name(humanmodel::partName(part.part));
      scene_.addObject({name, "person",
                        structure::buildHapticStructure(name, geometry::makeSurface(part.shape), options)});
    }
    const auto ball = structure::buildHapticStructure(
        "ball", geometry::makeSurface(geometry::Sphere{CertifiedDistances::kBall}), options);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const ObjectId id = scene_.addObject({"ball" + std::to_string(k), "objects", ball});
      Transform X = Transform::Identity();
      X.translation() = ring[k];
      scene_.setPose(id, X, 0.0);
      for (std::uint32_t part = 0; part < humanmodel::kBodyPartCount; ++part)
        scene_.addPair(ObjectId(part), id);
    }
  }

  void pose(double t, const humanmodel::HumanPose& pose) {
    for (std::uint32_t i = 0; i < humanmodel::kBodyPartCount; ++i) {
      scene_.setPose(ObjectId(i), pose.X_WP[i], t);
      scene_.setPoseUncertainty(
          ObjectId(i), humanmodel::partUncertainty(pose.age[i], pose.spread[i]),
          humanmodel::ageUncertainty(pose.age[i]),
          humanmodel::kSpreadQuantile * humanmodel::kSpreadQuantile * pose.covariance[i]);
    }
    scene_.step();
  }

  /// Adds the certified distance of each ball.
  void certify(CertifiedDistances& out) const {
    std::size_t pair = 0;
    for (std::size_t k = 0; k < balls_; ++k) {
      double certified = kInfinity, of_radius = kInfinity;
      for (std::size_t part = 0; part < humanmodel::kBodyPartCount; ++part, ++pair) {
        const PairId id(static_cast<std::uint32_t>(pair));
        const query::PairResult& result = scene_.result(id);
        const double known = result.distance - result.bound;
        certified = std::min(certified, known - scene::directedUncertainty(scene_, id, result));
        of_radius = std::min(of_radius, known - scene_.pairUncertainty(id));
      }
      out.certified.push_back(certified);
      out.of_radius.push_back(of_radius);
    }
  }

 private:
  scene::Scene scene_;
  std::size_t balls_;
};

}  // namespace

double CertifiedDistances::held() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) count += certified[i] <= truth[i];
  return truth.empty() ? 1.0 : static_cast<double>(count) / static_cast<double>(truth.size());
}

double CertifiedDistances::largestViolation() const {
  double largest = -kInfinity;
  for (std::size_t i = 0; i < truth.size(); ++i) largest = std::max(largest, certified[i] - truth[i]);
  return largest;
}

double CertifiedDistances::medianSlack(const std::vector<double>& certified,
                                       const std::vector<double>& truth) {
  std::vector<double> slack;
  for (std::size_t i = 0; i < truth.size(); ++i) slack.push_back(truth[i] - certified[i]);
  if (slack.empty()) return kNaN;
  const auto middle = slack.begin() + static_cast<std::ptrdiff_t>(slack.size() / 2);
  std::nth_element(slack.begin(), middle, slack.end());
  return *middle;
}

void CertifiedDistances::add(const CertifiedDistances& other) {
  certified.insert(certified.end(), other.certified.begin(), other.certified.end());
  of_radius.insert(of_radius.end(), other.of_radius.begin(), other.of_radius.end());
  truth.insert(truth.end(), other.truth.begin(), other.truth.end());
}

CertifiedDistances certifiedDistances(const SimulatedClip& clip, const tracking::ClipTrack& track) {
  CertifiedDistances out;
  if (track.people.empty()) return out;
  const tracking::ClipPerson& person = track.people[0];
  const humanmodel::HumanModel model = humanmodel::makeHuman(person.body);
  humanmodel::Poser poser(model);
  poser.calibrate(person.frames);
  const std::vector<Vector3d> ring = ringAbout(clip.truth);
  RingScene scene(model, ring);
  humanmodel::HumanPose pose;
  std::size_t image = 0;
  for (const humanmodel::SkeletonFrame& frame : person.frames) {
    while (image + 1 < clip.truth.size() && clip.truth[image].t < frame.t - kSameTime) ++image;
    poser.pose(frame, pose);
    scene.pose(frame.t, pose);
    scene.certify(out);
    const std::vector<tracking::SkinPart> skin = clip.skin->wrap(clip.truth[image]);
    for (const Vector3d& p : ring)
      out.truth.push_back(std::max(0.0, distanceTo(skin, p) - CertifiedDistances::kBall));
  }
  return out;
}

}  // namespace abstand::testing
