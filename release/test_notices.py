"""What `notices.py` takes for a permissive licence: `python3 -m unittest discover release`."""

import unittest

import notices


class Permitted(unittest.TestCase):
    def test_what_is_permissive(self) -> None:
        for good in [
            "MIT",
            "MIT/Apache-2.0",
            "MIT OR Apache-2.0 OR LGPL-2.1-or-later",
            "(MIT OR GPL-3.0-only) AND Unicode-3.0",
            "Apache-2.0 WITH LLVM-exception OR GPL-2.0-only",
            "GPL-2.0-only OR (BSD-3-Clause AND (Zlib OR GPL-2.0-only))",
        ]:
            self.assertTrue(notices.permitted(good), good)

    def test_what_is_not(self) -> None:
        for bad in [
            "GPL-3.0-only",
            "MIT AND GPL-3.0-only",
            "MPL-2.0",
            "(MIT OR Apache-2.0) AND LGPL-2.1-only",
            "GPL-2.0-only WITH Classpath-exception-2.0",
        ]:
            self.assertFalse(notices.permitted(bad), bad)

    def test_what_is_no_expression(self) -> None:
        for none in ["", "(MIT", "MIT Apache-2.0", "MIT OR"]:
            with self.assertRaises(ValueError, msg=none):
                notices.permitted(none)


class Crates(unittest.TestCase):
    def test_a_licence_that_is_not_permissive_is_told(self) -> None:
        kept = notices.PERMISSIVE.copy()
        notices.PERMISSIVE.discard("Unicode-3.0")
        try:
            told = notices.refused(notices.crates(notices.metadata([]), "bladewright"))
        finally:
            notices.PERMISSIVE |= kept
        self.assertEqual([line.split()[0] for line in told], ["unicode-ident"])


if __name__ == "__main__":
    unittest.main()
