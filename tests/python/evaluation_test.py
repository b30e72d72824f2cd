"""Evaluations: the report of the command line as a dict."""

import json
import unittest

import abrazo
import demo_set


def manifest():
    return demo_set.folder() / "demo" / "manifest.json"


def without_times(report):
    """What does not depend on how quick the machine was."""
    if isinstance(report, dict):
        return {key: without_times(value) for key, value in report.items() if "_us" not in key and key != "seconds"}
    return [without_times(value) for value in report] if isinstance(report, list) else report


class Evaluations(unittest.TestCase):
    def test_give_the_report_of_the_command_line(self):
        folder = demo_set.folder() / "report"
        demo_set.command_line(
            "evaluate", "moves", "contact", "--manifest", manifest(), "--report", folder, "--no-variants",
            "--hold-out", "salsa_01",
        )  # fmt: skip
        report = abrazo.evaluate(manifest(), parts=["moves", "contact"], variants=False, hold_out=["salsa_01"])
        written = json.loads((folder / "report.json").read_text())
        self.assertEqual(without_times(report), without_times(written))
        self.assertIn("moves", report)

    def test_have_only_the_parts_that_were_asked_for(self):
        report = abrazo.evaluate(manifest(), parts=["zmp"], settings={"alpha": 0.1})
        self.assertIn("zmp", report)
        self.assertNotIn("moves", report)
        self.assertEqual(report["settings"]["alpha"], 0.1)

    def test_stop_when_they_are_told_to(self):
        with self.assertRaisesRegex(abrazo.Error, "cancelled"):
            abrazo.evaluate(manifest(), parts=["zmp"], progress=lambda fraction, doing: False)

    def test_refuse_parts_that_there_are_not(self):
        with self.assertRaisesRegex(
            abrazo.Error, "'tempo' is no part of the evaluation; there are selection, timing, moves, zmp, contact, published, bodies, and all"
        ):
            abrazo.evaluate(manifest(), parts=["tempo"])

    def test_refuse_takes_that_there_are_not_as_the_command_line_does(self):
        said = demo_set.refusal(
            "evaluate", "zmp", "--manifest", manifest(), "--report", demo_set.folder() / "no", "--hold-out", "salsa_77"
        )
        with self.assertRaises(abrazo.Error) as raised:
            abrazo.evaluate(manifest(), parts=["zmp"], hold_out=["salsa_77"])
        self.assertEqual(str(raised.exception), said)


if __name__ == "__main__":
    unittest.main()
