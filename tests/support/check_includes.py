"""Checks the order of modules and the fences around libraries: check_includes.py ROOT.

Every `#include "..."` of product code stays within what modules.txt beside this file allows its module.
Every wrapped library is named in FENCES with the only files that may include it."""
import pathlib
import re
import sys

TOP = ("core", "humanmodel", "tracking", "ui", "app")

# What an include begins with, and the files that may include it. Everything else is the C++ library, POSIX or Eigen.
FENCES = [
    (r"CLI/", r"app/cli/.*"),
    (r"nlohmann/", r"app/cli/.*|(app/bench|app/results|app/serve|tracking/table)/.*\.cpp"),
    (r"Q[A-Z]|Qt|vtk|QVTK|qwt", r"(ui|app/studio)/.*"),
    (r"assimp/", r"core/mesh_file/.*\.cpp"),
    (r"libqhull", r"core/geometry/convex_hull\.cpp"),
    (r"xxhash", r"core/base/content_hash\.cpp"),
    (r"yaml-cpp/", r"core/config/yaml_document\.cpp"),
    (r"urdf_|console_bridge", r"core/robot_file/.*\.cpp"),
    (r"ode/", r"core/physics/.*\.cpp"),
    (r"opencv2/", r"tracking/depth/calibration/.*\.cpp|app/studio/avi_file\.cpp"),
    (r"pcl/", r"tracking/depth/(people/floor_consensus|calibration/cloud_registration)\.cpp"),
    (r"libfreenect", r"tracking/depth/live/.*\.cpp"),
    (r"zlib", r"tracking/kinect/.*\.cpp|tracking/depth/formats/png_codec\.cpp|app/results/mcap_writer\.cpp"),
    (r"png\.h", r"tracking/depth/formats/png_codec\.cpp"),
    (r"tiffio", r"tracking/depth/formats/tiff_codec\.cpp"),
    (r"zstd", r"app/results/mcap_writer\.cpp"),
    (r"sqlite3", r"app/results/.*\.cpp"),
    (r"hdf5", r"app/hdf5/.*"),
    (r"libdeflate", r"app/hdf5/chunk_encoder\.cpp"),
    (r"pybind11/", r"app/python/.*"),
]
# Intrinsics and what the system brings.
SYSTEM = re.compile(r"[a-z0-9_]+$|Eigen/|(immintrin|emmintrin|dlfcn|fcntl|malloc|poll|sched|unistd|time)\.h$|(sys|arpa|netinet)/")


def modules(table):
    """The table as {module: modules it may include}, and what is wrong with it."""
    allowed, errors = {}, []
    for number, line in enumerate(table.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        module, _, names = line.partition(":")
        for name in names.split():
            if name not in allowed:
                errors.append(f"{table}:{number}: {module} may include {name}, which is not above it")
        allowed[module] = {module, *names.split()}
    return allowed, errors


def check_file(root, path, allowed):
    """What is wrong with the includes of a file."""
    name = path.relative_to(root).as_posix()
    module = path.parent.relative_to(root).as_posix()
    text = path.read_text()
    errors = []
    # Only these notice every failed write, and replace no device.
    if re.search(r"std::(cout|ofstream)\b", text):
        errors.append(f"{name}: outputs go through core/base/output_file and core/base/standard_output")
    for own, other in re.findall(r'^#include (?:"([^"]+)"|<([^>]+)>)', text, re.M):
        if own.startswith("abstand/"):
            if not (root / "include" / own).exists():
                errors.append(f"{name}: {own} is not in include/")
            elif not module.endswith("facade"):
                errors.append(f"{name}: {own} stays within the facades and who uses the library")
            continue
        if own:
            target = own.rpartition("/")[0]
            if not (root / own).exists():
                if not own.startswith(("app/cli/version", "app/tune/result_fingerprint", "core/store/engine_fingerprint")):
                    errors.append(f"{name}: {own} is not in the project")
            elif target not in allowed.get(module, set()):
                errors.append(f"{name}: {module} may not include {target} (tests/support/modules.txt)")
            continue
        for begin, where in FENCES:
            if re.match(begin, other):
                if not re.fullmatch(where, name):
                    errors.append(f"{name}: <{other}> stays within {where}")
                break
        else:
            if not SYSTEM.match(other):
                errors.append(f"{name}: <{other}> has no fence in tests/support/check_includes.py")
    return errors


def check_public(root):
    """What is wrong with the public headers: they know each other, Eigen and the C++ library."""
    headers = sorted((root / "include").rglob("*"))
    return [f"{p.relative_to(root)}: a public header may not include {own or other}"
            for p in headers if p.is_file()
            for own, other in re.findall(r'^#include (?:"([^"]+)"|<([^>]+)>)', p.read_text(), re.M)
            if not re.match(r"abstand/[a-z_]+\.hpp$", own) and not re.match(r"[a-z0-9_]+$|Eigen/", other)]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    allowed, errors = modules(pathlib.Path(__file__).parent / "modules.txt")
    files = [p for top in TOP for p in sorted((root / top).rglob("*")) if p.suffix in (".hpp", ".cpp", ".inl")]
    folders = {p.parent.relative_to(root).as_posix() for p in files}
    errors += [f"{m} is not in tests/support/modules.txt" for m in sorted(folders - set(allowed))]
    errors += [f"tests/support/modules.txt: {m} has no sources" for m in sorted(set(allowed) - folders)]
    errors += [f"{f}/README.md is missing" for f in sorted(folders) if not (root / f / "README.md").exists()]
    errors += check_public(root)
    for path in files:
        errors += check_file(root, path, allowed)
    print("\n".join(errors) or f"{len(files)} files of {len(folders)} modules follow the order")
    return 1 if errors or not files else 0


if __name__ == "__main__":
    sys.exit(main())
