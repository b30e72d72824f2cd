"""Libraries: built, saved, opened, looked into."""

import threading
import unittest

import abrazo
import demo_set
import numpy as np


def manifest():
    return demo_set.folder() / "demo" / "manifest.json"


class Libraries(unittest.TestCase):
    def test_are_built_and_saved_as_the_command_line_does_to_the_byte(self):
        built = abrazo.Library.build(manifest())
        saved = demo_set.folder() / "saved.h5"
        built.save(saved)
        self.assertEqual(saved.read_bytes(), (demo_set.folder() / "demo.h5").read_bytes())
        self.assertEqual(len(abrazo.Library.open(saved)), len(built))

    def test_say_what_they_hold(self):
        library = demo_set.library()
        self.assertEqual([take.name for take in library.takes], ["salsa_01", "salsa_02"])
        self.assertEqual(library.takes[0].fps, 60)
        self.assertEqual(library.rate, 60)
        self.assertIn(f"{len(library)} pairs", repr(library))
        self.assertIsNone(library.damage)

    def test_leave_takes_out_and_thin(self):
        fewer = abrazo.Library.build(manifest(), exclude=["salsa_01"], rate=15)
        self.assertNotIn("salsa_01", [take.name for take in fewer.takes])
        self.assertEqual(fewer.takes[0].frame_stride, 4)
        self.assertLess(len(fewer), len(demo_set.library()) / 4)

    def test_double_when_either_may_lead(self):
        both = abrazo.Library.build(manifest(), both_roles=True)
        self.assertGreater(len(both), len(demo_set.library()))
        pair = both.find_pair("salsa_01", 10)
        other = both.find_pair("salsa_01", 10, swapped=True)
        self.assertFalse(both.source(pair).swapped)
        self.assertTrue(both.source(other).swapped)

    def test_show_features_that_belong_to_their_poses(self):
        library = demo_set.library()
        self.assertEqual(library.features.shape, (len(library), 15))
        self.assertFalse(library.features.flags.writeable)
        head_hands_feet = [16, 24, 20, 9, 4]  # of the paper's 3.2.2
        for pair in (0, 17, len(library) - 1):
            active = library.pose(pair)[0]
            np.testing.assert_array_equal(active[head_hands_feet].ravel(), library.features[pair])

    def test_find_the_pair_of_a_frame(self):
        library = demo_set.library()
        pair = library.find_pair("salsa_02", 30)
        source = library.source(pair)
        self.assertEqual((source.take, source.frame, source.pair), ("salsa_02", 30, pair))
        self.assertIsNone(library.find_pair("salsa_02", 10**6))

    def test_have_features_that_outlive_them(self):
        features = abrazo.Library.open(demo_set.folder() / "demo.h5").features
        np.testing.assert_array_equal(features, demo_set.library().features)

    def test_refuse_a_pair_that_is_not_there(self):
        library = demo_set.library()
        for pair in (-1, len(library)):
            with self.assertRaisesRegex(IndexError, f"there is no pair {pair}"):
                library.pose(pair)
            with self.assertRaises(IndexError):
                library.source(pair)


class Building(unittest.TestCase):
    def test_says_how_far_it_is(self):
        told = []
        abrazo.Library.build(manifest(), progress=lambda fraction, doing: told.append((fraction, doing)))
        self.assertTrue(told)
        self.assertTrue(all(0 <= fraction <= 1 for fraction, _ in told))
        self.assertTrue(all(isinstance(doing, str) for _, doing in told))

    def test_stops_when_it_is_told_to(self):
        with self.assertRaisesRegex(abrazo.Error, "cancelled"):
            abrazo.Library.build(manifest(), progress=lambda fraction, doing: False)

    def test_hands_on_what_the_function_raises(self):
        def impatient(fraction, doing):
            raise TimeoutError("too long")

        with self.assertRaisesRegex(TimeoutError, "too long"):
            abrazo.Library.build(manifest(), progress=impatient)


class Refusals(unittest.TestCase):
    def test_of_files_are_the_sentences_of_the_command_line(self):
        for file in (demo_set.folder() / "nowhere.h5", demo_set.leader_file()):
            with self.assertRaises(abrazo.Error) as raised:
                abrazo.Library.open(file)
            self.assertEqual(str(raised.exception), demo_set.refusal("library", "info", file))

    def test_of_manifests_too(self):
        nowhere, out = demo_set.folder() / "nowhere.json", demo_set.folder() / "x.h5"
        with self.assertRaises(abrazo.Error) as raised:
            abrazo.Library.build(nowhere)
        self.assertEqual(str(raised.exception), demo_set.refusal("library", "build", nowhere, "-o", out))

    def test_of_words_that_cannot_be(self):
        with self.assertRaisesRegex(abrazo.Error, "salsa_99"):
            abrazo.Library.build(manifest(), exclude=["salsa_99"])
        with self.assertRaisesRegex(abrazo.Error, "a rate of -1 Hz is not possible"):
            abrazo.Library.build(manifest(), rate=-1)

    def test_of_a_place_that_cannot_be_written(self):
        with self.assertRaisesRegex(abrazo.Error, "no_folder"):
            demo_set.library().save(demo_set.folder() / "no_folder" / "x.h5")


class Threads(unittest.TestCase):
    def test_build_side_by_side(self):
        built = [None, None]

        def build(index):
            built[index] = abrazo.Library.build(manifest())

        threads = [threading.Thread(target=build, args=(index,)) for index in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_array_equal(built[0].features, built[1].features)


if __name__ == "__main__":
    unittest.main()
