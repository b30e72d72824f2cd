"""The partner: the same as the command line's, to the bit, whoever asks and from which thread."""

import gc
import json
import sys
import threading
import unittest

import abrazo
import demo_set
import numpy as np

LEAVE_OUT = ["salsa_01"]


def trace_of(*words):
    """What `abrazo synth` traced, a dict for each step."""
    file = demo_set.folder() / "trace.jsonl"
    demo_set.command_line(
        "synth", "--library", demo_set.folder() / "demo.h5", "--input", demo_set.leader_file(), "--trace", file, *words
    )
    return [json.loads(line) for line in file.read_text().splitlines()[1:]]


def poses(trace, key):
    return np.array([step[key] for step in trace])


def steps(partner, clip):
    """Answers a clip by hand."""
    partner.measure_user(clip)
    elapsed = 0.0
    for frame in range(len(clip)):
        yield partner.step(clip.positions[frame], elapsed)
        # As the command line has it: the difference of two times.
        elapsed = (frame + 1) / clip.fps - frame / clip.fps


class SameAsTheCommandLine(unittest.TestCase):
    def expect_same(self, words, **said):
        trace = trace_of(*words)
        run = abrazo.synthesize(demo_set.library(), demo_set.leader(), **said)
        np.testing.assert_array_equal(run.active, poses(trace, "active"))
        np.testing.assert_array_equal(run.passive, poses(trace, "passive"))
        np.testing.assert_array_equal(run.times, [step["time"] for step in trace])
        return trace, run

    def test_by_the_paper(self):
        self.expect_same(["--exclude", "salsa_01", "--preset", "paper"], exclude=LEAVE_OUT, preset="paper")

    def test_by_intent(self):
        self.expect_same(["--preset", "responsive"], preset="responsive")

    def test_with_settings(self):
        self.expect_same(
            ["--alpha", "0.1", "--foot-locks", "off", "--edge-weights", "uniform", "-k", "5"],
            settings={"alpha": 0.1, "foot-locks": False, "edge-weights": "uniform", "neighbours": 5},
        )

    def test_for_a_user_who_follows(self):
        self.expect_same(["--user-role", "passive"], settings={"user-role": "passive"})

    def test_frame_by_frame_with_its_reasons(self):
        trace, run = self.expect_same([])
        for step, frame in zip(trace, run.frames, strict=True):
            np.testing.assert_array_equal(frame.query_world, step["query"]["world"])
            np.testing.assert_array_equal(frame.query_normalized, step["query"]["normalized"])
            np.testing.assert_array_equal(frame.features, step["query"]["features"])
            np.testing.assert_array_equal(frame.selected_pair[0], step["selected_pair"]["active"])
            np.testing.assert_array_equal(frame.edges, step["mesh"]["edges"])
            np.testing.assert_array_equal(frame.tetrahedra, step["mesh"]["tetrahedra"])
            self.assertEqual(frame.status, step["status"])
            self.assertEqual(frame.selected, step["selected"])
            self.assertEqual(frame.source_changed, step["source_changed"])
            self.assertEqual(frame.foot_locks, step["foot_locks"])
            for name in ("deformation", "velocity", "constraint"):
                self.assertEqual(getattr(frame.energy, name), step["energy"][name])
            for name in ("bone_length_max", "foot_lock_max_m", "penetration_max_m", "morph_rms_m"):
                self.assertEqual(getattr(frame.residual, name), step["residual"][name])
            for candidate, traced in zip(frame.candidates, step["candidates"], strict=True):
                self.assertEqual(candidate.source.take, traced["take"])
                self.assertEqual(candidate.source.frame, traced["frame"])
                self.assertEqual(candidate.feature_distance, traced["feature_distance"])
                self.assertEqual(candidate.cost.total, traced["cost"]["total"])
            self.assertEqual(frame.source.frame, step["candidates"][step["selected"]]["frame"])

    def test_step_by_step(self):
        run = abrazo.synthesize(demo_set.library(), demo_set.leader())
        by_hand = list(steps(abrazo.Synthesizer(demo_set.library()), demo_set.leader()))
        np.testing.assert_array_equal([frame.passive for frame in by_hand], run.passive)
        np.testing.assert_array_equal([frame.active for frame in by_hand], run.active)

    def test_in_the_files_it_writes(self):
        run = abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False)
        for ending in ("bvh", "csv", "glb"):
            ours, theirs = (demo_set.folder() / f"{name}.{ending}" for name in ("ours", "theirs"))
            run.save(ours)
            demo_set.command_line(
                "synth", "--library", demo_set.folder() / "demo.h5", "--input", demo_set.leader_file(), "-o", theirs
            )
            self.assertEqual(ours.read_bytes(), theirs.read_bytes(), ending)

    def test_in_its_summary(self):
        printed = json.loads(
            demo_set.command_line(
                "synth", "--library", demo_set.folder() / "demo.h5", "--input", demo_set.leader_file(), "--json"
            )
        )
        summary = abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False).summary
        for measured in (printed, summary):
            measured.pop("solve_us")  # how long it took
        self.assertEqual(summary, printed)


