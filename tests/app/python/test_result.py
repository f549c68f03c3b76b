"""Stored results of tune."""
import csv
import glob
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import abstand
from support import ROOT

STEP = 1e-5  # m: the CSV has the digits of the file


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.study = os.path.join(cls.folder.name, "study")
        cls.program("tune", ROOT / "data/scenes/hug_reach.yaml", "--out", cls.study, "--clamped", "hand_left")
        cls.file = glob.glob(cls.study + "/results/*.h5")[0]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @staticmethod
    def program(*arguments):
        subprocess.run([os.environ["ABSTAND_PROGRAM"], *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    def exported(self, option):
        """Rows of the table that `export` writes with this option."""
        table = os.path.join(self.folder.name, option + ".csv")
        self.program("export", self.study, option, table)
        with open(table, newline="") as file:
            return list(csv.DictReader(file))

    def test_has_the_numbers_of_the_exported_table(self):
        rows = self.exported("--pairs-csv")
        r = abstand.read_result(self.file)
        frames, pairs = len(r), len(r.pairs)
        self.assertEqual((r.t.shape, r.distance.shape, r.on_part.shape), ((frames,), (frames, pairs), (frames, pairs, 3)))
        self.assertEqual(len(rows), frames * pairs)
        self.assertEqual([row["part"] for row in rows[:pairs]], [r.parts[p] for p, _ in r.pairs])
        self.assertEqual([row["link"] for row in rows[:pairs]], [r.links[l] for _, l in r.pairs])
        self.assertEqual({row["recording"] for row in rows}, {r.recording})
        self.assertEqual((r.tools, {row["tool"] for row in rows}, r.pair_tools.tolist()), ([], {""}, [-1] * pairs))

        def column(name):
            return np.array([float(row[name] or "nan") for row in rows]).reshape(frames, pairs)

        np.testing.assert_array_equal(column("t_s"), r.t[:, None].repeat(pairs, axis=1))
        for name in ("distance", "bound", "uncertainty", "clearance"):
            np.testing.assert_allclose(column(name + "_m"), getattr(r, name), rtol=0, atol=1e-3 * STEP)
        for name in ("robot_speed", "person_speed", "closing_speed"):
            np.testing.assert_array_equal(column(name + "_m_per_s"), getattr(r, name))
        for side in ("part", "link"):
            points = np.stack([column(f"{side}_{axis}_m") for axis in "xyz"], axis=2)
            np.testing.assert_allclose(points, getattr(r, "on_" + side), rtol=0, atol=1e-9)
        self.assertTrue(np.isnan(r.on_part[r.distance >= 0.5]).all())
        self.assertTrue(np.isfinite(r.on_part[r.distance < 0.5]).all() and (r.distance < 0.5).any())
        self.assertTrue((r.clearance <= r.distance).all())

    def test_has_the_predicted_contacts_of_the_exported_table(self):
        rows = self.exported("--contact-csv")
        r = abstand.read_result(self.file)
        self.assertEqual(r.contact.shape, (len(r), len(r.parts), 4))
        names = [""] + r.regions
        self.assertEqual([row["region"] for row in rows], [names[i + 1] for i in r.contact_region.ravel()])
        columns = [("force_n", 1.0), ("energy_j", 1.0), ("pressure_n_per_cm2", 1e4), ("share_of_limit", 1.0)]
        for i, (name, unit) in enumerate(columns):
            values = np.array([float(row[name] or "0") * unit for row in rows]).reshape(r.contact.shape[:2])
            np.testing.assert_allclose(values, r.contact[:, :, i], rtol=1e-12)
        self.assertTrue((r.contact_region >= 0).any())

    def test_arrays_are_views_that_keep_the_result_alive(self):
        r = abstand.read_result(pathlib.Path(self.file))
        self.assertEqual(r.options["clamped"], ["hand_left"])
        self.assertIn("ISO/TS 15066:2016", r.options["contact_limits"])
        distance = r.distance
        self.assertFalse(distance.flags.owndata or distance.flags.writeable)
        before = distance.copy()
        del r
        np.testing.assert_array_equal(distance, before)

    def test_refuses_other_files(self):
        with self.assertRaisesRegex(abstand.ParseError, "hug_reach.yaml"):
            abstand.read_result(ROOT / "data/scenes/hug_reach.yaml")
        damaged = os.path.join(self.folder.name, "damaged.h5")
        with open(self.file, "rb") as file:
            data = bytearray(file.read())
        data[len(data) // 2] ^= 1
        with open(damaged, "wb") as file:
            file.write(data)
        with self.assertRaisesRegex(abstand.ParseError, "checksum"):
            abstand.read_result(damaged)


if __name__ == "__main__":
    unittest.main()
