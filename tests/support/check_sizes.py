#!/usr/bin/env python3
"""No class of the product has more than 25 data members. Functions are measured by clang-tidy (.clang-tidy).

    check_sizes.py ROOT
"""
import pathlib
import re
import sys

MAX_MEMBERS = 25
FOLDERS = ("app", "core", "humanmodel", "include", "tracking", "ui")
NO_MEMBER = re.compile(
    r"^(using|friend|static|typedef|enum|class|struct|template|union|explicit|virtual|Q_\w+|constexpr|inline)\b")
FUNCTION = re.compile(r"\)\s*(const|noexcept|override|final|\s)*(:[^{]*)?\{\}$")


def without_comments(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r'"(\\.|[^"\\])*"', '""', text)


def statements(text, begin):
    """Declarations of a class whose body begins at `begin`; bodies of functions and initializers are left out."""
    depth, statement, found = 1, "", []
    for c in text[begin:]:
        if c == "{":
            depth += 1
            statement += "{" if depth == 2 else ""
        elif c == "}":
            depth -= 1
            if depth == 0:
                break
            statement += "}" if depth == 1 else ""
            if depth == 1 and FUNCTION.search(statement):
                statement = ""
        elif depth == 1 and c == ";":
            found.append(statement)
            statement = ""
        elif depth == 1:
            statement += c
    return found


def members(declarations):
    count = 0
    for text in declarations:
        text = re.sub(r"\b(public|private|protected|Q_SIGNALS|Q_SLOTS)\b\s*(Q_SLOTS)?\s*:", "", text).strip()
        if re.match(r"(struct|class)\b.*\}\s*\w+$", text, re.S):
            count += 1  # of a type without a name
            continue
        text = text.replace("{}", "")
        while re.search(r"<[^<>]*>", text):
            text = re.sub(r"<[^<>]*>", "", text)
        if text and "(" not in text and not NO_MEMBER.match(text):
            count += 1 + text.count(",")
    return count


def main(root):
    too_many, classes = [], 0
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*.[hc]pp")):
            text = without_comments(file.read_text(encoding="utf-8"))
            for match in re.finditer(r"\b(?:class|struct)\s+(?:\w+\s+)?(\w+)(?:\s+final)?\s*(?::[^{;()]*)?\{", text):
                classes += 1
                count = members(statements(text, match.end()))
                if count > MAX_MEMBERS:
                    too_many.append(f"{file.relative_to(root)}: {match[1]} has {count} members, expected at most "
                                    f"{MAX_MEMBERS}")
    for line in too_many:
        print(line)
    if classes < 500:
        print(f"found {classes} classes, expected more: is {root} the project?")
    if not too_many:
        print(f"{classes} classes have at most {MAX_MEMBERS} members")
    return 1 if too_many or classes < 500 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
