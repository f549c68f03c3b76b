"""Recorded people."""
import os
import tempfile
import unittest

import numpy as np

import abstand
from support import ROOT, ROUNDING


class Recordings(unittest.TestCase):
    def test_a_bvh(self):
        r = abstand.read_recording(ROOT / "data/scenes/hug_reach.bvh")
        self.assertEqual((r.joints.shape, r.states.shape, r.t.shape), ((len(r), 22, 3), (len(r), 22), (len(r),)))
        self.assertEqual(r.names, abstand.JOINTS)
        self.assertTrue((np.diff(r.t) > 0).all())
        self.assertEqual((r.facts["format"], r.facts["up"]), ("bvh", "y"))
        # It stands upright, z up, metres.
        head, ankle = (r.joints[0, abstand.JOINTS.index(j), 2] for j in ("head", "ankle_left"))
        self.assertTrue(1.3 < head - ankle < 1.8)

    def test_arrays_are_views_that_keep_the_recording_alive(self):
        r = abstand.read_recording(ROOT / "data/scenes/hug_reach.bvh")
        for name in ("t", "joints", "states", "spread"):
            view = getattr(r, name)
            self.assertTrue(np.shares_memory(view, getattr(r, name)), name)
            self.assertFalse(view.flags.owndata or view.flags.writeable, name)
        joints = r.joints
        before = joints.copy()
        del r
        np.testing.assert_array_equal(joints, before)

    def test_what_is_missing_is_no_number(self):
        rest = abstand.Human().rest
        names = [n for i, n in enumerate(abstand.JOINTS) if np.isfinite(rest[i]).all()]
        lines = ["t," + ",".join(f"{n}.x,{n}.y,{n}.z,{n}.confidence" for n in names)]
        for i in range(5):
            cells = [str(i / 10)]
            for n in names:
                confidence = 0 if n == "wrist_left" and i >= 2 else 0.5 if n == "wrist_right" else 1
                cells += [repr(float(x)) if confidence else "" for x in rest[abstand.JOINTS.index(n)]] + [str(confidence)]
            lines.append(",".join(cells))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "r.csv")
            with open(path, "w") as file:
                file.write("\n".join(lines) + "\n")
            r = abstand.read_recording(path)
        left, right = (abstand.JOINTS.index(n) for n in ("wrist_left", "wrist_right"))
        np.testing.assert_array_equal(r.states[:, left], [2, 2, 0, 0, 0])
        np.testing.assert_array_equal(r.states[:, right], 1)
        np.testing.assert_array_equal(np.isnan(r.joints), (r.states == 0)[:, :, None].repeat(3, axis=2))
        np.testing.assert_allclose(r.joints[0, right], rest[right], atol=ROUNDING)
        poses = abstand.Human().poses(r)
        self.assertEqual(poses.states[4, abstand.PARTS.index("forearm_left")], 1)

    def test_bad_files_and_options(self):
        path = ROOT / "data/scenes/hug_reach.bvh"
        with self.assertRaisesRegex(abstand.UsageError, "up: found 'q'"):
            abstand.read_recording(path, up="q")
        with self.assertRaises(abstand.ParseError):
            abstand.read_recording(ROOT / "README.md")
        with self.assertRaisesRegex(abstand.ParseError, "no such file"):
            abstand.read_recording("nowhere.bvh")


if __name__ == "__main__":
    unittest.main()
