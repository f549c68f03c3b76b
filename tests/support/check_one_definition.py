"""One definition rule: no type and no inline or template function of the same scope and name in two files.

Two classes of one name with external linkage compile, link and then run each other's destructors. Neither the
compiler nor the linker says so; this reads all sources (no compiler, under a second) and reports every type, and
every inline or template function of the same parameters, that two files define in the same named scope. Unnamed
namespaces and function bodies have no linkage and are left out.

    check_one_definition.py FOLDER...      exit 1 with one line for each clash
    check_one_definition.py --self-test
"""
import re
import sys
from pathlib import Path

TOKEN = re.compile(r'R"(?P<raw>[^()\\\s]{0,16})\(.*?\)(?P=raw)"'
                   r'|"(?:\\.|[^"\\\n])*"|//(?:\\\n|[^\n])*|/\*.*?\*/'
                   r"|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'"
                   r'|^[ \t]*\#(?:\\\n|[^\n])*'
                   r"|[A-Za-z_]\w*|\d[\w.']*|::|\[\[|\]\]|[^\s\w]", re.S | re.M)
TYPES = ("struct", "class", "union", "enum")


def tokens(text):
    for match in TOKEN.finditer(text):
        token = match.group()
        if token.startswith(("//", "/*")) or token.lstrip().startswith("#"):
            continue
        yield ('""' if token.startswith(('"', "R\"", "'")) else token), match.start()


def skip(head, i, opening, closing):
    """Index behind the bracket that closes the one at i."""
    depth = 0
    while i < len(head):
        depth += (head[i] == opening) - (head[i] == closing)
        i += 1
        if depth == 0:
            break
    return i


def qualified(head, i):
    """A name with its qualifiers and template arguments from i on, and the index behind it."""
    name = ""
    while i < len(head) and (re.match(r"[A-Za-z_]", head[i]) or head[i] in ("::", "<")):
        if head[i] == "final" or (name and head[i] not in ("::", "<") and not name.endswith("::")):
            break
        end = skip(head, i, "<", ">") if head[i] == "<" else i + 1
        name += "".join(head[i:end])
        i = end
    return name, i


def parameters(head, i):
    """The types of the parameters in the parentheses at i, without names and default values."""
    out, current, depth = [], [], 0
    for token in head[i + 1:skip(head, i, "(", ")") - 1] + [","]:
        depth += (token in "(<[{") - (token in ")>]}")
        if token != "," or depth > 0:
            current.append(token)
            continue
        if "=" in current:
            current = current[:current.index("=")]
        if len(current) > 1 and re.match(r"[A-Za-z_]", current[-1]) and current[-2] not in ("::", "const"):
            current.pop()
        out.append(" ".join(current))
        current = []
    return ", ".join(out)


def definition(head):
    """What the tokens before an opening brace define: (kind, name); kind is namespace, type, function or other."""
    i = 1 if head[:1] == ["inline"] else 0
    if head[i:i + 1] == ["namespace"]:
        return "namespace", qualified(head, i + 1)[0]
    i, template = 0, False
    while head[i:i + 1] == ["template"]:
        template = True
        i = skip(head, i + 1, "<", ">")
    if head[i:i + 1] == ["requires"]:
        i = next((k for k in range(i, len(head)) if head[k] in TYPES), i)
    if i < len(head) and head[i] in TYPES:
        i += 2 if head[i:i + 2] in (["enum", "class"], ["enum", "struct"]) else 1
        while i < len(head) and head[i] in ("[[", "alignas"):
            i = skip(head, i, "[[", "]]") if head[i] == "[[" else skip(head, i + 1, "(", ")")
        name, i = qualified(head, i)
        if name and (i == len(head) or head[i] in (":", "final")):
            return "type", name
        return "other", ""
    if "(" not in head or "=" in head[:head.index("(")]:
        return "other", ""
    at = head.index("(")
    first = max((k for k in range(at) if head[k] == "operator"), default=at - 1)
    name = "".join(head[first:at])
    if first > 0 and head[first - 1] == "::":
        return "other", ""  # a member or a function declared elsewhere
    inline = template or "inline" in head[:at] or "constexpr" in head[:at]
    if inline and "static" not in head[:at]:
        return "function", f"{name}({parameters(head, at)})"
    return "other", ""


def definitions(text):
    """Yields (qualified name, offset) of what has external linkage and may be defined in several files."""
    scopes, head, parens, start = [], [], 0, 0
    for token, offset in tokens(text):
        if token == "{" and parens == 0:
            kind, name = definition(head)
            visible = all(k in ("namespace", "type") and n for k, n in scopes)
            if visible and name and (kind == "type" or (kind == "function" and all(k == "namespace" for k, _ in scopes))):
                yield "::".join([n for _, n in scopes] + [name]), start
            scopes.append((kind, name))
            head = []
        elif token == "}" and parens == 0:
            if scopes:
                scopes.pop()
            head = []
        elif token == ";" and parens == 0:
            head = []
        elif token == ":" and head and head[-1] in ("public", "private", "protected"):
            head.pop()
        else:
            parens += (token == "(") - (token == ")")
            if not head:
                start = offset
            head.append(token)


def clashes(files):
    """Lines for what two of the files {name: text} define."""
    found = {}
    for name, text in sorted(files.items()):
        for what, offset in definitions(text):
            line = text.count("\n", 0, offset) + 1
            places = found.setdefault(what, {})
            places.setdefault(name, line)  # the second of one file: the compiler's own business, or #else
    return [f"{' and '.join(f'{n}:{l}' for n, l in places.items())}: both define {what}; rename one, or put it into an "
            "unnamed namespace" for what, places in sorted(found.items()) if len(places) > 1], len(found)


def self_test():
    one = """
namespace abstand {
// struct Commented {
struct Links { std::vector<int> a; const char* s = "struct InText {"; };
namespace { struct Hidden { int a; }; }
class Declared;
template <class T> class [[nodiscard]] Box final : public Base<T> { struct Inner {}; };
inline double half(double x = 1.0) { struct Local {}; return 0.5 * x; }
enum class Kind : std::uint8_t { kA };
struct stat info{};
static inline int own(int) { return 1; }
template <> struct Traits<int> {};
}
"""
    two = """
namespace abstand {
class Links { ~Links() {} };
namespace { struct Hidden { double a; }; }
struct Commented { int InText; };
template <class T> class Box {};
inline double half(double y) { return y / 2; }
inline float half(float y) { return y / 2; }
enum Kind { kB };
struct Local {};
static inline int own(int) { return 2; }
struct stat other{};
template <> struct Traits<double> {};
namespace inner { struct Links {}; struct Inner {}; }
}
"""
    found, _ = clashes({"one.cpp": one, "two.cpp": two})
    names = [line.split("both define ")[1].split(";")[0] for line in found]
    expected = ["abstand::Box", "abstand::Kind", "abstand::Links", "abstand::half(double)"]
    assert names == expected, f"found {names}, expected {expected}"
    assert found[2].startswith("one.cpp:4 and two.cpp:3: "), found[2]
    assert clashes({"one.cpp": one})[0] == []


def main(arguments):
    self_test()
    if arguments == ["--self-test"]:
        return 0
    files = {}
    for folder in map(Path, arguments):
        for path in folder.rglob("*"):
            if path.suffix in (".hpp", ".cpp", ".inl"):
                files[str(path)] = path.read_text(encoding="utf-8")
    found, count = clashes(files)
    if count < 100:
        found.append(f"only {count} definitions found below {' '.join(arguments)}; is this the project?")
    print("\n".join(found) if found else f"{count} definitions in {len(files)} files, each in one file alone")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