class Costs(unittest.TestCase):
    """Eq. 7, reckoned again in NumPy."""

    def test_of_the_pose_are_distances_to_the_recorded_pair(self):
        library = demo_set.library()
        for frame in abrazo.synthesize(library, demo_set.leader(), preset="paper").frames:
            for candidate in frame.candidates:
                recorded = library.pose(candidate.pair)[0]
                pose = np.sum((frame.query_normalized - recorded) ** 2)
                np.testing.assert_allclose(candidate.cost.pose, pose, rtol=1e-9)

    def test_add_up_with_alpha_and_the_least_wins(self):
        run = abrazo.synthesize(demo_set.library(), demo_set.leader(), preset="paper", settings={"alpha": 0.3})
        for frame in run.frames:
            costs = [candidate.cost for candidate in frame.candidates]
            for cost in costs:
                temporal = cost.temporal_active + cost.temporal_passive
                np.testing.assert_allclose(cost.total, cost.pose + 0.3 * temporal, rtol=1e-12)
            self.assertEqual(frame.selected, int(np.argmin([cost.total for cost in costs])))
            self.assertIsNone(frame.candidates[0].intent)

    def test_of_intent_decide_with_that_preset(self):
        for frame in abrazo.synthesize(demo_set.library(), demo_set.leader(), preset="responsive").frames:
            totals = [candidate.intent.total for candidate in frame.candidates if candidate.intent]
            if len(totals) == len(frame.candidates):
                self.assertEqual(frame.selected, int(np.argmin(totals)))


