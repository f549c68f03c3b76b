// The only file that includes yaml-cpp.
#include "core/config/yaml_document.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_map>

namespace abstand::config {
namespace {

SourcePos posOf(const std::string& file, const YAML::Mark& mark) {
  return mark.is_null() ? SourcePos{file} : SourcePos{file, mark.line + 1, mark.column + 1};
}

/// Builds the tree from the parser's events.
class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& file) : file_{file} {}

  std::optional<YamlNode> root;

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (root) throw ParseError(posOf(file_, mark), "found a second YAML document, expected one");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(leaf(YamlNode::Kind::kNothing, mark), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuseTag(mark, tag);
    YamlNode node = leaf(YamlNode::Kind::kScalar, mark);
    node.quoted = tag == "!";
    node.text = value;
    add(std::move(node), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto it = anchored_.find(anchor);
    if (it == anchored_.end())
      throw ParseError(posOf(file_, mark), "found a recursive alias, expected one of an earlier value");
    if (open_.size() + it->second.depth > kMaxYamlDepth) throw tooDeep(mark);
    count(posOf(file_, mark), it->second.nodes);
    add(it->second.node, 0);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    refuseTag(mark, tag);
    open(leaf(YamlNode::Kind::kList, mark), mark, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    refuseTag(mark, tag);
    open(leaf(YamlNode::Kind::kMap, mark), mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    YamlNode node;
    YAML::anchor_t anchor{0};
    std::set<std::string> keys;
  };
  struct Anchored {
    YamlNode node;
    int nodes{0};
    std::size_t depth{0};
  };

  YamlNode leaf(YamlNode::Kind kind, const YAML::Mark& mark) {
    count(posOf(file_, mark), 1);
    YamlNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    node.column = mark.column + 1;
    return node;
  }

  void count(const SourcePos& pos, int nodes) {
    nodes_ += nodes;
    if (nodes_ > kMaxYamlNodes)
      throw ParseError(pos, "found more than " + std::to_string(kMaxYamlNodes) +
                                " values (aliases written out), expected fewer");
  }

  ParseError tooDeep(const YAML::Mark& mark) const {
    return {posOf(file_, mark),
            "found more than " + std::to_string(kMaxYamlDepth) + " levels of lists and maps, expected fewer"};
  }

  void refuseTag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!")
      throw ParseError(posOf(file_, mark),
                       "found the YAML tag `" + tag + "`, expected a value without a tag");
  }

  void open(YamlNode node, const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() >= static_cast<std::size_t>(kMaxYamlDepth)) throw tooDeep(mark);
    open_.push_back({std::move(node), anchor, {}});
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    add(std::move(done.node), done.anchor);
  }

  static int nodesOf(const YamlNode& node) {
    int n = 1 + static_cast<int>(node.keys.size());
    for (const auto& item : node.items) n += nodesOf(item);
    return n;
  }
  static std::size_t depthOf(const YamlNode& node) {
    std::size_t deepest = 0;
    for (const auto& item : node.items) deepest = std::max(deepest, depthOf(item));
    return node.kind == YamlNode::Kind::kList || node.kind == YamlNode::Kind::kMap ? deepest + 1 : 0;
  }

  void add(YamlNode node, YAML::anchor_t anchor) {
    if (anchor) {
      const int nodes = nodesOf(node);
      count({file_, node.line, node.column}, nodes);  // the copy kept for aliases
      anchored_[anchor] = {node, nodes, depthOf(node)};
    }
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Open& parent = open_.back();
    YamlNode& into = parent.node;
    const bool is_key = into.kind == YamlNode::Kind::kMap && into.keys.size() == into.items.size();
    if (!is_key) {
      // The parser reports a missing value at the next token, often on a later line; the position of its key
      // is used.
      if (node.kind == YamlNode::Kind::kNothing && into.kind == YamlNode::Kind::kMap &&
          node.line != into.keys.back().line) {
        node.line = into.keys.back().line;
        node.column = into.keys.back().column;
      }
      into.items.push_back(std::move(node));
      return;
    }
    const SourcePos pos{file_, node.line, node.column};
    if (node.kind != YamlNode::Kind::kScalar)
      throw ParseError(pos, "found a key that is not a scalar, expected a name");
    if (!parent.keys.insert(node.text).second)
      throw ParseError(pos, "found the key `" + node.text + "` a second time, expected it once");
    into.keys.push_back({std::move(node.text), node.line, node.column});
  }

  const std::string& file_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, Anchored> anchored_;
  int nodes_{0};
};

void refuseControlCharacters(const std::string& text, const std::string& file) {
  int line = 1, column = 1;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f)
      throw ParseError({file, line, column},
                       "found a control character (code " + std::to_string(byte) + "), expected a YAML text");
    if (c == '\n') {
      ++line;
      column = 1;
    } else {
      ++column;
    }
  }
}

}  // namespace

YamlNode parseYaml(const std::string& text, const std::string& file) {
  if (text.size() > kMaxYamlBytes)
    throw ParseError({file}, "found " + std::to_string(text.size()) + " bytes, expected at most " +
                                 std::to_string(kMaxYamlBytes));
  refuseControlCharacters(text, file);
  TreeBuilder builder(file);
  try {
    std::istringstream in(text);
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& e) {
    throw ParseError(posOf(file, e.mark), "found invalid YAML (" + e.msg + "), expected a YAML text");
  }
  if (!builder.root) throw ParseError({file, 1, 1}, "found no YAML value, expected a map");
  return std::move(*builder.root);
}

}  // namespace abstand::config
