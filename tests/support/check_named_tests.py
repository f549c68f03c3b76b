"""Checks that every test that a README of the tests names (`Suite.Test`) exists. usage: check_named_tests.py ROOT"""
import pathlib
import re
import sys

tests = pathlib.Path(sys.argv[1]) / "tests"
defined = {f"{suite}.{name}" for source in tests.rglob("*.cpp")
           for suite, name in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", source.read_text(encoding="utf-8"), re.M)}
missing = [f"{page}: found {name}, expected a test of that name" for page in sorted(tests.rglob("README.md"))
           for name in re.findall(r"`(\w+\.[A-Z]\w+)`", page.read_text(encoding="utf-8")) if name not in defined]
print("\n".join(missing) or f"{len(defined)} tests")
sys.exit(bool(missing))
