"""Recorded sessions: their frames, one after the other."""

import contextlib
import functools
import gc
import json
import sqlite3
import unittest

import abrazo
import demo_set
import numpy as np


@functools.cache
def recorded():
    """A session of a second and a half."""
    file = demo_set.folder() / "evening.abrazo"
    demo_set.command_line(
        "live", "--library", demo_set.folder() / "demo.h5", "--listen", f"clip:{demo_set.leader_file()}",
        "--seconds", "1.5", "--alpha", "0.3", "--record", file,
    )  # fmt: skip
    return file


class Sessions(unittest.TestCase):
    def test_give_their_frames_in_order(self):
        session = abrazo.open_session(recorded())
        frames = list(session.frames())
        self.assertEqual(len(frames), len(session))
        self.assertGreater(len(frames), 10)
        self.assertEqual([frame.index for frame in frames], list(range(len(frames))))
        times = [frame.time for frame in frames]
        self.assertEqual(times, sorted(times))
        self.assertEqual((times[0], times[-1]), (session.first, session.last))

    def test_have_what_was_recorded(self):
        frame = list(abrazo.open_session(recorded()).frames())[-1]
        self.assertEqual(frame.passive.shape, (25, 3))
        self.assertEqual(frame.settings["alpha"], 0.3)
        clip = demo_set.leader().positions
        self.assertTrue((np.abs(clip - frame.user).max(axis=(1, 2)) < 1e-6).any())
        np.testing.assert_allclose(frame.query_world.mean(), frame.active.mean(), atol=0.1)

    def test_are_those_that_the_command_line_exports(self):
        out = demo_set.folder() / "evening.jsonl"
        demo_set.command_line("export", recorded(), "--what", "trace", "-o", out)
        lines = [json.loads(line) for line in out.read_text().splitlines()]
        exported = [line for line in lines if "passive" in line]
        frames = list(abrazo.open_session(recorded()).frames())
        self.assertEqual(len(frames), len(exported))
        for frame, line in zip(frames, exported, strict=True):
            np.testing.assert_array_equal(frame.passive, line["passive"])
            self.assertEqual(frame.source.frame, line["candidates"][line["selected"]]["frame"])

    def test_find_their_library_for_mesh_and_sources(self):
        session = abrazo.open_session(recorded())
        self.assertEqual(session.warnings, [])
        for frame in session.frames():
            self.assertIn(frame.source.take, ("salsa_01", "salsa_02"))
            self.assertGreater(len(frame.edges), 50)

    def test_show_bodies_also_without_their_library(self):
        away = demo_set.folder() / "away"
        away.mkdir()
        session_file = away / "alone.abrazo"
        session_file.write_bytes(recorded().read_bytes())
        library = demo_set.folder() / "demo.h5"
        hidden = library.rename(library.with_suffix(".hidden"))
        try:
            session = abrazo.open_session(session_file)
            frame = next(session.frames())
        finally:
            hidden.rename(library)
        self.assertIn("demo.h5", " ".join(session.warnings))
        self.assertIsNone(frame.source)
        self.assertEqual(len(frame.edges), 0)
        self.assertTrue(np.isfinite(frame.passive).all())
        found = abrazo.open_session(session_file, library=library)
        self.assertIsNotNone(next(found.frames()).source)

    def test_have_frames_that_outlive_them(self):
        session = abrazo.open_session(recorded())
        passive = [frame.passive for frame in session.frames()]
        iterator = session.frames()
        del session
        gc.collect()
        np.testing.assert_array_equal(passive, [frame.passive for frame in iterator])

    def test_say_which_frame_cannot_be_read_and_go_on(self):
        broken = demo_set.folder() / "broken.abrazo"
        broken.write_bytes(recorded().read_bytes())
        with contextlib.closing(sqlite3.connect(broken)) as database:
            database.execute("UPDATE frames SET active = zeroblob(10) WHERE frame = 3")
            database.commit()
        session = abrazo.open_session(broken)
        for _ in range(2):
            frames = session.frames()
            self.assertEqual([next(frames).index for _ in range(3)], [0, 1, 2])
            with self.assertRaisesRegex(abrazo.Error, "broken.abrazo: its frame 3 cannot be read: "):
                next(frames)
            self.assertEqual(next(frames).index, 4)

    def test_may_be_gone_through_again(self):
        session = abrazo.open_session(recorded())
        self.assertEqual(len(list(session.frames())), len(list(session.frames())))
        frames = session.frames()
        list(frames)
        with self.assertRaises(StopIteration):
            next(frames)

    def test_are_refused_with_the_sentence_of_the_command_line(self):
        nowhere = demo_set.folder() / "nowhere.abrazo"
        for file in (nowhere, demo_set.leader_file()):
            with self.assertRaises(abrazo.Error) as raised:
                abrazo.open_session(file)
            self.assertEqual(str(raised.exception), demo_set.refusal("session", "info", file))


if __name__ == "__main__":
    unittest.main()