class Stepping(unittest.TestCase):
    def setUp(self):
        self.partner = abrazo.Synthesizer(demo_set.library(), preset="paper")
        self.user = demo_set.leader().positions

    def test_selects_what_is_pinned(self):
        self.partner.pin(12)
        self.assertEqual(self.partner.step(self.user[0], 0).source.pair, 12)
        self.partner.pin(None)
        self.assertNotEqual(self.partner.step(self.user[200], 1 / 60).source.pair, 12)

    def test_goes_on_from_a_state_to_the_same_bits(self):
        self.partner.step(self.user[0], 0)
        state = self.partner.state()
        first = self.partner.step(self.user[1], 1 / 60)
        self.partner.step(self.user[90], 1 / 60)
        self.partner.restore(state)
        again = self.partner.step(self.user[1], 1 / 60)
        np.testing.assert_array_equal(first.passive, again.passive)

    def test_selects_with_a_cost_from_outside(self):
        """Looks at the candidates, goes back, pins: with Eq. 7 as the cost the same bits."""
        clip = demo_set.leader()
        run = abrazo.synthesize(demo_set.library(), clip, preset="paper", keep_frames=False)
        self.partner.measure_user(clip)
        for step, time in enumerate(run.times):
            elapsed = time - run.times[step - 1] if step else 0
            user = clip.positions[4 * step]
            before = self.partner.state()
            seen = self.partner.step(user, elapsed)
            best = min(seen.candidates, key=lambda candidate: candidate.cost.total)
            self.partner.restore(before)
            self.partner.pin(best.pair)
            frame = self.partner.step(user, elapsed)
            self.partner.pin(None)
            self.assertEqual(frame.source.pair, best.pair)
            np.testing.assert_array_equal(frame.passive, run.passive[step])

    def test_begins_anew_after_a_reset(self):
        first = self.partner.step(self.user[0], 0)
        self.partner.step(self.user[1], 1 / 60)
        self.partner.reset()
        np.testing.assert_array_equal(self.partner.step(self.user[0], 0).passive, first.passive)

    def test_takes_settings_on_the_way(self):
        self.assertEqual(self.partner.settings["alpha"], 0.5)
        self.partner.change_settings({"alpha": 0.25})
        self.assertEqual(self.partner.settings["alpha"], 0.25)
        self.assertEqual(self.partner.settings["neighbours"], 10)

    def test_says_in_the_status_that_a_pose_cannot_be_answered(self):
        good = self.partner.step(self.user[0], 0)
        lost = np.array(self.user[1])
        lost[3, 1] = np.nan
        failed = self.partner.step(lost, 1 / 60)
        self.assertTrue(failed.status.startswith("failed: "), failed.status)
        np.testing.assert_array_equal(failed.passive, good.passive)
        masked = np.ma.array(self.user[1])
        masked[3] = np.ma.masked
        self.assertTrue(self.partner.step(masked, 1 / 60).status.startswith("failed: "))

    def test_refuses_another_shape(self):
        for shape in ((24, 3), (25, 2), (1, 25, 3), (75,)):
            with self.assertRaisesRegex(ValueError, r"user has the shape .*; \(25, 3\) is expected"):
                self.partner.step(np.zeros(shape), 0)
        with self.assertRaises((TypeError, ValueError)):
            self.partner.step("pose", 0)

    def test_refuses_a_time_that_is_none(self):
        for elapsed in (-0.1, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "elapsed is"):
                self.partner.step(self.user[0], elapsed)


class Refusals(unittest.TestCase):
    def test_of_a_setting_name_those_there_are(self):
        with self.assertRaises(abrazo.Error) as raised:
            abrazo.Synthesizer(demo_set.library(), settings={"alfa": 1})
        sentence = str(raised.exception)
        self.assertIn("'alfa' is not a setting; there are selection, alpha, neighbours", sentence)
        for name in abrazo.Synthesizer(demo_set.library()).settings:
            self.assertIn(name, sentence)

    def test_of_values_say_what_is_possible(self):
        for settings in ({"alpha": -1}, {"alpha": "much"}, {"neighbours": 0}, {"edge-weights": "round"}):
            with self.assertRaisesRegex(abrazo.Error, "cannot be used|expected"):
                abrazo.synthesize(demo_set.library(), demo_set.leader(), settings=settings)
        with self.assertRaises(ValueError):
            abrazo.Synthesizer(demo_set.library(), settings={"alpha": float("nan")})

    def test_of_a_preset_name_both(self):
        with self.assertRaisesRegex(abrazo.Error, "'fast' is not a preset; use paper or responsive"):
            abrazo.Synthesizer(demo_set.library(), preset="fast")

    def test_of_takes_are_the_sentence_of_the_command_line(self):
        said = demo_set.refusal(
            "synth", "--library", demo_set.folder() / "demo.h5", "--input", demo_set.leader_file(), "--exclude", "x"
        )
        with self.assertRaises(abrazo.Error) as raised:
            abrazo.Synthesizer(demo_set.library(), exclude=["x"])
        self.assertEqual(str(raised.exception), said)

    def test_of_a_clip_without_frames(self):
        nothing = abrazo.Clip(np.zeros((0, 25, 3)), fps=60, name="nobody")
        with self.assertRaisesRegex(abrazo.Error, "nobody: the input has no frames"):
            abrazo.synthesize(demo_set.library(), nothing)
        with self.assertRaisesRegex(abrazo.Error, "nobody: has no frames"):
            abrazo.Synthesizer(demo_set.library()).measure_user(nothing)


