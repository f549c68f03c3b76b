"""Every real capture that is there through one plan: killed, resumed, in parts, and always the same bits.

    captures_test.py PROGRAM
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[3]
SHARED = ROOT.parent / "shared" / "data"
DEBIAN = pathlib.Path("/usr/share/assimp/models/BVH")
PROGRAM = sys.argv.pop(1)

# The shipped arm on its rail beside whoever was captured. Coarse bodies, which are made in no time.
SCENE = f"""abstand: 1
defaults: {{voxel: 0.03, point: 0.03, outer_layers: 1}}
mechanisms:
  - name: rail7
    file: {ROOT}/data/robots/rail7/rail7.urdf
    base: {{xyz: [0, -0.65, 0]}}
    motion: {ROOT}/data/scenes/motion/rail7.csv
humans:
  - {{name: person, height: 1.75}}
"""
# s until a study counts as one that hangs.
PATIENCE = 280
MERGE = ["--margins", "0:0.4:0.05", "--json"]


def captures():
    """Whatever may be a recording of a person; depth images are none."""
    files = sorted(DEBIAN.glob("*.bvh"))
    for suffix in ("bvh", "amc", "c3d", "trc"):
        files += sorted((SHARED / "mocap").glob(f"**/*.{suffix}"))
    files += sorted((SHARED / "kinect").glob("**/*.csv")) + sorted((SHARED / "kinect").glob("**/*.txt"))
    return files + sorted((SHARED / "depth" / "utd_mhad").glob("*_skeleton.mat"))


class Captures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        cls.environment = dict(os.environ, ABSTAND_CACHE=str(cls.path / "cache"))
        for name in ("SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SGE_TASK_ID", "PBS_ARRAY_INDEX", "PBS_ARRAYID",
                     "LSB_JOBINDEX", "PARALLEL_SEQ"):
            cls.environment.pop(name, None)
        (cls.path / "cell.yaml").write_text(SCENE)
        cls.files = captures()
        names = "".join(f"  - {file}\n" for file in cls.files)
        (cls.path / "plan.yaml").write_text(f"abstand_plan: 1\nscenes: [cell.yaml]\nrecordings:\n{names}")
        run = cls.study("whole", "--jobs", "2")
        assert run.returncode in (0, 5), run.stderr  # 5: some captures cannot be read, and it says which
        cls.whole = json.loads(run.stdout)
        cls.expected = cls.merged("whole")

    @classmethod
    def command(cls, folder, *arguments):
        return [PROGRAM, "tune", str(cls.path / "plan.yaml"), "--out", str(cls.path / folder), "--json", "--quiet", *arguments]

    @classmethod
    def study(cls, folder, *arguments):
        return subprocess.run(cls.command(folder, *arguments), capture_output=True, text=True, env=cls.environment,
                              timeout=PATIENCE)

    @classmethod
    def merged(cls, *folders):
        run = subprocess.run([PROGRAM, "merge", *(str(cls.path / f) for f in folders), *MERGE], capture_output=True,
                             env=cls.environment, timeout=PATIENCE)
        assert run.returncode == 0, run.stderr
        return run.stdout

    def results(self, folder):
        return sorted((self.path / folder / "results").glob("*.h5"))

    def test_every_capture_is_run_or_named_with_a_reason(self):
        failed = {f["recording"]: f["error"] for f in self.whole["failed"]}
        run = {i["recording"] for i in self.whole["inputs"]}
        self.assertEqual(run | set(failed), {str(file) for file in self.files})
        self.assertFalse(run & set(failed))
        for file in self.files:
            # What moves some part of a person is run; all else is refused, in one line.
            read = subprocess.run([PROGRAM, "skeleton", str(file), "--json", "--quiet"], capture_output=True, text=True,
                                  timeout=PATIENCE)
            self.assertIn(read.returncode, (0, 3), read.stderr)
            moves = bool(read.stdout) and any(json.loads(read.stdout)["mapped"].values())
            self.assertEqual(moves, str(file) in run, (file, read.stderr, failed.get(str(file))))
        for file, error in failed.items():
            self.assertRegex(error, r"^\S+: error: [^\n]+(\nhint: [^\n]+)?$", file)
        self.assertEqual(self.whole["recordings"], len(run))
        self.assertGreater(len(run), 2)
        print(f"{len(run)} captures, {self.whole['frames']} frames, {len(failed)} refused", flush=True)

    def test_killed_in_the_middle_it_goes_on_to_the_same_bits(self):
        process = subprocess.Popen(self.command("killed", "--jobs", "2"), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, env=self.environment, start_new_session=True)
        runs = len(self.results("whole"))
        end = time.monotonic() + PATIENCE
        while len(self.results("killed")) < runs // 3 and process.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        self.assertIsNone(process.poll(), "ended before it was killed")
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        kept = self.results("killed")
        self.assertGreaterEqual(len(kept), runs // 3)
        self.assertLess(len(kept), runs)
        self.merged("killed")  # nothing that is there is half a result
        run = self.study("killed", "--jobs", "2", "--shard", "1/1")
        self.assertEqual(run.returncode, 5 if self.whole["failed"] else 0, run.stderr)
        again = json.loads(run.stdout)
        self.assertEqual(again["results"], {**again["results"], "kept": len(kept), "made": runs - len(kept)})
        self.assertEqual(again["failed"], self.whole["failed"])
        self.assertEqual(self.merged("killed"), self.expected)

    def test_two_parts_at_once_give_the_same_bits(self):
        parts = [subprocess.Popen(self.command("two", "--shard", f"{i}/2"), stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, env=self.environment) for i in (2, 1)]
        for part in parts:
            self.assertIn(part.wait(timeout=PATIENCE), (0, 5))
        self.assertEqual(self.merged("two"), self.expected)

    def test_seven_parts_in_folders_of_their_own_give_the_same_bits(self):
        folders = [f"seven{i}" for i in range(1, 8)]
        for i, folder in enumerate(folders, 1):
            run = self.study(folder, "--jobs", "2", "--shard", f"{i}/7")
            self.assertIn(run.returncode, (0, 3, 5), run.stderr)  # 3: none of a part could be read
        there = [folder for folder in reversed(folders) if self.results(folder)]
        self.assertEqual(self.merged(*there), self.expected)


if __name__ == "__main__":
    if not captures():
        print(f"skipped: no captures in {SHARED} and {DEBIAN}")
        sys.exit(77)
    unittest.main(verbosity=1)
