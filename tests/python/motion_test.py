"""Motions: files and arrays."""

import unittest

import abrazo
import demo_set
import numpy as np


class Clips(unittest.TestCase):
    def test_are_25_joints_in_metres(self):
        clip = demo_set.leader()
        self.assertEqual(clip.positions.shape, (len(clip), 25, 3))
        self.assertEqual(clip.positions.dtype, np.float64)
        self.assertEqual(clip.fps, 60)
        self.assertEqual(clip.joints, abrazo.JOINTS)
        self.assertEqual(clip.joints[16], "head")
        self.assertAlmostEqual(clip.duration, len(clip) / 60)
        self.assertTrue(1.2 < np.median(clip.positions[:, 16, 1]) < 2.0)

    def test_are_what_the_command_line_reads_to_the_bit(self):
        table = demo_set.folder() / "leader.csv"
        demo_set.command_line("motion", "positions", demo_set.leader_file(), "-o", table)
        rows = [line.split(",") for line in table.read_text().splitlines() if not line.startswith("#")]
        numbers = np.array([[float(field) for field in row[2:]] for row in rows[1:]])
        np.testing.assert_array_equal(numbers.reshape(-1, 25, 3), demo_set.leader().positions)

    def test_are_read_from_scenes_by_the_program_beside_the_module(self):
        scene = demo_set.folder() / "leader.glb"
        demo_set.command_line("motion", "convert", demo_set.leader_file(), "-o", scene)
        np.testing.assert_allclose(abrazo.read_motion(scene).positions, demo_set.leader().positions, atol=1e-4)

    def test_show_their_positions_without_a_copy(self):
        clip = demo_set.leader()
        self.assertTrue(np.shares_memory(clip.positions, clip.positions))
        self.assertFalse(clip.positions.flags.writeable)
        with self.assertRaises(ValueError):
            clip.positions[0, 0, 0] = 0

    def test_keep_their_positions_while_an_array_is_left(self):
        positions = abrazo.read_motion(demo_set.leader_file()).positions
        np.testing.assert_array_equal(positions, demo_set.leader().positions)

    def test_are_made_of_arrays_of_any_layout(self):
        positions = demo_set.leader().positions
        for same in (np.asfortranarray(positions), positions.tolist(), positions[::-1][::-1]):
            np.testing.assert_array_equal(abrazo.Clip(same, fps=60).positions, positions)

    def test_say_what_was_guessed(self):
        self.assertIn("units: the file does not state its unit", demo_set.leader().warnings[0])
        self.assertEqual(abrazo.read_motion(demo_set.leader_file(), metres_per_unit=1).warnings, [])

    def test_follow_what_is_said_of_the_file(self):
        clip = abrazo.read_motion(demo_set.leader_file(), metres_per_unit=2, fps=30)
        self.assertEqual(clip.fps, 30)
        np.testing.assert_allclose(
            np.ptp(clip.positions[:, 0, 0]), 2 * np.ptp(demo_set.leader().positions[:, 0, 0])
        )

    def test_refuse_another_shape(self):
        with self.assertRaisesRegex(ValueError, r"shape \(4, 24, 3\); \(T, 25, 3\) is expected"):
            abrazo.Clip(np.zeros((4, 24, 3)), fps=60)
        with self.assertRaisesRegex(ValueError, r"shape \(25, 3\)"):
            abrazo.Clip(np.zeros((25, 3)), fps=60)

    def test_refuse_what_is_not_finite_and_name_the_joint(self):
        positions = np.array(demo_set.leader().positions)
        positions[7, 20, 1] = np.nan
        with self.assertRaisesRegex(ValueError, r"frame 7, joint 20 \(lhand\) are not finite"):
            abrazo.Clip(positions, fps=60)

    def test_refuse_what_is_masked_and_name_the_joint(self):
        positions = np.ma.array(demo_set.leader().positions)
        np.testing.assert_array_equal(abrazo.Clip(positions, fps=60).positions, positions)
        positions[7, 20] = np.ma.masked
        with self.assertRaisesRegex(ValueError, r"frame 7, joint 20 \(lhand\) are not finite"):
            abrazo.Clip(positions, fps=60)

    def test_refuse_a_rate_that_is_none(self):
        for fps in (0, -60, float("nan"), float("inf")):
            with self.assertRaisesRegex(ValueError, "fps is"):
                abrazo.Clip(demo_set.leader().positions, fps=fps)


class Refusals(unittest.TestCase):
    """The sentences of the command line."""

    def same(self, words, **said):
        file = words[0]
        with self.assertRaises(abrazo.Error) as raised:
            abrazo.read_motion(file, **said)
        self.assertEqual(str(raised.exception), demo_set.refusal("motion", "info", *words))

    def test_of_a_file_that_is_not_there(self):
        self.same([demo_set.folder() / "nowhere.bvh"])

    def test_of_a_file_of_another_kind(self):
        self.same([demo_set.folder() / "demo.h5"])

    def test_of_a_skeleton_where_there_is_one(self):
        with self.assertRaisesRegex(abrazo.Error, r"leave out the other one \(skeleton\)$"):
            abrazo.read_motion(demo_set.leader_file(), skeleton="x.asf")

    def test_of_a_joint_map_that_does_not_exist(self):
        self.same([demo_set.leader_file(), "--joint-map", "nothing"], joint_map="nothing")

    def test_of_numbers_and_axes_that_cannot_be(self):
        for said in ({"fps": 0}, {"fps": -1}, {"metres_per_unit": float("nan")}):
            with self.assertRaisesRegex(abrazo.Error, "expected a number above 0, found"):
                abrazo.read_motion(demo_set.leader_file(), **said)
        with self.assertRaisesRegex(abrazo.Error, "'w' is not an axis; use y, z, -y, -z, x or -x"):
            abrazo.read_motion(demo_set.leader_file(), up="w")

    def test_of_a_performer_that_is_not_there(self):
        pair = demo_set.folder() / "two.bvh"
        abrazo.synthesize(demo_set.library(), demo_set.leader(), keep_frames=False).save(pair)
        with self.assertRaisesRegex(abrazo.Error, "two.bvh: holds 2 performers: 1 active, 2 passive; choose one"):
            abrazo.read_motion(pair)
        with self.assertRaisesRegex(abrazo.Error, "two.bvh: has no performer 3; it holds 1 active, 2 passive"):
            abrazo.read_motion(pair, performer=3)
        self.assertEqual(abrazo.read_motion(pair, performer=2).name, "passive")
        self.assertEqual(abrazo.read_motion(pair, performer="passive").name, "passive")


if __name__ == "__main__":
    unittest.main()
