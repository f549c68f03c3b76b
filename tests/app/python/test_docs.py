"""The examples of docs/python.md run, one after the other, as they stand there."""
import contextlib
import io
import os
import re
import tempfile
import unittest

import numpy as np

from support import ROOT


class Docs(unittest.TestCase):
    def test_the_examples_run(self):
        text = (ROOT / "docs/python.md").read_text()
        blocks = re.findall(r"```python\n(.*?)```", text, re.S)
        self.assertGreaterEqual(len(blocks), 5)
        names = {}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(ROOT / "data", os.path.join(folder, "data"))
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(io.StringIO()):
                    for block in blocks:
                        exec(compile(block, "docs/python.md", "exec"), names)
            finally:
                os.chdir(before)
        self.assertEqual(names["X_BF"].shape, (500, 7, 4, 4))
        self.assertTrue((names["safe"].dtype == bool) and names["out"].distance.shape == (1000,))
        self.assertTrue(np.isfinite(names["run"].at_least).all())


if __name__ == "__main__":
    unittest.main()
