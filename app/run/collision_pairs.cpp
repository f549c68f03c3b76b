#include "app/run/collision_pairs.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/study/pairs_file.hpp"

namespace abstand::run {
namespace {

using IndexPair = std::pair<int, int>;

struct Study {
  std::vector<study::StudyMechanism> mechanisms;
  std::vector<study::StudyBody> bodies;
  std::vector<int> objects;              ///< object index of each body
  std::vector<std::string> joint_names;  ///< for each dof
};

/// A name without commas, semicolons and equal signs.
std::string fitting(std::string name) {
  for (char& c : name)
    if (c == ',' || c == ';' || c == '=' || c == '"') c = '_';
  return name;
}

Study studyOf(const session::Session& session) {
  Study study;
  const auto& objects = session.scene().objects();
  std::vector<study::StudyBody> by_object(objects.size());
  std::vector<bool> takes_part(objects.size(), false);
  for (std::size_t m = 0; m < session.mechanisms().size(); ++m) {
    const session::MechanismDriver& driver = *session.mechanisms()[m];
    study.mechanisms.push_back({&driver.mechanism(), driver.X_WB()});
    std::vector<std::string> names(static_cast<std::size_t>(driver.dof()));
    for (const auto& f : driver.mechanism().frames)
      if (f.dof >= 0 && (!f.mimic || names[static_cast<std::size_t>(f.dof)].empty()))
        names[static_cast<std::size_t>(f.dof)] = f.joint.empty() ? f.name : f.joint;
    for (const auto& name : names)
      study.joint_names.push_back(fitting(
          session.mechanisms().size() > 1 ? session.description().mechanisms[m].name + "/" + name : name));
    for (const auto& link : driver.links()) {
      const std::size_t i = link.object->index();
      by_object[i] = {objects[i].spec.structure, static_cast<int>(m), link.frame, link.X_FL};
      takes_part[i] = true;
    }
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].spec.group == "objects") {
      by_object[i] = {objects[i].spec.structure, -1, -1, objects[i].X_WB};
      takes_part[i] = true;
    }
    if (!takes_part[i]) continue;
    study.objects.push_back(static_cast<int>(i));
    study.bodies.push_back(by_object[i]);
  }
  return study;
}

/// Pairs of objects removed by the user.
std::set<IndexPair> userPairs(const session::Session& session) {
  std::set<IndexPair> pairs;
  const auto add = [&](const std::string& a, const std::string& b) {
    ObjectId i(0), j(0);
    if (!session.scene().find(a, &i) || !session.scene().find(b, &j)) return;
    pairs.insert(std::minmax(static_cast<int>(i.index()), static_cast<int>(j.index())));
  };
  for (const auto& [a, b] : session.description().pairs.exclude) add(a, b);
  for (const auto& p : session.description().pairs.dropped)
    if (p.reason.starts_with("user") || p.reason.starts_with("User")) add(p.a, p.b);
  return pairs;
}

std::string postureText(const study::StudiedPair& pair, const std::vector<std::string>& names) {
  std::string text;
  for (const int dof : pair.dofs)
    if (!pair.posture.empty())
      text += (text.empty() ? "" : ";") + names[static_cast<std::size_t>(dof)] + "=" +
              formatDouble(pair.posture[static_cast<std::size_t>(dof)]);
  return text;
}

}  // namespace

std::vector<CollisionPair> collisionPairs(const session::Session& session,
                                          const study::StudyOptions& options) {
  const Study study = studyOf(session);
  const std::set<IndexPair> adjacent(session.adjacentPairs().begin(), session.adjacentPairs().end());
  const std::set<IndexPair> user = userPairs(session);
  std::vector<CollisionPair> out;
  std::vector<IndexPair> open;
  std::vector<std::size_t> open_at;
  const int n = static_cast<int>(study.bodies.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      if (study.bodies[static_cast<std::size_t>(a)].mechanism < 0 &&
          study.bodies[static_cast<std::size_t>(b)].mechanism < 0)
        continue;
      CollisionPair pair;
      pair.study.a = study.objects[static_cast<std::size_t>(a)];
      pair.study.b = study.objects[static_cast<std::size_t>(b)];
      const IndexPair objects(pair.study.a, pair.study.b);
      if (user.contains(objects)) {
        pair.study.verdict = study::PairVerdict::kUser;
      } else if (adjacent.contains(objects)) {
        pair.study.verdict = study::PairVerdict::kAdjacent;
      } else {
        open.emplace_back(a, b);
        open_at.push_back(out.size());
      }
      out.push_back(std::move(pair));
    }
  std::vector<study::StudiedPair> studied = study::studyPairs(study.mechanisms, study.bodies, open, options);
  for (std::size_t i = 0; i < open.size(); ++i) {
    CollisionPair& pair = out[open_at[i]];
    const int a = pair.study.a, b = pair.study.b;
    pair.posture = postureText(studied[i], study.joint_names);
    pair.study = std::move(studied[i]);
    pair.study.a = a;
    pair.study.b = b;
  }
  return out;
}

