# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The links of the Markdown files lead somewhere, and those that lead nowhere are found."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

PAGE = """<html><body><h1 id="top">Page</h1><a name="old"></a><img src="picture.png">
{}
</body></html>"""

TEXT = """# A Heading: `code`, and more

## Twice

## Twice

{}

    [in code](nowhere.md)
"""


def faults(*files):
    run = subprocess.run([sys.executable, ROOT / "doc/standalone/check_links.py", *files], capture_output=True, text=True)
    return run.returncode, run.stderr.splitlines()


class Links(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "picture.png").write_bytes(b"")
        (self.folder / "other.html").write_text(PAGE.format(""))
        (self.folder / "other.md").write_text(TEXT.format(""))

    def check(self, name, content, path, right, wrong):
        """Each right link passes, and each wrong one is the one that is named."""
        file = self.folder / name
        for link in right:
            file.write_text(content(link))
            self.assertEqual(faults(path), (0, []), link)
        for link in wrong:
            file.write_text(content(link))
            status, lines = faults(path)
            self.assertEqual(status, 1, link)
            self.assertEqual(len(lines), 1, link)
            self.assertIn(f"the link {link} ", lines[0])

    def test_html(self):
        self.check("page.html", lambda link: PAGE.format(f'<a href="{link}">text</a>'), self.folder,
                   ["other.html", "other.html#top", "#top", "#old", "picture.png", "https://example.org/a?b=c#d"],
                   ["missing.html", "other.html#missing", "#missing", "/other.html", "https://example", "file:///other.html"])

    def test_navigation(self):
        self.check("tree.js", lambda link: f'var tree = [["Title", "{link}", null]];', self.folder,
                   ["other.html", "other.html#top"], ["missing.html", "other.html#missing"])

    def test_markdown(self):
        self.check("page.md", lambda link: TEXT.format(f"[text]({link})"), self.folder / "page.md",
                   ["other.md", "other.md#a-heading-code-and-more", "#twice", "#twice-1", "picture.png"],
                   ["missing.md", "other.md#missing", "#twice-2", "https://exa mple.org".replace(" ", "<")])

    def test_a_picture_that_is_missing(self):
        (self.folder / "picture.png").unlink()
        self.assertEqual(faults(self.folder)[0], 1)

    def test_repository(self):
        files = [file for file in ROOT.rglob("*.md")
                 if not any(part.startswith((".", "build")) for part in file.relative_to(ROOT).parts)]
        self.assertGreaterEqual(len(files), 4)
        self.assertEqual(faults(*files), (0, []))


if __name__ == "__main__":
    unittest.main()
