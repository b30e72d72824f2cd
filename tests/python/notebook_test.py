"""The notebook of the guide runs, and keeps what it answered."""

import json
import os
import pathlib
import re
import tempfile
import unittest
import unittest.mock

import notebook

os.environ["PATH"] = os.path.dirname(os.environ["ABRAZO_PROGRAM"]) + os.pathsep + os.environ["PATH"]
GUIDE = pathlib.Path(os.environ["ABRAZO_SOURCE_DIR"], "docs", "guide", "python.ipynb")


class Notebook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.contents = json.loads(GUIDE.read_text())
        # It makes a folder for its reader to look into; here nobody does.
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("tempfile.tempdir", folder):
            cls.answers = notebook.run(cls.contents)

    def cells(self):
        return [cell for cell in self.contents["cells"] if cell["cell_type"] == "code"]

    def test_draws_the_pictures_it_shows(self):
        shown = [len([o for o in cell["outputs"] if o["output_type"] == "display_data"]) for cell in self.cells()]
        self.assertEqual([len(drawn) for _, drawn in self.answers], shown)
        self.assertEqual(sum(shown), 2)
        for _, drawn in self.answers:
            for picture in drawn:
                self.assertGreater(len(picture), 5000)

    def test_says_what_it_shows_but_for_the_numbers(self):
        for cell, (printed, _) in zip(self.cells(), self.answers, strict=True):
            kept = "".join("".join(o["text"]) for o in cell["outputs"] if o["output_type"] == "stream")
            words = [re.sub(r"\d+", "0", re.sub(r"salsa_\d+", "salsa", text)) for text in (kept, printed)]
            self.assertEqual(words[0], words[1])

    def test_shows_that_ones_own_cost_selects(self):
        printed = self.answers[-1][0]
        errors = dict(re.findall(r"(Eq. 7|own): ([\d.]+) cm", printed))
        self.assertNotEqual(errors["Eq. 7"], errors["own"])
        for error in errors.values():
            self.assertTrue(2 < float(error) < 30, printed)


if __name__ == "__main__":
    unittest.main()
