#include "core/robot_file/urdf_tree.hpp"

#include <algorithm>
#include <unordered_map>

#include "core/base/error.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::robot_file {
namespace {

using text::inDoubleQuotes;

/// Index of an item on a cycle of the links `next` (-1: end), or -1.
int onRing(const std::vector<int>& next) {
  std::vector<int> seen_from(next.size(), -1);
  for (std::size_t start = 0; start < next.size(); ++start)
    for (int i = static_cast<int>(start); i >= 0; i = next[static_cast<std::size_t>(i)]) {
      int& seen = seen_from[static_cast<std::size_t>(i)];
      if (seen == static_cast<int>(start)) return i;
      if (seen >= 0) break;
      seen = static_cast<int>(start);
    }
  return -1;
}

template <class Item>
class Index {
 public:
  explicit Index(const std::vector<Item>& items) {
    for (const auto& item : items) {
      index_.emplace(item.name, static_cast<int>(names_.size()));
      names_.push_back(item.name);
    }
  }
  int at(const std::string& name) const {
    const auto it = index_.find(name);
    return it == index_.end() ? -1 : it->second;
  }
  std::string hint(const std::string& name) const {
    const std::string near = nearestName(name, names_);
    return near.empty() ? "" : "did you mean " + text::inDoubleQuotes(near) + "?";
  }

 private:
  std::unordered_map<std::string, int> index_;
  std::vector<std::string> names_;
};

void checkLinks(const UrdfText& urdf, const std::string& file) {
  const Index links(urdf.links);
  std::vector<int> parent(urdf.links.size(), -1);
  std::vector<bool> is_child(urdf.links.size(), false);
  for (const auto& joint : urdf.joints) {
    const SourcePos pos{file, joint.place.line, joint.place.column};
    for (const auto& name : {joint.parent, joint.child})
      if (links.at(name) < 0)
        throw ParseError(pos,
                         "found the joint " + text::inDoubleQuotes(joint.name) + " at a link " +
                             text::inDoubleQuotes(name) + " that is not there, expected one of the file",
                         links.hint(name));
    const auto child = static_cast<std::size_t>(links.at(joint.child));
    if (is_child[child])
      throw ParseError(pos,
                       "found the link " + text::inDoubleQuotes(joint.child) +
                           " as the child of a second joint, expected a tree: one joint per child",
                       "a closed kinematic chain cannot be described by a URDF");
    is_child[child] = true;
    parent[child] = links.at(joint.parent);
  }
  if (const int i = onRing(parent); i >= 0) {
    const auto& link = urdf.links[static_cast<std::size_t>(i)];
    throw ParseError(
        {file, link.place.line, link.place.column},
        "found the link " + text::inDoubleQuotes(link.name) + " among its own descendants, expected a tree");
  }
  const auto root = std::find(is_child.begin(), is_child.end(), false);
  const auto second = std::find(root + 1, is_child.end(), false);
  if (second == is_child.end()) return;
  const auto& link = urdf.links[static_cast<std::size_t>(second - is_child.begin())];
  throw ParseError(
      {file, link.place.line, link.place.column},
      "found " + text::inDoubleQuotes(urdf.links[static_cast<std::size_t>(root - is_child.begin())].name) +
          " and " + text::inDoubleQuotes(link.name) + " without a parent, expected one root link");
}

void checkMimics(const UrdfText& urdf, const std::string& file) {
  const Index joints(urdf.joints);
  std::vector<int> leader(urdf.joints.size(), -1);
  for (std::size_t i = 0; i < urdf.joints.size(); ++i) {
    const auto& joint = urdf.joints[i];
    if (joint.mimic.empty()) continue;
    const SourcePos pos{file, joint.place.line, joint.place.column};
    leader[i] = joints.at(joint.mimic);
    if (leader[i] < 0)
      throw ParseError(pos,
                       "found the joint " + text::inDoubleQuotes(joint.name) + " that mimics " +
                           text::inDoubleQuotes(joint.mimic) + ", expected a joint of the file",
                       joints.hint(joint.mimic));
    const auto& type = urdf.joints[static_cast<std::size_t>(leader[i])].type;
    if (type == "floating" || type == "planar")
      throw ParseError(pos, "found the joint " + text::inDoubleQuotes(joint.name) + " that mimics a " + type +
                                " joint, expected one with a single value");
  }
  if (const int i = onRing(leader); i >= 0) {
    const auto& joint = urdf.joints[static_cast<std::size_t>(i)];
    throw ParseError({file, joint.place.line, joint.place.column},
                     "found the joint " + text::inDoubleQuotes(joint.name) +
                         " that mimics itself, expected no ring of mimic joints");
  }
}

}  // namespace

void checkUrdfTree(const UrdfText& urdf, const std::string& file) {
  checkLinks(urdf, file);
  checkMimics(urdf, file);
}

}  // namespace abstand::robot_file
