// Margins of the window's rows as a set of margins that the command line reads, and back.
#pragma once

#include <QMap>
#include <optional>
#include <string>
#include <vector>

#include "core/margin/margin_rules.hpp"
#include "core/view/snapshot.hpp"

namespace abstand::ui {

/// Which rows a set names: parts of people ("hand_left", the same for all people) and links of robots, of
/// the pairs of both that are checked.
class MarginSet {
 public:
  explicit MarginSet(const view::SceneOutline& outline);

  /// There is no pair of a person and a robot.
  bool empty() const { return pairs_.empty(); }
  std::vector<std::string> partNames() const;

  /// `margins`: m, of each object. Of several people the largest margin of a part.
  margin::MarginRules rules(const std::vector<double>& margins) const;
  /// Several people have different margins for the same part, which a set cannot say.
  bool differs(const std::vector<double>& margins) const;

  /// m, by object: rows whose sums are the margins of the pairs, apart from those of classes; empty where the
  /// set has only these. Throws UsageError for a name that the scene
  /// does not have, a pair without a margin, and for margins that no sum of two rows can be.
  QMap<int, double> margins(const margin::MarginRules& set) const;

 private:
  struct Body {
    std::string name;
    std::vector<int> objects;
  };
  struct Pair {
    std::size_t part, link;
  };
  using Sums = std::vector<std::optional<double>>;  ///< m
  bool takeOwn(const margin::MarginRules& rules, Sums& parts, Sums& links) const;
  void solve(const std::vector<double>& wanted, Sums& parts, Sums& links) const;
  std::size_t indexOf(std::vector<Body>& bodies, const std::string& name, int object);
  void checkNames(const margin::MarginRules& rules) const;
  double marginOf(const margin::MarginRules& rules, const Pair& pair) const;

  std::vector<Body> parts_, links_;
  std::vector<Pair> pairs_;
};

}  // namespace abstand::ui
