"""docs/figures.md: what the page takes from the files of the runs, and when it is not written."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import figures_page  # noqa: E402
import table  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
COMMAND = HERE / "figures"


def put(report, path, value):
    *groups, key = path.split(".")
    for group in groups:
        report = report.setdefault(group, {})
    report[key] = value


def runs_of(name, time, **counters):
    return {"name": name, "run_name": name, "run_type": "iteration", "cpu_time": time, "real_time": time, "time_unit": "us", **counters}


def bench():
    """table.json as tests/bench/run makes it, of measurements in which every time is another one."""
    step = {"p50_us": 400, "p95_us": 450, "p99_us": 900, "thread_p50_us": 390, "thread_p99_us": 890, "retarget_us": 1, "select_us": 300,
            "mesh_us": 2, "solve_us": 200}
    benchmarks = [runs_of(f"step/{name}", 1, **step) for name in
                  ["paper/15 Hz", "paper/60 Hz", "responsive/60 Hz", "responsive/120 Hz", "responsive by Eq. 7/60 Hz",
                   "responsive/60 Hz, cold caches", "responsive/60 Hz, bodies user and 0.85"]]
    benchmarks += [runs_of("linear/ours", 200, largest_error_m=8e-9), runs_of("linear/umfpack", 16000, largest_difference_m=9e-9),
                   runs_of("whole/ours", 280), runs_of("knn/ours/43000/10", 20), runs_of("knn/brute double/43000/10", 230),
                   runs_of("knn/ours/1000000/10", 156), runs_of("knn/brute double/1000000/10", 11500),
                   runs_of("mesh/ours/real_time/threads:1", 127), runs_of("mesh/tetgen/real_time/threads:1", 110)]
    benchmarks += [runs_of(f"library/{name}", time) for name, time in
                   [("load", 107e3), ("load, mapped", 3e3), ("read bytes", 86e3), ("build/one core", 8.5e6), ("build/all cores", 6.1e6)]]
    measured = table.Measured([{"benchmarks": benchmarks}])
    return {"machine": {"command": "tests/bench/run", "machine": "a processor, 2 cores", "revision": "r1", "library": "12 minutes of generated salsa",
                        "load before and after (1, 5, 15 min)": "0.1 0.1 0.1 and 0.2 0.1 0.1", "library bytes": 150_000_000, "repetitions": 3,
                        "UMFPACK": "5.7"},
            "ratios": table.ratio_rows(measured), "figures": table.figure_rows(measured)}


def evaluation(preset):
    report = {"takes": ["a", "b"], "library_pairs": 21376}
    for at, (_, _, _, path, captured, _) in enumerate(figures_page.MOVEMENT):
        put(report, path, (at + 1) / 100 if preset == "responsive" else (at + 1) / 10)
        if isinstance(captured, str):
            put(report, captured, 0.5)
    for key in ("original_asf", "synthesised_asf", "ratio"):
        put(report, f"zmp.{key}", 0.7)
    for key, count in (("total", 40), ("successful", 34), ("lenient_rate", 0.9)):
        put(report, f"moves.{key}", count)
    for key, *_ in figures_page.PUBLISHED:
        for which in ("synthesised", "nearest_neighbour", "recording"):
            put(report, f"published.{key}.{which}", 0.25)
    report["selection"] = [{"k": 10, "recall_best": 0.91, "recall_best2": 0.97}]
    report["timing"] = [{"pairs": 7500, "knn_us": 12.0, "brute_us": 90.0}]
    return report


def everything():
    posture = {"pelvis_height_ratio": 0.99, "knee_change_deg": -2.5, "trunk_change_deg": 0.3}
    method = {"posture_active": posture, "posture_passive": posture, "contact_15cm": {"f1": 0.9}, "contact_25cm": {"f1": 0.95}, "hold_change_mean_m": 0.002, "hold_change_p95_m": 0.004,
              "penetration_excess_p99_m": 0, "slide_ratio": 1.1, "speed_p99_ratio": 1.0, "acceleration_p99_ratio": 1.2, "nearest_only": 0}
    counts = {"frame_share": 0.78, "found": 99, "moves": 139, "proposed": 125, "f1": 0.75, "boundary_median_frames": 10}
    reports = {}
    for name in figures_page.RUNS:
        data, what = name.split("-")
        if what in figures_page.PRESETS:
            reports[name] = evaluation(what)
    reports["salsa-bodies"] = {"bodies": {"pairs": [{"bodies": "0.85, 0.85", **dict.fromkeys(
        ["retargeted", "live", *figures_page.BASELINES], method)}]}}
    for data in figures_page.SETS:
        reports[f"{data}-labels"] = {"suggestions": counts, "nearest_pose": counts, "majority": counts, "roles": {"frame_share": 1}}
    about = {"command": "abrazo evaluate", "data": "2 takes", "machine": "a processor, 2 cores", "revision": "r1", "load": "1 and 2"}
    return bench(), reports, {name: about for name in figures_page.RUNS}


def line_with(text, *words):
    found = [line for line in text.splitlines() if all(word in line for word in words)]
    assert len(found) >= 1, words
    return found[0]


class Page(unittest.TestCase):
    def test_has_every_section_and_is_as_it_was_written(self):
        self.assertEqual(figures_page.problems(figures_page.page(*everything())), [])

    def test_says_that_it_is_not_edited(self):
        self.assertIn("Written by `tests/bench/figures`; do not edit.", figures_page.page(*everything())[:200])

    def test_shows_both_presets_beside_the_captured_partner_and_the_goal(self):
        text = figures_page.page(*everything())
        row = line_with(text, "speed, 99th percentile")
        self.assertEqual([cell.strip() for cell in row.split("|")[2:6]], ["1.9", "0.020", "0.200", "0.500"])
        self.assertIn("| 1.4 | 0.030 | 0.300 | 1.00 |", line_with(text, "acceleration, times the captured"))

    def test_shows_steps_by_both_selections_and_with_cold_caches_in_milliseconds(self):
        text = figures_page.page(*everything())
        for what in ("by intent", "by Eq. 7", "with cold caches"):
            self.assertIn("0.390 | 0.890 | 0.400 | 0.900", line_with(text, what, "0.390"))

    def test_shows_ratios_against_others(self):
        row = line_with(figures_page.page(*everything()), "linear systems of one frame", "UMFPACK")
        self.assertIn("80.0", row)

    def test_shows_the_command_the_data_and_the_revision_of_every_run(self):
        text = figures_page.page(*everything())
        for name in ["benchmarks", *figures_page.RUNS]:
            self.assertIn("r1", line_with(text, f"| {name} |"))

    def test_names_the_machine_of_each_run_where_they_differ(self):
        table_json, reports, abouts = everything()
        abouts["salsa-bodies"] = {**abouts["salsa-bodies"], "machine": "another processor"}
        self.assertIn("- another processor: salsa-bodies", figures_page.page(table_json, reports, abouts))

    def test_shows_a_figure_that_could_not_be_measured_as_a_dash(self):
        table_json, reports, abouts = everything()
        put(reports["fight-paper"], "movement.lag_s", None)
        self.assertEqual(line_with(figures_page.page(table_json, reports, abouts), "lag [ms]").split("|")[-3].strip(), "-")

    def test_says_what_was_not_measured_where_a_section_may_be_empty(self):
        text = figures_page.page(*everything())
        self.assertIn("Not measured in this run: `tests/soak/soak 60`.", text.split("## An hour live")[1])

    def test_shows_the_verdict_of_the_soak(self):
        text = figures_page.page(*everything(), "     ok  lost by the recorder: 0\n FAILED  pictures per second: median 23\n")
        self.assertIn("| lost by the recorder | 0 | yes |", text)
        self.assertIn("| pictures per second | median 23 | **no** |", text)

    def test_has_as_many_cells_in_every_row_of_a_table_as_in_its_head(self):
        head = 0
        for line in figures_page.page(*everything()).splitlines():
            cells = line.count("|")
            head = 0 if not cells else head or cells
            self.assertEqual(cells, head, line)

    def test_is_not_made_without_a_run(self):
        table_json, reports, abouts = everything()
        del reports["dance-paper"]
        with self.assertRaisesRegex(figures_page.Missing, "dance-paper"):
            figures_page.page(table_json, reports, abouts)

    def test_is_not_made_without_a_figure(self):
        table_json, reports, abouts = everything()
        del reports["salsa-paper"]["movement"]["hover_p90_m"]
        with self.assertRaisesRegex(figures_page.Missing, "movement.hover_p90_m"):
            figures_page.page(table_json, reports, abouts)

    def test_is_not_made_without_the_steps_of_the_benchmarks(self):
        table_json, reports, abouts = everything()
        table_json["figures"] = [row for row in table_json["figures"] if "cold" not in row["what"]]
        with self.assertRaisesRegex(figures_page.Missing, "cold caches"):
            figures_page.page(table_json, reports, abouts)


class PartialPage(unittest.TestCase):
    def test_says_in_a_section_which_run_is_missing_and_has_all_others(self):
        table_json, reports, abouts = everything()
        del reports["salsa-bodies"], abouts["salsa-bodies"]
        text = figures_page.page(table_json, reports, abouts, is_partial=True)
        self.assertIn("Not measured: the run salsa-bodies is not there.", text.split("## Other bodies")[1])
        self.assertEqual(figures_page.unmeasured(text), ["Other bodies"])
        self.assertEqual(figures_page.problems(text), [])

    def test_names_the_runs_that_are_there(self):
        _, reports, abouts = everything()
        text = figures_page.page(None, reports, abouts, is_partial=True)
        self.assertIn("r1", line_with(text, "| salsa-paper |"))
        self.assertNotIn("Runs", figures_page.unmeasured(text))

    def test_needs_nothing(self):
        text = figures_page.page(None, {}, {}, is_partial=True)
        self.assertIn("there is no table of tests/bench/run", text.split("## One solve")[1])
        self.assertEqual(figures_page.problems(text), [])

    def test_is_told_from_a_whole_one(self):
        self.assertEqual(figures_page.unmeasured(figures_page.page(*everything())), [])


class Check(unittest.TestCase):
    def test_finds_a_figure_that_was_edited(self):
        text = figures_page.page(*everything()).replace("0.390", "0.190", 1)
        self.assertEqual(figures_page.problems(text), ["it was edited by hand"])

    def test_finds_a_line_behind_the_checksum(self):
        self.assertEqual(figures_page.problems(figures_page.page(*everything()) + "more\n"), ["it was edited by hand"])

    def test_finds_a_section_that_is_not_there(self):
        text = figures_page.page(*everything()).rpartition(figures_page.SEAL)[0].replace("## Nearest poses", "## Poses")
        self.assertEqual(figures_page.problems(figures_page.sealed(text)), ['there is no section "Nearest poses"'])

    def test_needs_the_checksum(self):
        text = figures_page.page(*everything()).rpartition(figures_page.SEAL)[0]
        self.assertEqual(figures_page.problems(text), ["the line with its checksum is missing"])


class PapersFigures(unittest.TestCase):
    def test_are_those_of_the_report(self):
        header = (HERE.parent.parent / "core/evaluation/report/html_paper.hpp").read_text()

        def rows(name):
            body = re.search(name + r" = \{\s*\{(.*?)\};", header, re.DOTALL)[1]
            return [tuple(json.loads(f"[{row}]")) for row in re.findall(r"\{([^{}]+)\}", body)]

        self.assertEqual({k: (best, two) for k, best, two, _ in rows("table_1")}, figures_page.PAPER_RECALL)
        self.assertEqual({pairs: (knn, brute) for pairs, knn, brute in rows("table_2")}, figures_page.PAPER_TIMES_MS)
        self.assertEqual(rows("table_3"), figures_page.PAPER_MOVES)
        self.assertEqual({what: (original, made) for what, original, made in rows("table_4")}, figures_page.PAPER_ZMP)


class Command(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.page = self.folder / "figures.md"
        table_json, reports, abouts = everything()
        (self.folder / "table.json").write_text(json.dumps(table_json))
        for name, report in reports.items():
            (self.folder / name).mkdir()
            file = "agreement.json" if name.endswith("-labels") else "report.json"
            (self.folder / name / file).write_text(json.dumps(report))
            (self.folder / name / "run.json").write_text(json.dumps(abouts[name]))

    def run_with(self, *words):
        return subprocess.run([sys.executable, COMMAND, "--page", self.page, "--bench", self.folder / "table.json", "--out", self.folder,
                               "--soak", self.folder / "verdict.txt", *words], capture_output=True, text=True)

    def test_writes_a_page_that_passes_its_check(self):
        self.assertEqual(self.run_with().returncode, 0)
        self.assertEqual(self.run_with("--check").returncode, 0)

    def test_leaves_the_page_as_it_is_when_something_is_missing(self):
        self.page.write_text("before")
        (self.folder / "fight-responsive" / "run.json").unlink()
        answer = self.run_with()
        self.assertEqual(answer.returncode, 1)
        self.assertIn("the run fight-responsive is not there", answer.stderr)
        self.assertEqual(self.page.read_text(), "before")
        self.assertFalse(self.page.with_suffix(".tmp").exists())

    def test_writes_a_partial_page_when_asked_and_its_check_says_so(self):
        (self.folder / "fight-responsive" / "run.json").unlink()
        self.assertEqual(self.run_with("--partial").returncode, 0)
        answer = self.run_with("--check")
        self.assertEqual(answer.returncode, 77)
        self.assertIn('"Movement of the partner" is not measured', answer.stderr)

    def test_fails_its_check_for_an_edited_page(self):
        self.run_with()
        self.page.write_text(self.page.read_text().replace("captured", "caught", 1))
        answer = self.run_with("--check")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("it was edited by hand", answer.stderr)

    def test_needs_the_captured_takes_to_measure(self):
        self.assertIn("--manifest", self.run_with("--measure").stderr)


class Measure(unittest.TestCase):
    """With a program in place of abrazo that notes its words and writes what it is to write."""

    PROGRAM = """#!/usr/bin/python3
