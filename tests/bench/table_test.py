"""What the benchmarks' table concludes from figures."""

import sys
import unittest

sys.dont_write_bytecode = True
import table  # noqa: E402


def runs(name, values, unit="us", **counters):
    return [{"name": name, "run_name": name, "run_type": "iteration", "cpu_time": value, "real_time": 2 * value,
             "time_unit": unit, **counters} for value in values]


def measured(*benchmarks):
    return table.Measured([{"benchmarks": [run for some in benchmarks for run in some]}])


def only(rows, **wanted):
    found = [row for row in rows if all(row[key] == value for key, value in wanted.items())]
    assert len(found) == 1, found
    return found[0]


class Spreads(unittest.TestCase):
    def test_are_median_least_and_quartiles(self):
        spread = table.Spread([5, 1, 4, 2, 3])
        self.assertEqual((spread.median, spread.least, spread.low, spread.high), (3, 1, 2, 4))

    def test_of_one_repetition_are_that(self):
        spread = table.Spread([7])
        self.assertEqual((spread.median, spread.low, spread.high), (7, 7, 7))


class Ratios(unittest.TestCase):
    def test_are_of_medians_and_as_wide_as_the_quartiles_of_both_allow(self):
        rows = table.ratio_rows(measured(runs("linear/ours", [8, 10, 12]), runs("linear/umfpack", [190, 200, 300])))
        row = only(rows, other="UMFPACK")
        self.assertAlmostEqual(row["times"]["median"], 20)
        self.assertAlmostEqual(row["times"]["low"], 195 / 11)
        self.assertAlmostEqual(row["times"]["high"], 250 / 9)
        self.assertAlmostEqual(row["times"]["of_min"], 190 / 8)

    def test_meet_a_goal_at_it_and_miss_it_below(self):
        at = table.ratio_rows(measured(runs("linear/ours", [10]), runs("linear/umfpack", [200])))
        below = table.ratio_rows(measured(runs("linear/ours", [10]), runs("linear/umfpack", [199])))
        self.assertIs(only(at, other="UMFPACK")["met"], True)
        self.assertIs(only(below, other="UMFPACK")["met"], False)

    def test_turn_units_into_the_same(self):
        rows = table.ratio_rows(measured(runs("linear/ours", [10]), runs("linear/umfpack", [1], unit="ms")))
        self.assertAlmostEqual(only(rows, other="UMFPACK")["times"]["median"], 100)

    def test_leave_out_aggregates(self):
        aggregate = {**runs("linear/ours", [1000])[0], "run_type": "aggregate"}
        rows = table.ratio_rows(measured(runs("linear/ours", [10]), [aggregate], runs("linear/umfpack", [50])))
        self.assertAlmostEqual(only(rows, other="UMFPACK")["times"]["median"], 5)

    def test_are_not_made_of_a_competitor_that_does_not_agree(self):
        wrong = [{**run, "error_occurred": True, "error_message": "answers differ"} for run in runs("linear/umfpack", [1])]
        row = only(table.ratio_rows(measured(runs("linear/ours", [10]), wrong)), other="UMFPACK")
        self.assertNotIn("times", row)
        self.assertEqual(row["error"], "answers differ")
        self.assertIs(row["met"], False)

    def test_are_not_made_where_only_ours_was_measured(self):
        self.assertEqual(table.ratio_rows(measured(runs("linear/ours", [10]))), [])

    def test_of_a_whole_step_change_its_linear_systems_only(self):
        rows = table.ratio_rows(measured(runs("whole/ours", [300]), runs("linear/ours", [100]), runs("linear/umfpack", [2800])))
        row = only(rows, what="whole step, linear systems the other way")
        self.assertAlmostEqual(row["times"]["median"], (300 - 100 + 2800) / 300)

    def test_of_searches_have_their_goal_at_a_million_and_ten(self):
        rows = table.ratio_rows(measured(
            runs("knn/ours/1000000/10", [100]), runs("knn/brute double/1000000/10", [900]),
            runs("knn/ours/43000/10", [100]), runs("knn/brute double/43000/10", [900])))
        self.assertIs(only(rows, what="10 of 1 000 000")["met"], True)
        self.assertIsNone(only(rows, what="10 of 43 000")["met"])

    def test_compare_builds_by_the_clock(self):
        rows = table.ratio_rows(measured(
            runs("library/build/one core/iterations:1/process_time/real_time", [20], unit="s"),
            runs("library/build/all cores/iterations:1/process_time/real_time", [10], unit="s")))
        row = only(rows, group="Library")
        self.assertAlmostEqual(row["times"]["median"], 2)
        self.assertAlmostEqual(row["ours_us"]["median"], 20e6)  # real_time above is twice the processor's


class Figures(unittest.TestCase):
    def test_of_steps_have_goals_for_the_median_and_the_99th_percentile(self):
        rows = table.figure_rows(measured(runs("step/paper/60 Hz/iterations:1/manual_time", [1], p50_us=400, p99_us=1100)))
        self.assertIs(only(rows, what="paper at 60 Hz: p50")["met"], True)
        self.assertIs(only(rows, what="paper at 60 Hz: p99")["met"], False)

    def test_of_steps_with_cold_caches_or_other_bodies_have_no_goal(self):
        rows = table.figure_rows(measured(
            runs("step/responsive/60 Hz, cold caches/iterations:1/manual_time", [1], p99_us=1100),
            runs("step/responsive/60 Hz, bodies user and 0.85/iterations:1/manual_time", [1], p99_us=1100)))
        self.assertIsNone(only(rows, what="responsive at 60 Hz, cold caches: p99")["met"])
        self.assertIsNone(only(rows, what="responsive at 60 Hz, bodies user and 0.85: p99")["met"])

    def test_of_pictures_are_good_above_their_goal(self):
        rows = table.figure_rows(measured(runs("scene/as at the start/1280x720/iterations:1/real_time", [1], pictures_per_s=31)))
        self.assertIs(only(rows, unit="1/s")["met"], True)

    def test_of_packets_have_their_goal_at_120_hz(self):
        packets = [{"rate_hz": rate, "p50": 1, "p95": 2, "p99": 4, "sent": 100, "answered": 99} for rate in (60, 120)]
        rows = table.figure_rows(measured(), packets)
        self.assertIs(only(rows, what="120 Hz: p99")["met"], False)
        self.assertIsNone(only(rows, what="60 Hz: p99")["met"])
        self.assertEqual(only(rows, what="60 Hz: frames without an answer")["value"]["median"], 1)


class Markdown(unittest.TestCase):
    def test_shows_what_was_not_compared_and_why(self):
        wrong = [{**run, "error_occurred": True, "error_message": "answers differ by 1 m"} for run in runs("linear/umfpack", [1])]
        found = measured(runs("linear/ours", [10]), wrong)
        text = table.markdown(table.ratio_rows(found), [], {"machine": "m"})
        self.assertIn("not compared: answers differ by 1 m", text)

    def test_has_as_many_cells_in_every_row_of_a_table_as_in_its_head(self):
        found = measured(runs("linear/ours", [10]), runs("linear/umfpack", [300]), runs("knn/ours/43000/10", [5]),
                         [{**run, "error_occurred": True, "error_message": "no"} for run in runs("linear/dense LU, full pivoting", [1])])
        text = table.markdown(table.ratio_rows(found), table.figure_rows(found), {})
        for part in text.split("## ")[1:]:
            cells = {line.count("|") for line in part.splitlines() if line.startswith("|")}
            self.assertEqual(len(cells), 1, part)


if __name__ == "__main__":
    unittest.main()
