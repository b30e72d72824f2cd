"""Says what the report of a soak lets pass and what not."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import report  # noqa: E402

LIMITS = {"memory": 8, "pictures": 30, "latency": 3}


def hour(**changed):
    """An hour of good samples, a sample every 10 s. changed: name = function of the seconds."""
    samples = []
    for seconds in range(0, 3600, 10):
        sample = {"seconds": seconds, "solved": 120 * seconds, "recorded": 120 * seconds, "failed": 0, "recording_lost": 0, "received": 120 * seconds,
                  "stream_lost": 0, "late": 0, "replaced": 0, "overflowed": 0, "rss_mb": 800.0, "threads": 12, "fds": 60,
                  "pss_mb": 700.0 if seconds % 60 == 0 else None, "history_mb": min(512.0, 2.5 * seconds),
                  "pictures_per_s": 40.0, "out_p50_ms": 1.0, "out_p99_ms": 2.0, "out_max_ms": 9.0, "solve_p50_ms": 0.5,
                  "solve_p99_ms": 1.0, "cpu": 1.2, "file_mb": 0.2 * seconds, "log_mb": 4.0}
        sample.update({name: value(seconds) for name, value in changed.items()})
        samples.append(sample)
    return samples


def judged(samples, **changed):
    last = samples[-1]
    recorded = {"frames": last["recorded"], "holes": 0, "damaged_rows": 0, "poses": last["received"]}
    return report.judge(samples, recorded | changed, {"frames": last["received"]}, LIMITS)


class Verdict(unittest.TestCase):
    def test_an_hour_without_trouble_is_good(self):
        self.assertTrue(judged(hour()).good, judged(hour()).text())

    def test_memory_that_grows_after_the_warm_up_fails(self):
        self.assertFalse(judged(hour(rss_mb=lambda s: 800 + s / 180)).good)

    def test_memory_that_grows_while_the_history_fills_is_let_pass(self):
        self.assertTrue(judged(hour(rss_mb=lambda s: 300 + min(512.0, 2.5 * s))).good)

    def test_the_memory_of_a_run_too_short_to_fill_the_history_is_not_judged(self):
        short = judged(hour(rss_mb=lambda s: 300 + 2.5 * s)[:18])
        self.assertTrue(short.good, short.text())
        self.assertIn("still fills", short.text())

    def test_a_single_peak_is_no_growth(self):
        self.assertTrue(judged(hour(rss_mb=lambda s: 1500 if s == 3000 else 800)).good)

    def test_files_that_stay_open_fail(self):
        self.assertFalse(judged(hour(fds=lambda s: 60 + s // 900)).good)

    def test_slow_answers_and_few_pictures_fail(self):
        self.assertFalse(judged(hour(out_p99_ms=lambda s: 3.5)).good)
        self.assertFalse(judged(hour(pictures_per_s=lambda s: 25)).good)

    def test_a_frame_or_pose_that_is_not_in_the_file_fails(self):
        samples = hour()
        self.assertFalse(judged(samples, frames=samples[-1]["recorded"] - 1).good)
        self.assertFalse(judged(samples, holes=1).good)
        self.assertFalse(judged(samples, damaged_rows=1).good)
        self.assertFalse(judged(samples, poses=samples[-1]["received"] - 1).good)
        self.assertFalse(report.judge(samples, None, None, LIMITS).good)

    def test_a_step_that_fails_while_all_begins_is_let_pass_a_later_one_not(self):
        self.assertTrue(judged(hour(failed=lambda s: min(s, 1))).good)
        self.assertFalse(judged(hour(failed=lambda s: s // 3000)).good)

    def test_poses_that_did_not_come_in_fail_but_those_counted_as_lost_on_the_way_do_not(self):
        samples = hour()
        last = samples[-1]
        recorded = {"frames": last["recorded"], "holes": 0, "damaged_rows": 0, "poses": last["received"]}
        sent = {"frames": last["received"] + 100}
        self.assertFalse(report.judge(samples, recorded, sent, LIMITS).good)
        last["stream_lost"] = 100
        self.assertTrue(report.judge(samples, recorded, sent, LIMITS).good)

    def test_no_samples_are_no_soak(self):
        self.assertFalse(report.judge([], None, None, LIMITS).good)


class Table(unittest.TestCase):
    def test_has_every_sample_and_every_name(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "samples.csv"
            report.write_csv(file, [{"seconds": 1, "a": 2}, {"seconds": 2, "b": 3}])
            self.assertEqual(file.read_text().splitlines(), ["seconds,a,b", "1,2,", "2,,3"])


class Slope(unittest.TestCase):
    def test_of_a_line_is_its_own(self):
        self.assertAlmostEqual(report.slope_per_hour([(h / 100, 5 * h / 100) for h in range(100)]), 5)

    def test_of_too_few_points_is_unknown(self):
        self.assertIsNone(report.slope_per_hour([(0, 1), (1, 2)]))


if __name__ == "__main__":
    unittest.main()