import json, pathlib, sys
words = sys.argv[1:]
with open(pathlib.Path(__file__).with_name("words"), "a") as out:
    print(*words, file=out)
if words[0] == "demo":
    folder = pathlib.Path(words[words.index("-o") + 1])
    folder.mkdir()
    (folder / "manifest.json").write_text("{}")
else:
    name = "agreement.json" if words[0] == "suggest" else "report.json"
    (pathlib.Path(words[words.index("--report") + 1]) / name).write_text(json.dumps({"takes": ["a", "b"]}))
"""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.program = self.folder / "abrazo"
        self.program.write_text(self.PROGRAM)
        self.program.chmod(0o755)
        (self.folder / "takes.json").write_text("{}")

    def measure(self, *words):
        return subprocess.run([sys.executable, COMMAND, "--measure", "--partial", "--manifest", self.folder / "takes.json", "--abrazo", self.program,
                               "--out", self.folder / "runs", "--page", self.folder / "figures.md", "--bench", self.folder / "none",
                               "--soak", self.folder / "none", *words], capture_output=True, text=True)

    def words(self):
        return (self.folder / "words").read_text().splitlines()

    def test_evaluates_both_presets_on_the_captured_and_the_generated_takes(self):
        self.measure()
        evaluated = [line for line in self.words() if line.startswith("evaluate")]
        for preset in figures_page.PRESETS:
            self.assertEqual(sum(f"--preset {preset}" in line for line in evaluated), len(figures_page.SETS))
        self.assertEqual(sum("takes.json" in line for line in evaluated), 3)
        self.assertTrue(all(("--both-roles" in line) == ("fight" in line) for line in evaluated))

    def test_generates_each_set_once(self):
        self.measure()
        self.assertEqual(sum(line.startswith("demo") for line in self.words()), len(figures_page.GENERATED))

    def test_notes_the_command_of_a_run_without_folders(self):
        self.measure("--only", "salsa-paper")
        noted = json.loads((self.folder / "runs/salsa-paper/run.json").read_text())
        self.assertTrue(noted["command"].startswith("abrazo evaluate selection timing"), noted["command"])
        self.assertNotIn("/", noted["command"])
        self.assertEqual(noted["data"], "2 captured takes")

    def test_repeats_no_run_of_the_present_revision_unless_it_is_named(self):
        self.measure()
        first = len(self.words())
        self.measure()
        self.assertEqual(len(self.words()), first)
        self.measure("--only", "fight-paper")
        self.assertEqual(len(self.words()), first + 1)

    def test_stops_at_a_run_that_fails_and_keeps_no_note_of_it(self):
        self.program.write_text("#!/bin/sh\nexit 3\n")
        answer = self.measure("--only", "salsa-paper")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("salsa-paper could not be measured", answer.stderr)
        self.assertFalse((self.folder / "runs/salsa-paper/run.json").exists())


if __name__ == "__main__":
    unittest.main()