std::string pairsText(const session::Session& session, const std::vector<CollisionPair>& pairs,
                      const study::StudyOptions& options) {
  std::map<study::PairVerdict, int> count;
  for (const auto& p : pairs) ++count[p.study.verdict];
  std::string text =
      "# Collision pairs found by sampling the joint space. Written by `abstand pairs`.\n"
      "# A scene that reads this file checks the pairs marked sometimes, and none marked adjacent, never, "
      "always or user.\n"
      "# Sampling proves nothing: distance is the minimum found, at the given posture.\n"
      "# samples " +
      std::to_string(options.samples) + ", seed " + std::to_string(options.seed) + ", searches " +
      std::to_string(options.searches) + ", clearance " + formatDouble(options.clearance) + " m\n#";
  for (const auto& [verdict, n] : count) text += " " + study::verdictName(verdict) + " " + std::to_string(n);
  text += "\nverdict,a,b,distance,bound,samples,hits,search,posture\n";
  const auto& objects = session.scene().objects();
  for (const auto& p : pairs) {
    const study::StudiedPair& s = p.study;
    text += study::verdictName(s.verdict) + "," + objects[static_cast<std::size_t>(s.a)].spec.name + "," +
            objects[static_cast<std::size_t>(s.b)].spec.name + ",";
    if (s.samples > 0)
      text += formatDouble(s.distance) + "," + formatDouble(s.bound) + "," + std::to_string(s.samples) + "," +
              std::to_string(s.hits) + "," + (s.by_search ? "found" : "") + "," + p.posture;
    else
      text += ",,,,,";
    text += '\n';
  }
  return text;
}

robot_file::Srdf srdfOf(const session::Session& session, const std::vector<CollisionPair>& pairs) {
  if (session.mechanisms().size() != 1)
    throw UsageError("--srdf: found " + std::to_string(session.mechanisms().size()) +
                     " mechanisms, expected one");
  const session::MechanismDriver& driver = *session.mechanisms().front();
  std::map<int, int> frame_of;
  for (const auto& link : driver.links()) frame_of[static_cast<int>(link.object->index())] = link.frame;
  // First unchecked verdict of the bodies of two links; null if a pair of their bodies is checked.
  std::map<IndexPair, const study::StudiedPair*> links;
  for (const auto& p : pairs) {
    const auto a = frame_of.find(p.study.a), b = frame_of.find(p.study.b);
    if (a == frame_of.end() || b == frame_of.end() || a->second == b->second) continue;
    const IndexPair key = std::minmax(a->second, b->second);
    const auto at = links.emplace(key, &p.study).first;
    if (p.study.verdict == study::PairVerdict::kSometimes ||
        p.study.verdict == study::PairVerdict::kUndecided)
      at->second = nullptr;
  }
  robot_file::Srdf srdf;
  srdf.robot = driver.mechanism().name;
  const auto nameOf = [&](int frame) {
    return frame < 0 ? std::string("0") : driver.mechanism().frames[static_cast<std::size_t>(frame)].name;
  };
  for (const auto& [key, study] : links) {
    if (!study) continue;
    std::string reason = study::verdictName(study->verdict);
    reason.front() = static_cast<char>(reason.front() - 'a' + 'A');
    srdf.disabled.push_back({nameOf(key.first), nameOf(key.second), reason, {}});
  }
  return srdf;
}

}  // namespace abstand::run
