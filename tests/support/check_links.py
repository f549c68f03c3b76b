"""Checks that links between the pages of the project lead somewhere: files, and headings of Markdown pages. usage: check_links.py ROOT"""
import functools
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()


@functools.cache
def anchors(page):
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


pages = [page for page in root.rglob("*.md") if not page.relative_to(root).parts[0].startswith(("build", "."))]
problems = []
for page in pages:
    for target, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([\w\-]+))?\)", page.read_text(encoding="utf-8")):
        if "://" in target:
            continue
        to = (page.parent / target).resolve() if target else page
        if not to.exists():
            problems.append(f"{page.relative_to(root)}: found a link to {target}, expected an existing file")
        elif anchor and to.suffix == ".md" and anchor not in anchors(to):
            problems.append(f"{page.relative_to(root)}: found a link to #{anchor}, expected a heading of {to.name}")
print("\n".join(problems) or f"{len(pages)} pages")
sys.exit(bool(problems) or not pages)
