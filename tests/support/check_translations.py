#!/usr/bin/env python3
"""Whether ui/translations says every text of the window, and each with the placeholders of its source.

    check_translations.py PROJECT    exit 1 with a line for each fault; 77 where lupdate is missing
"""
import filecmp
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

PLACEHOLDER = re.compile(r"%(?:n|L?\d+)")


def faults_of(source, form):
    if not form:
        yield "no translation"
        return
    if sorted(PLACEHOLDER.findall(source)) != sorted(PLACEHOLDER.findall(form)):
        yield "other placeholders"
    if source.count("&") != form.count("&") and "<" not in source:
        yield "a mnemonic more or less"
    if (source[0].isspace(), source[-1].isspace()) != (form[0].isspace(), form[-1].isspace()):
        yield "other blanks at an end"


def faults_in(file):
    for context in ElementTree.parse(file).getroot().findall("context"):
        for message in context.findall("message"):
            source, translation = message.findtext("source"), message.find("translation")
            forms = [form.text for form in translation.findall("numerusform")] or [translation.text]
            faults = [] if translation.get("type") is None else [translation.get("type")]
            faults += [fault for form in forms for fault in faults_of(source, form)]
            for fault in faults:
                yield f"{file.name}: {context.findtext('name')}: {source!r}: {fault}"


def main(project):
    if shutil.which("lupdate") is None:
        print("no lupdate here")
        return 77
    folder = project / "ui/translations"
    files = sorted(folder.glob("*.ts"))
    faults = [] if files else [f"{folder}: no translations"]
    for file in files:
        faults += faults_in(file)
    with tempfile.TemporaryDirectory() as copy:
        for file in files:
            shutil.copy(file, copy)
        run = subprocess.run([project / "scripts/translations", copy], capture_output=True, text=True)
        if run.returncode != 0:
            faults.append(run.stderr)
        for file in files:
            fresh = pathlib.Path(copy) / file.name
            faults += [line for line in faults_in(fresh) if line not in faults]
            if not filecmp.cmp(file, fresh, shallow=False):
                faults.append(f"{file.name}: texts have changed, run scripts/translations")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