class Arrays(unittest.TestCase):
    def test_of_a_frame_outlive_the_synthesizer(self):
        run = abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False)
        partner = abrazo.Synthesizer(abrazo.Library.open(demo_set.folder() / "demo.h5"))
        kept = [(frame.passive, frame.energy) for frame in steps(partner, demo_set.leader())]
        del partner
        gc.collect()
        np.testing.assert_array_equal([passive for passive, _ in kept], run.passive)
        self.assertGreater(kept[-1][1].constraint, 0)

    def test_of_a_frame_do_not_change_with_the_next_step(self):
        partner = abrazo.Synthesizer(demo_set.library())
        first = partner.step(demo_set.leader().positions[0], 0).passive
        before = first.copy()
        partner.step(demo_set.leader().positions[60], 1 / 60)
        np.testing.assert_array_equal(first, before)

    def test_of_a_run_outlive_it(self):
        run = abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False)
        passive, again = run.passive, run.passive.copy()
        del run
        gc.collect()
        np.testing.assert_array_equal(passive, again)

    def test_are_read_only_views(self):
        frame = abrazo.Synthesizer(demo_set.library()).step(demo_set.leader().positions[0], 0)
        for name in ("active", "passive", "query_world", "selected_pair", "edges", "features", "morph_steps"):
            self.assertFalse(getattr(frame, name).flags.writeable, name)
            self.assertTrue(np.shares_memory(getattr(frame, name), getattr(frame, name)), name)
        self.assertTrue(np.shares_memory(frame.active, frame.morph_steps) or len(frame.morph_steps))

    def test_may_be_left_out(self):
        self.assertEqual(abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False).frames, [])


class Threads(unittest.TestCase):
    def test_have_synthesizers_that_do_not_meet(self):
        runs = {
            preset: abrazo.synthesize(demo_set.library(), demo_set.leader(), settings={"alpha": alpha})
            for preset, alpha in (("one", 0.5), ("two", 0.1))
        }
        answers = {}

        def answer(name, alpha):
            partner = abrazo.Synthesizer(demo_set.library(), settings={"alpha": alpha})
            answers[name] = [frame.passive for frame in steps(partner, demo_set.leader())]

        threads = [threading.Thread(target=answer, args=pair) for pair in (("one", 0.5), ("two", 0.1))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for name, run in runs.items():
            np.testing.assert_array_equal(answers[name], run.passive)

    def test_may_share_a_synthesizer(self):
        partner = abrazo.Synthesizer(demo_set.library())
        user = demo_set.leader().positions
        statuses = []

        def answer():
            for frame in range(100):
                statuses.append(partner.step(user[frame], 1 / 60).status)

        threads = [threading.Thread(target=answer) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(statuses), 400)
        self.assertFalse([status for status in statuses if status.startswith("failed")])

    def expect_others_run_during(self, work):
        """Nobody is made to hand over: another thread runs only when the work itself lets go."""
        go, ran = threading.Lock(), threading.Event()
        go.acquire()

        def other():
            with go:
                ran.set()

        thread = threading.Thread(target=other)
        thread.start()
        interval = sys.getswitchinterval()
        sys.setswitchinterval(1000)
        try:
            go.release()
            work(ran)
        finally:
            sys.setswitchinterval(interval)
        thread.join()

    def test_run_while_a_clip_is_answered(self):
        def work(ran):
            abrazo.synthesize(demo_set.library(), demo_set.leader())
            self.assertTrue(ran.is_set())

        self.expect_others_run_during(work)

    def test_run_while_a_frame_is_solved(self):
        partner = abrazo.Synthesizer(demo_set.library())
        user = demo_set.leader().positions[0]

        def work(ran):
            for _ in range(5000):  # a step may end before the other thread woke up
                partner.step(user, 1 / 60)
                if ran.is_set():
                    break
            self.assertTrue(ran.is_set())

        self.expect_others_run_during(work)


if __name__ == "__main__":
    unittest.main()
