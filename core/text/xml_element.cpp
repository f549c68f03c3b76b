// Small parser of well-formed XML.
#include "core/text/xml_element.hpp"

#include <algorithm>

#include "core/text/text_lines.hpp"

namespace abstand::text {
namespace {

constexpr int kDeepest = 256;

class Parser {
 public:
  Parser(std::string_view document, const std::string& name) : document_(document), pos_{name, 1, 0} {}

  XmlElement run() {
    if (document_.find('\0') != std::string_view::npos) fail("found a zero byte, expected XML in UTF-8");
    if (document_.starts_with("\xef\xbb\xbf")) at_ = 3;
    skipToElement(nullptr);
    return element(1);
  }

 private:
  [[noreturn]] void fail(const std::string& message) {
    pos_.line += static_cast<int>(
        std::count(document_.begin(), document_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    throw ParseError(pos_, message);
  }

  bool startsWith(std::string_view s) const { return document_.substr(at_).starts_with(s); }

  void skipPast(std::string_view end) {
    const auto found = document_.find(end, at_);
    if (found == std::string_view::npos) fail("found no " + std::string(end) + " to the end of the file");
    at_ = found + end.size();
  }

  /// Advances to the next '<' of a tag past text (appended to `text`), comments and processing instructions.
  void skipToElement(std::string* text) {
    for (;;) {
      const auto tag = document_.find('<', at_);
      if (tag == std::string_view::npos) fail("the file ends, expected a tag");
      if (text) text->append(document_.substr(at_, tag - at_)).push_back(' ');
      at_ = tag;
      if (startsWith("<!--")) {
        skipPast("-->");
      } else if (startsWith("<?")) {
        skipPast("?>");
      } else if (startsWith("<![CDATA[")) {
        const auto begin = at_ + 9;
        skipPast("]]>");
        if (text) text->append(document_.substr(begin, at_ - 3 - begin));
      } else if (startsWith("<!")) {
        skipPast(">");
      } else {
        return;
      }
    }
  }

  std::string_view word() {
    const auto begin = at_;
    at_ = std::min(document_.find_first_of(" \t\r\n/>=<\"'", at_), document_.size());
    if (at_ == begin) fail("found " + inDoubleQuotes(document_.substr(at_, 1)) + ", expected a name");
    return document_.substr(begin, at_ - begin);
  }

  void skipBlank() { at_ = std::min(document_.find_first_not_of(" \t\r\n", at_), document_.size()); }

  void expect(char c) {
    if (at_ >= document_.size() || document_[at_] != c)
      fail("found " + inDoubleQuotes(document_.substr(at_, 1)) + ", expected '" + c + "'");
    ++at_;
  }

  /// Parses an element from its '<' to the end of its end tag.
  XmlElement element(int depth) {
    if (depth > kDeepest) fail("found elements nested more than " + std::to_string(kDeepest) + " deep");
    XmlElement e;
    for (; counted_ < at_; ++counted_) {
      if (document_[counted_] != '\n') continue;
      ++lines_;
      line_begin_ = counted_ + 1;
    }
    e.line = lines_;
    e.column = static_cast<int>(at_ - line_begin_) + 1;
    expect('<');
    e.name = word();
    for (;;) {
      skipBlank();
      if (startsWith("/>")) {
        at_ += 2;
        return e;
      }
      if (startsWith(">")) break;
      const auto key = word();
      skipBlank();
      expect('=');
      skipBlank();
      const char quote = startsWith("'") ? '\'' : '"';
      expect(quote);
      const auto begin = at_;
      skipPast(std::string_view(&quote, 1));
      e.attributes.emplace_back(key, document_.substr(begin, at_ - 1 - begin));
    }
    ++at_;
    for (;;) {
      skipToElement(&e.text);
      if (!startsWith("</")) {
        e.children.push_back(element(depth + 1));
        continue;
      }
      at_ += 2;
      if (const auto closed = word(); closed != e.name)
        fail("found </" + std::string(closed.substr(0, 40)) + ">, expected </" +
             std::string(e.name.substr(0, 40)) + ">");
      skipBlank();
      expect('>');
      return e;
    }
  }

  std::string_view document_;
  SourcePos pos_;
  std::size_t at_{0};
  std::size_t counted_{0}, line_begin_{0};
  int lines_{1};
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view key) const {
  for (const auto& [k, value] : attributes)
    if (k == key) return value;
  return {};
}

const XmlElement* XmlElement::child(std::string_view key) const {
  for (const auto& c : children)
    if (c.name == key) return &c;
  return nullptr;
}

XmlElement parseXml(std::string_view document, const std::string& name) {
  return Parser(document, name).run();
}

}  // namespace abstand::text
