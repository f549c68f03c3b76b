"""The recipes of docs/margins.md with GNU parallel and with a real Slurm of one node, as they are written there.

    recipes_test.py PROGRAM parallel|slurm

Installs nothing: skipped (77) where the programs are absent. Slurm needs root and ../shared/slurm/one-node.
"""
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
ONE_NODE = ROOT.parent / "shared" / "slurm" / "one-node"
PROGRAM = sys.argv.pop(1)
KIND = sys.argv.pop(1)
# Ports of slurmctld and slurmd, which another Slurm of this machine may have.
PORTS = (6817, 6818)
# s until something counts as hanging.
PATIENCE = 120

SCENE = """abstand: 1
defaults: {voxel: 0.03, point: 0.03, outer_layers: 1}
mechanisms:
  - name: slide
    file: slide.mech
    base: {xyz: [-1.5, 0, 1.2], rpy: [0, 0, 1.5707963]}
    motion: go.csv
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.1}}}]
humans:
  - {name: person, height: 1.75}
"""
PLAN = """abstand_plan: 1
scenes: [scene.yaml]
people: [{height: 1.6, sex: f}, {height: 1.9}]
programs: [{slide: go.csv}, {slide: faster.csv}]
"""
SLIDE = ("units\nlength m\nangle degrees\nend_units\nmapping\ndof 0 1\nend_mapping\n"
         "chain\nframe 1 0 90 d 0\nend_chain\n")


def recipes(program):
    """Lines of the document's examples that use the program."""
    lines = (ROOT / "docs" / "margins.md").read_text().splitlines()
    found = [line.strip() for line in lines if line.startswith("    ") and program in line.split("'")[0].split()]
    assert found, f"no recipe with {program} in docs/margins.md"
    return found


def why_not():
    """Why the programs cannot be used here; None where they can."""
    if KIND == "parallel":
        path = shutil.which("parallel")
        # That of moreutils has the same name.
        said = subprocess.run([path, "--version"], capture_output=True, text=True).stdout if path else ""
        return None if said.startswith("GNU parallel") else "no GNU parallel"
    for program in ("slurmctld", "slurmd", "sbatch", "munged"):
        if not shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin"):
            return f"no {program}"
    if os.geteuid() != 0:
        return "daemons of Slurm need root"
    if not ONE_NODE.exists():
        return f"no {ONE_NODE}"
    for port in PORTS:
        with socket.socket() as s:
            s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                s.bind(("127.0.0.1", port))
            except OSError:
                return f"port {port} is in use: another Slurm"
    return None


def munge_runs():
    made = subprocess.run(["munge", "-n"], capture_output=True)
    return made.returncode == 0 and subprocess.run(["unmunge"], input=made.stdout, capture_output=True).returncode == 0


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        (cls.path / "bin").mkdir()
        (cls.path / "bin" / "abstand").symlink_to(PROGRAM)
        (cls.path / "slide.mech").write_text(SLIDE)
        (cls.path / "go.csv").write_text("t,q0\n0,0\n0.5,0.5\n")
        (cls.path / "faster.csv").write_text("t,q0\n0,0\n0.5,0.8\n")
        (cls.path / "scene.yaml").write_text(SCENE)
        (cls.path / "plan.yaml").write_text(PLAN)
        path = f"{cls.path}/bin:{os.environ.get('PATH', '')}:/usr/sbin:/sbin"
        cls.environment = dict(os.environ, ABSTAND_CACHE=str(cls.path / "cache"), PATH=path, HOME=str(cls.path))
        for name in ("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SGE_TASK_ID", "PBS_ARRAY_INDEX", "PBS_ARRAYID",
                     "LSB_JOBINDEX", "PARALLEL_SEQ"):
            cls.environment.pop(name, None)
        if KIND == "slurm":
            cls.start_slurm()
        cls.shell("abstand tune plan.yaml --out whole --quiet")
        cls.expected = cls.shell("abstand merge whole --json").stdout

    @classmethod
    def start_slurm(cls):
        munge_was_there = munge_runs()
        node = cls.path / "node"

        def stop():
            if munge_was_there:
                # It belongs to somebody else.
                for daemon in ("slurmd", "slurmctld"):
                    pid = node / f"{daemon}.pid"
                    if pid.exists():
                        subprocess.run(["kill", pid.read_text().strip()])
            else:
                subprocess.run([str(ONE_NODE), "stop", str(node)], env=cls.environment)

        cls.addClassCleanup(stop)
        # The daemons keep standard error open.
        with open(cls.path / "node.log", "w") as log:
            started = subprocess.run([str(ONE_NODE), "start", str(node)], env=cls.environment, stdout=subprocess.PIPE,
                                     stderr=log, text=True, timeout=PATIENCE)
        assert started.returncode == 0, (cls.path / "node.log").read_text()
        cls.environment["SLURM_CONF"] = str((node / "slurm.conf").resolve())

    @classmethod
    def shell(cls, command):
        run = subprocess.run(["sh", "-c", command], cwd=cls.path, env=cls.environment, capture_output=True, text=True,
                             timeout=PATIENCE)
        assert run.returncode == 0, (command, run.stdout, run.stderr, cls.told())
        return run

    @classmethod
    def told(cls):
        """What jobs wrote."""
        return "".join(file.read_text() for file in sorted(cls.path.glob("slurm-*.out")))

    def test_every_recipe_makes_all_results_and_the_same_bits(self):
        for recipe in recipes("sbatch" if KIND == "slurm" else "parallel"):
            with self.subTest(recipe):
                shutil.rmtree(self.path / "results", ignore_errors=True)
                self.shell(recipe)
                made = list((self.path / "results" / "results").glob("*.h5"))
                self.assertEqual(len(made), 4, self.told())
                self.assertEqual(self.shell("abstand merge results --json").stdout, self.expected)


if __name__ == "__main__":
    reason = why_not()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(77)
    unittest.main(verbosity=1)
