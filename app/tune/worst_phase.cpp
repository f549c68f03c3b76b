#include "app/tune/worst_phase.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "app/tune/body_path.hpp"
#include "core/query/pair_query.hpp"
#include "humanmodel/body_part.hpp"

namespace abstand::tune {
namespace {

// s: shortest time interval; the remaining uncertainty stays in `lower`.
constexpr double kShortest = 1e-5;
// Queries between two checks for an interrupt.
constexpr long kLookEvery = 1024;

/// Path of a link over its robot's program.
struct LinkPath {
  std::size_t object{0};
  BodyPath path;
};

struct Interval {
  double t0{0.0}, t1{0.0};
  double middle() const { return 0.5 * (t0 + t1); }
  double length() const { return t1 - t0; }
};

struct Node {
  double lower{-kInfinity};
  std::size_t link{0};
  Interval person, robot;
  double reach_person{0.0}, reach_robot{0.0};
  bool operator<(const Node& other) const { return lower > other.lower; }  // smallest lower bound first
};

/// Search for one part of a person.
class Search {
 public:
  Search(const session::Session& session, std::size_t part, const BodyPath& path,
         const std::vector<LinkPath>& links, const WorstPhaseOptions& options)
      : scene_(session.scene()),
        part_(part),
        path_(path),
        links_(links),
        options_(options),
        memories_(links.size()) {}

  bool run(const std::vector<Interval>& seen, WorstPhase& worst) {
    best_ = kInfinity;
    std::vector<bool> paired(scene_.objectCount(), false);
    const ObjectId part(static_cast<std::uint32_t>(part_));
    for (const PairId id : scene_.pairsOf(part)) {
      const scene::Pair& pair = scene_.pairs()[id.index()];
      paired[(pair.a == part ? pair.b : pair.a).index()] = true;
    }
    for (std::size_t l = 0; l < links_.size(); ++l) {
      if (!paired[links_[l].object]) continue;
      for (const Interval& interval : seen)
        push(l, interval, {links_[l].path.begin(), links_[l].path.end()}, worst);
    }
    double closed = kInfinity;  // of intervals that are not divided further
    while (!open_.empty()) {
      const Node node = open_.top();
      worst.lower = std::min(node.lower, closed);
      if (worst.lower >= best_ - options_.tolerance || best_ <= options_.enough) break;
      open_.pop();
      if (worst.queries % kLookEvery < 4 && options_.interrupted && options_.interrupted()) return false;
      const bool divide_person = node.person.length() > kShortest &&
                                 (node.reach_person >= node.reach_robot || node.robot.length() <= kShortest);
      if (!divide_person && node.robot.length() <= kShortest) {
        closed = std::min(closed, node.lower);
        continue;
      }
      const Interval& whole = divide_person ? node.person : node.robot;
      for (const Interval half : {Interval{whole.t0, whole.middle()}, Interval{whole.middle(), whole.t1}})
        push(node.link, divide_person ? half : node.person, divide_person ? node.robot : half, worst);
    }
    if (open_.empty()) worst.lower = std::min(closed, best_);
    worst.lower = std::min(worst.lower, best_);
    worst.touches = best_ <= options_.enough;
    return true;
  }

 private:
  void push(std::size_t l, const Interval& person, const Interval& robot, WorstPhase& worst) {
    const LinkPath& link = links_[l];
    Node node{0.0, l, person, robot, path_.reach(person.t0, person.t1), link.path.reach(robot.t0, robot.t1)};
    const double uncertainty = path_.uncertainty(person.t0, person.t1);
    const Transform X_part = path_.at(person.middle()), X_link = link.path.at(robot.middle());
    const double slack = node.reach_person + node.reach_robot + uncertainty;
    // Bounding spheres first: they decide most cases.
    const structure::HapticStructure &a = *scene_.objects()[part_].spec.structure,
                                     &b = *scene_.objects()[link.object].spec.structure;
    const double balls = (X_part * a.bounding_sphere.centre - X_link * b.bounding_sphere.centre).norm() -
                         a.bounding_sphere.radius - b.bounding_sphere.radius;
    node.lower = balls - slack;
    if (node.lower < best_) {
      query::queryPair({a, X_part}, {b, X_link}, {}, {memories_[l], scratch_}, result_);
      ++worst.queries;
      const double clearance =
          result_.distance - result_.bound - path_.uncertainty(person.middle(), person.middle());
      node.lower = std::max(node.lower, result_.distance - result_.bound - slack);
      if (clearance < best_) {
        best_ = clearance;
        worst.distance = result_.distance;
        worst.t_person = person.middle();
        worst.t_robot = robot.middle();
        worst.link = scene_.objects()[link.object].spec.name;
      }
    }
    if (node.lower < best_ - options_.tolerance) open_.push(node);
  }

