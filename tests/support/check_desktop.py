"""The desktop entry names an icon and MIME types that are installed beside it.

check_desktop.py FOLDER      that of the three files
"""
import configparser
import pathlib
import sys
import xml.etree.ElementTree as xml

folder = pathlib.Path(sys.argv[1])
entry = configparser.ConfigParser(delimiters="=")
entry.optionxform = str
entry.read(folder / "abstand.desktop", encoding="utf-8")
keys = entry["Desktop Entry"]
space = "{http://www.freedesktop.org/standards/shared-mime-info}"
described = {t.get("type"): t for t in xml.parse(folder / "abstand-studio.xml").getroot().iter(f"{space}mime-type")}
named = [name for name in keys["MimeType"].split(";") if name]
wrong = [f"{name}: found no description" for name in named if name not in described]
wrong += [f"{name}: is described and not opened" for name in described if name not in named]
wrong += [f"{name}: found neither glob nor magic" for name, t in described.items()
          if t.find(f"{space}glob") is None and t.find(f"{space}magic") is None]
icon = folder / f"{keys['Icon']}.svg"
if xml.parse(icon).getroot().tag != "{http://www.w3.org/2000/svg}svg":
    wrong.append(f"{icon}: found no SVG picture")
if not named:
    wrong.append("MimeType: found no type, expected those that the program opens")
sys.exit("\n".join(wrong) or None)
