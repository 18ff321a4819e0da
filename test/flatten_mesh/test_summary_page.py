# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that `flatten_mesh --summary` writes with `--report`, in a real browser, against the table of the same
reports. Most reports are made up here, with names and messages that are no good HTML."""

import csv
import io
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "report_page"))
# pylint: disable=wrong-import-position
from chromium import Chromium, missing_programs

SKIPPED = 77  # what CTest takes for it
SIZE = 1180, 700
NAMES = ("</script><b>", "&amp;", "\"quo'ted\"", "<!--", "line\nbreak", "süß", "a,b", "\\u003c", "%s", " ")
STATUSES = {"OK": 0, "STRETCH_BOUND_MISSED": 1, "WRONG_INPUT": 2, "TIMED_OUT": 3, "CRASHED": 5, "<i>NEW</i>": 7}
NUMBERS = ("triangles", "charts", "density", "stretch", "seam", "seconds", "peak_memory_mb")  # as the page has them
MOST_WORST = 20


def made_up_report(generator: random.Random, name: str) -> dict:
    """As the program writes them"""
    status = generator.choices(list(STATUSES), (8, 1, 1, 1, 1, 1))[0]
    message = "" if status == "OK" else f"'{name}': it is {generator.choice(NAMES)}"
    report = {"status": status, "message": message, "input": f"in/{name}.off", "exit_status": STATUSES[status]}
    if status in ("OK", "STRETCH_BOUND_MISSED"):
        charts = [{"triangles": generator.randrange(1, 10**6), "share_of_area": generator.random(),
                   "method": generator.choice(("direct", "injective <a>")),
                   "l2_stretch": None if generator.random() < 0.01 else 1 + 10**generator.uniform(-6, 1)}
                  for _ in range(generator.randrange(1, 9))]
        covered, stretch = generator.random(), 1 + generator.random()
        report |= {"triangles": int(10**generator.uniform(0, 7)),
                   "atlas": {"charts": charts, "l2_stretch": stretch, "seams": {"relative_length": generator.random()},
                             "packing": generator.choice((None, {"covered_share": covered,
                                                                 "texel_density": covered / stretch**2}))},
                   "seconds": {"read": 10**generator.uniform(-4, 4), "write": generator.random() / 10},
                   "peak_memory_mb": generator.choice((None, generator.uniform(1, 10**5)))}
    return report


class SummaryPage(unittest.TestCase):
    """A browser with the page of 300 reports"""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.reports = cls.write_reports(cls.folder / "out", 300)
        cls.table = cls.summarize(cls.folder / "out", cls.folder / "page.html")
        cls.browser = Chromium(SIZE)
        cls.addClassCleanup(cls.browser.close)

    @staticmethod
    def write_reports(folder: Path, count: int) -> dict[str, dict]:
        """By their names"""
        generator, reports = random.Random(count), {}
        folder.mkdir()
        for k in range(count):
            name = f"{generator.choice(NAMES)}{k}".replace("/", "∕")
            reports[name] = made_up_report(generator, name)
            (folder / f"{name}.json").write_text(json.dumps(reports[name]), encoding="utf-8")
        for name, text in (("<b>damaged", '{"status": "OK", "inp'), ("number", '{"status": "OK", "input": "a", '
                           '"exit_status": 0, "triangles": "many"}')):
            (folder / f"{name}.json").write_text(text, encoding="utf-8")
        return reports

    @staticmethod
    def summarize(folder: Path, page: Path) -> list[dict]:
        """The rows of the table that is written together with the page"""
        table = page.with_suffix(".csv")
        subprocess.run([os.environ["ABF_FLATTEN_MESH"], "--summary", str(folder), "--report", str(page), "--output",
                        str(table), "--quiet"], check=True)
        with io.StringIO(table.read_bytes().decode(errors="replace"), newline="") as text:
            return list(csv.DictReader(text))

    def setUp(self):
        self.browser.open(self.folder / "page.html")

    def tearDown(self):
        self.browser.resize(*SIZE)
        self.assertEqual(self.browser.complaints(), [])

    def run_on_all(self, selector: str, expression: str) -> list:
        """The values of an expression for each element"""
        return self.browser.run(f"return [...document.querySelectorAll(arguments[0])].map((part) => {expression});",
                                selector)

    def click(self, selector: str) -> None:
        """On an element"""
        self.browser.run("document.querySelector(arguments[0]).click();", selector)

    def rows(self) -> list[list[str]]:
        """Name, message and the other cells of each model"""
        self.click("#models .more")
        return self.run_on_all("#models tbody tr", "[part.querySelector('div').firstChild.textContent,"
                               "part.querySelector('p')?.textContent || '', ...[...part.cells].slice(1)"
                               ".map((cell) => cell.textContent)]")

    @staticmethod
    def words_of_rows(table: list[dict]) -> list[list[str]]:
        """Of the table"""
        return [[row["name"], row["message"], row["status"]] for row in table]

    def test_rows_are_those_of_the_table(self):
        self.assertEqual(self.run_on_all("#models tbody", "part.children.length"), [100])
        rows = self.rows()
        self.assertEqual([row[:3] for row in rows], self.words_of_rows(self.table))
        self.assertEqual({row[0] for row in rows}, set(self.reports))
        for row, expected in zip(rows, self.table):
            for text, name in zip(row[3:], NUMBERS):
                self.assertEqual(text == "", expected[name] == "", (row, name))
                if text:
                    shown, number = float(text.replace(",", "").replace("−", "-")), float(expected[name])
                    self.assertAlmostEqual(shown, number, delta=0.006 * number)

    def test_columns_sort(self):
        for k, name in enumerate(NUMBERS):
            known = [float(row[name]) for row in self.table if row[name]]
            for largest_first in (True, False):
                self.click(f"#models thead th:nth-child({k + 3}) button")
                order = [row[0] for row in self.rows()]
                values = {row["name"]: row[name] for row in self.table}
                sorted_values = [float(values[model]) if values[model] else math.nan for model in order]
                self.assertEqual(sorted_values[:len(known)], sorted(known, reverse=largest_first), name)
                self.assertEqual(len(order), len(self.table))
        self.click("#models thead th:nth-child(1) button")
        self.assertEqual([row[0] for row in self.rows()], sorted(self.reports))

    def test_statuses_are_counted_and_select_models(self):
        told = self.run_on_all("#statuses tr", "[part.querySelector('button').textContent, part.cells[1].textContent]")
        counts = Counter(report["status"] for report in self.reports.values())
        self.assertEqual({status: int(count) for status, count in told}, counts)
        self.assertEqual([int(count) for _, count in told], sorted(counts.values(), reverse=True))
        for k, (status, count) in enumerate(told):
            self.click(f"#statuses tr:nth-child({k + 1}) button")
            rows = self.rows()
            self.assertEqual((len(rows), {row[2] for row in rows}), (int(count), {status}))
            self.assertEqual(self.run_on_all("#statuses [aria-pressed=true]", "part.textContent"), [status])
        self.click(f"#statuses tr:nth-child({len(told)}) button")
        self.assertEqual(len(self.rows()), len(self.table))

    def test_worst_charts(self):
        charts = [(chart["l2_stretch"] or math.inf, row["name"], i) for row in self.table
                  for i, chart in enumerate(self.reports[row["name"]].get("atlas", {}).get("charts", []))]
        expected = sorted(charts, key=lambda chart: -chart[0])[:MOST_WORST]
        self.assertEqual(expected[0][0], math.inf)
        self.assertLess(expected[-1][0], math.inf)
        rows = self.run_on_all("#worst tbody tr", "[...part.cells].map((cell) => cell.textContent)")
        self.assertEqual([(row[0], int(row[1]) - 1) for row in rows], [chart[1:] for chart in expected])
        for row, (stretch, name, i) in zip(rows, expected):
            self.assertAlmostEqual(1 / float(row[2].replace("∞", "inf")), 1 / stretch, places=3)
            chart = self.reports[name]["atlas"]["charts"][i]
            self.assertEqual((int(row[3].replace(",", "")), row[5]), (chart["triangles"], chart["method"]))

    def test_plots_show_all_values(self):
        timed, dense = ([float(row[name]) for row in self.table if row[name]] for name in ("seconds", "density"))
        counts = self.run_on_all("#time rect", "Number(part.dataset.count)")
        self.assertEqual(sum(counts), len(timed))
        self.assertGreater(sum(count > 0 for count in counts), 5)
        bins = [0] * 20
        for density in dense:
            bins[int(20 * density)] += 1
        self.assertEqual(self.run_on_all("#density rect", "Number(part.dataset.count)"), bins)
        for plot in ("#time", "#density"):
            bars = self.run_on_all(f"{plot} rect", "[Number(part.dataset.count), part.getBBox().height]")
            scale = max(height for _, height in bars) / max(count for count, _ in bars)
            for count, height in bars:
                self.assertAlmostEqual(height, scale * count, places=2)
        self.check_points()

    def check_points(self):
        """Places are logarithms."""
        points = self.run_on_all("#size circle", "[part.cx.baseVal.value, part.cy.baseVal.value,"
                                 "part.classList.contains('failed'), part.textContent]")
        expected = [row for row in self.table if row["seconds"] and row["triangles"]]
        self.assertEqual(len(points), len(expected))
        for column, place, sign in (("triangles", 0, 1), ("seconds", 1, -1)):
            pairs = sorted((math.log10(max(float(row[column]), 0.001)), point[place])
                           for row, point in zip(expected, points))
            (low, first), (high, last) = pairs[0], pairs[-1]
            self.assertGreater(sign * (last - first), 100)
            for value, x in pairs:
                self.assertAlmostEqual(x, first + (value - low) / (high - low) * (last - first), delta=0.01)
        for row, (_, _, failed, text) in zip(expected, points):
            self.assertEqual(failed, row["exit_status"] != "0")
            self.assertTrue(text.startswith(row["name"] + ": "))

    def test_what_is_left_out_is_named(self):
        files = [str(self.folder / "out" / f"{name}.json") for name in ("<b>damaged", "number")]
        self.assertEqual(self.run_on_all("#left-out li", "part.textContent"), files)

    def test_names_are_no_elements_and_nothing_is_asked_of_the_network(self):
        self.rows()
        self.assertEqual(self.run_on_all("b, i, a, img", "part.outerHTML"), [])
        asked = self.browser.run("return performance.getEntriesByType('resource').map((entry) => entry.name);")
        self.assertEqual([address for address in asked if not address.startswith("data:")], [])

    def test_narrow_windows_do_not_scroll_sideways(self):
        for width in (380, 768, 1024):
            self.browser.resize(width, 800)
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth;"), width)

    def test_few_reports(self):
        """Of the program, with and without a value for each plot"""
        out = self.folder / "few"
        (self.folder / "a.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", encoding="utf-8")
        for inputs, status in ((["absent.off"], 2), (["a.off", "absent.off"], 2)):
            outputs = ["--output-folder", str(out), "--json", "%.json", "--quiet"]
            run = subprocess.run([os.environ["ABF_FLATTEN_MESH"], *inputs, *outputs], cwd=self.folder,
                                 stderr=subprocess.DEVNULL, check=False)
            self.assertEqual(run.returncode, status)
            table = self.summarize(out, self.folder / "few.html")
            self.browser.open(self.folder / "few.html")
            self.assertEqual([row[:3] for row in self.rows()], self.words_of_rows(table))
            self.assertEqual(len(self.run_on_all(".plot", "part.tagName")), 3 * (len(inputs) - 1))
            self.assertEqual(self.run_on_all("#left-out", "part.hidden"), [True])


if __name__ == "__main__":
    if missing_programs():
        print(f"skipped: {' and '.join(missing_programs())} not found")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