  const scene::Scene& scene_;
  std::size_t part_;
  const BodyPath& path_;
  const std::vector<LinkPath>& links_;
  const WorstPhaseOptions& options_;
  std::vector<query::PairMemory> memories_;
  kernels::PairScratch scratch_;
  query::PairResult result_;
  std::priority_queue<Node> open_;
  double best_{kInfinity};
};

std::vector<LinkPath> linkPaths(session::Session& session, double rate) {
  std::vector<LinkPath> links;
  scene::Scene& scene = session.scene();
  for (const auto& m : session.mechanisms()) {
    const std::size_t first = links.size();
    for (const auto& link : m->links())
      if (link.object)
        links.push_back(
            {link.object->index(), BodyPath(scene.object(*link.object).spec.structure->bounding_sphere)});
    const double begin = m->motion() ? m->motion()->start() : 0.0,
                 end = m->motion() ? m->motion()->end() : 0.0;
    const auto steps = static_cast<std::size_t>(std::ceil((end - begin) * rate - 1e-9));
    for (std::size_t i = 0; i <= steps; ++i) {
      const double t = i == steps ? end : begin + static_cast<double>(i) / rate;
      m->apply(t, scene);
      for (std::size_t l = first; l < links.size(); ++l)
        links[l].path.add(t, scene.objects()[links[l].object].X_WB);
    }
  }
  return links;
}

/// Intervals in which the part's position is known.
std::vector<Interval> seenOf(const std::vector<double>& times, const std::vector<double>& uncertainty,
                             double& unseen) {
  std::vector<Interval> seen;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (std::isinf(uncertainty[i]) || std::isinf(uncertainty[i + 1])) {
      unseen += times[i + 1] - times[i];
      continue;
    }
    if (!seen.empty() && seen.back().t1 == times[i])
      seen.back().t1 = times[i + 1];
    else
      seen.push_back({times[i], times[i + 1]});
  }
  if (times.size() == 1 && !std::isinf(uncertainty[0])) seen.push_back({times[0], times[0]});
  return seen;
}

}  // namespace

std::vector<WorstPhase> worstPhases(session::Session& session, const WorstPhaseOptions& options) {
  const std::vector<double> times = session.frameTimes();
  const std::vector<LinkPath> links = linkPaths(session, options.rate);
  double program = 0.0;
  for (const LinkPath& link : links) program = std::max(program, link.path.end() - link.path.begin());
  struct Part {
    std::string name;
    std::size_t object;
    BodyPath path;
    std::vector<double> uncertainty;
  };
  std::vector<Part> parts;
  const scene::Scene& scene = session.scene();
  for (const auto& human : session.humans())
    for (const session::HumanDriver::Body& body : human->bodies()) {
      const scene::Object& object = scene.object(body.object);
      parts.push_back(
          {object.spec.name, body.object.index(), BodyPath(object.spec.structure->bounding_sphere), {}});
    }
  for (const double t : times) {
    session.applyMotion(t);
    for (Part& part : parts) {
      const scene::Object& object = scene.objects()[part.object];
      const double uncertainty = object.pose_uncertainty + options.calibration_error;
      part.uncertainty.push_back(uncertainty);
      part.path.add(t, object.X_WB, uncertainty);
    }
  }
  std::vector<WorstPhase> all;
  for (std::size_t p = 0; p < parts.size() && !links.empty(); ++p) {
    WorstPhase worst;
    worst.part = parts[p].name;
    const std::vector<Interval> seen = seenOf(times, parts[p].uncertainty, worst.unseen);
    Search search(session, parts[p].object, parts[p].path, links, options);
    if (!search.run(seen, worst)) return {};
    worst.phase = worst.t_robot - worst.t_person;
    if (program > 0.0) worst.phase -= program * std::floor(worst.phase / program);
    all.push_back(std::move(worst));
    if (options.progress) options.progress(p + 1, parts.size());
  }
  return all;
}

}  // namespace abstand::tune
