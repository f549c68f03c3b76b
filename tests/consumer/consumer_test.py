"""A project outside the tree finds the installed library, builds the four examples and runs them.

consumer_test.py CMAKE BUILD SOURCE VERSION      exit 77 where the libraries are not built
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# What an engine alone never needs: neither when it is looked for nor when it runs.
OTHERS = ("ODE", "yaml-cpp", "Qt5", "PCL", "VTK", "HDF5", "urdfdom", "OpenCV", "nlohmann_json")
FOREIGN = re.compile(r"libode|yaml|libQt|pcl|libvtk|hdf5|urdfdom|opencv")


def run(*command, **more):
    done = subprocess.run([str(c) for c in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def expect(condition, text):
    if not condition:
        sys.exit(text)


def main():
    cmake, build, source, version = sys.argv[1], *(pathlib.Path(a).resolve() for a in sys.argv[2:4]), sys.argv[4]
    names = ("engine", "mechanism", "human", "tracking", "scene")
    if not all(list(build.glob(f"**/libabstand_facade_{n}.*")) for n in names):
        print("the libraries are not built")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        prefix = place / "a prefix"
        run(cmake, "--install", build, "--prefix", prefix, "--component", "dev")
        # Only what was promised is there.
        headers = sorted(p.name for p in (prefix / "include").rglob("*") if p.is_file())
        expect(headers == sorted(p.name for p in (source / "include/abstand").glob("*.hpp")), f"headers: {headers}")
        shutil.copytree(next((prefix / "share/doc").glob("*/examples")), place / "examples")
        # Exported files name no folder of the build or the source.
        for file in prefix.rglob("*.cmake"):
            expect(str(source) not in file.read_text(), f"{file} names {source}")
        env = dict(os.environ, CCACHE_DISABLE="1")

        def configure(into, *options):
            run(cmake, "-S", place / "examples", "-B", into, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Debug",
                *options, env=env)

        alone = place / "alone"
        configure(alone, "-DEXAMPLES_WITH_SCENES=OFF", *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{p}=ON" for p in OTHERS))
        run(cmake, "--build", alone, "--target", "01_distance", env=env)
        loaded = run("ldd", alone / "01_distance")
        expect(not FOREIGN.search(loaded), f"the engine alone loads\n{loaded}")
        everything = place / "everything"
        configure(everything)
        run(cmake, "--build", everything, "-j2", env=env)
        out = {n: run(everything / n, timeout=120) for n in ("01_distance", "02_many_poses", "03_robot_and_person", "04_live_loop")}
        expect(re.search(r"distance 0\.\d+ m, and never below", out["01_distance"]), out["01_distance"])
        expect("poses a millisecond" in out["02_many_poses"], out["02_many_poses"])
        expect(re.search(r"arm/\S+ and visitor/\S+|visitor/\S+ and arm/\S+", out["03_robot_and_person"]),
               out["03_robot_and_person"])
        expect("slowest cycle" in out["04_live_loop"], out["04_live_loop"])
        # A component that does not exist is named.
        wrong = place / "wrong"
        wrong.mkdir()
        (wrong / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.21)\nproject(wrong LANGUAGES C CXX)\n"
                                              "find_package(Abstand REQUIRED COMPONENTS Window)\n")
        done = subprocess.run([cmake, "-S", wrong, "-B", wrong / "build", f"-DCMAKE_PREFIX_PATH={prefix}"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        expect(done.returncode != 0 and "component" in done.stdout and "Window" in done.stdout, done.stdout)
        # pkg-config says the version and how to link.
        if shutil.which("pkg-config"):
            pc = dict(env, PKG_CONFIG_PATH=str(next(prefix.rglob("pkgconfig"))))
            said = run("pkg-config", "--modversion", "abstand-engine", env=pc).strip()
            expect(said == version, f"pkg-config says version {said}")
            libraries = next(prefix.rglob("libabstand_engine.*")).parent
            for package, example in (("engine", "01_distance"), ("scene", "04_live_loop")):
                flags = shlex.split(run("pkg-config", "--cflags", "--libs", f"abstand-{package}", env=pc))
                program = place / f"{example}_by_pkg_config"
                run("c++", "-std=c++20", place / f"examples/{example}.cpp", "-o", program, *flags, env=env)
                run(program, env=dict(env, LD_LIBRARY_PATH=str(libraries)), timeout=120)
            run("pkg-config", "--exists", *(f"abstand-{c}" for c in names), env=pc)
        print("\n".join(out.values()))


main()
