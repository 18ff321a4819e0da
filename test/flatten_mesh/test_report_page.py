# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages that `flatten_mesh --report` writes, in a real browser"""

import io
import json
import math
import os
import re
import sys
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "report_page"))
# pylint: disable=wrong-import-position
from chromium import Chromium, missing_programs, move
from pages import ReportData, boxy_surface, wavy_sheet, write_report

try:
    from PIL import Image
except ImportError:
    Image = None

SKIPPED = 77  # what CTest takes for it
SIZE = 1180, 700
HIGHLIGHT = 0, 214, 240
ESCAPE, ARROW_RIGHT, HOME = "\ue00c", "\ue014", "\ue011"
MEASURES = "angle_change", "area_change", "stretch_ratio"


def setUpModule():  # pylint: disable=invalid-name
    """One browser serves all."""
    folder = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
    unittest.addModuleCleanup(folder.cleanup)
    PageTest.folder = Path(folder.name)
    for name, sides, rounded in (("cube", 4, False), ("sphere", 10, True)):
        surface = PageTest.folder / f"{name}.obj"
        surface.write_text(boxy_surface(sides, rounded), encoding="utf-8")
        write_page(name, surface, "--charts-from-materials")
    write_page("dinosaur", Path(os.environ["ABF_EXAMPLES_DIR"]) / "dinosaur.off")
    PageTest.browser = Chromium(SIZE)
    unittest.addModuleCleanup(PageTest.browser.close)


def write_page(name: str, surface: Path, *options: str) -> None:
    """By the program"""
    page = PageTest.folder / f"{name}.html"
    write_report(os.environ["ABF_FLATTEN_MESH"], surface, page, *options)
    PageTest.pages[name] = page


def difference(a: tuple, b: tuple) -> float:
    """The largest of all channels"""
    return max(abs(x - y) for x, y in zip(a, b))


def shade(seen: tuple, color: tuple) -> float:
    """How much darker a colour is seen, if it is that colour in some light; else NaN"""
    factor = sum(seen) / sum(color)
    return factor if difference(seen, tuple(factor * x for x in color)) <= 6 else math.nan


class PageTest(unittest.TestCase):
    """A browser, and pages of all kinds"""

    browser: Chromium
    folder: Path
    pages: dict[str, Path] = {}

    def tearDown(self):
        self.browser.resize(*SIZE)
        self.assertEqual(self.browser.complaints(), [])

    def open(self, name: str) -> ReportData:
        """One of the pages"""
        self.browser.open(self.pages[name])
        # On a machine with other work, the browser may answer before the scripts of the page have run.
        self.browser.run("while(typeof flattenReport === 'undefined') await new Promise(requestAnimationFrame);"
                         "await flattenReport.ready;")
        self.browser.rest()
        return ReportData(self.pages[name])

    def show(self, mode: str) -> None:
        """As `flattenReport` does"""
        self.browser.run("flattenReport.show(arguments[0]);", mode)

    def select(self, triangle: int) -> None:
        """As `flattenReport` does"""
        self.browser.run("flattenReport.select(arguments[0]);", triangle)
        self.browser.rest()

    def places(self, triangles) -> list[dict]:
        """Where the triangles are seen"""
        return self.browser.run("return arguments[0].map(flattenReport.screenOf);", list(triangles))

    def picture(self) -> Callable:
        """What is seen now: the colours at places in pixels from the upper left"""
        self.browser.rest()
        image = Image.open(io.BytesIO(self.browser.screenshot())).convert("RGB")
        return lambda place: image.getpixel((int(place[0]), int(place[1])))

    def chart_colors(self, count: int) -> list[tuple]:
        """Of the first charts"""
        return [tuple(self.browser.run("return colorOfChart(arguments[0]);", k)) for k in range(count)]

    def text(self, selector: str) -> str:
        """What is read there; empty if it is hidden"""
        return self.browser.run("const part = document.querySelector(arguments[0]);"
                                "return part.checkVisibility() ? part.innerText : '';", selector)

    def click(self, selector: str) -> None:
        """On an element"""
        self.browser.run("document.querySelector(arguments[0]).click();", selector)
        self.browser.rest()

    def box(self, selector: str) -> tuple[float, float, float, float]:
        """Left, top, width and height of an element"""
        return tuple(self.browser.run("const box = document.querySelector(arguments[0]).getBoundingClientRect();"
                                      "return [box.left, box.top, box.width, box.height];", selector))

    def best_seen(self, triangles, in_plane: bool = True) -> tuple[int, dict]:
        """That of the triangles that is nearest to the middle of the surface's view, and seen in the plane, or not"""
        left, top, width, height = self.box("#surface")
        seen = [(t, place) for t, place in zip(triangles, self.places(triangles))
                if place["surface"] and bool(place["plane"]) == in_plane]
        middle = left + width / 2, top + height / 2
        return min(seen, key=lambda item: math.dist(item[1]["surface"], middle))

    def assert_shaded(self, seen: list[tuple[tuple, tuple]]) -> None:
        """Colours, as they are seen and as they should be, but for light. Some are seen at a line, or from the side."""
        shades = [shade(*pair) for pair in seen]
        right = [x for x in shades if 0.4 < x < 1.05]
        self.assertGreater(len(right), 0.8 * len(shades))
        self.assertGreater(len(right), 10)

    def wait_for(self, script: str) -> None:
        """Until what the script returns is true"""
        self.browser.run("const end = performance.now() + 5000;"
                         f"while(!({script}) && performance.now() < end) await new Promise(requestAnimationFrame);")
        self.assertTrue(self.browser.run(f"return {script};"), script)


class Colors(PageTest):
    """What is drawn, at known places"""

    def test_charts_have_their_colors(self):
        data = self.open("cube")
        charts = data.numbers("charts")
        self.show("charts")
        places, picture = self.places(range(len(charts))), self.picture()
        seen, colors, pairs = set(), self.chart_colors(6), []
        for chart, place in zip(charts, places):
            color = colors[chart]
            self.assertLessEqual(difference(picture(place["plane"]), color), 2)
            if place["surface"]:
                seen.add(chart)
                pairs.append((picture(place["surface"]), color))
        self.assertEqual(len(set(charts)), 6)
        self.assertEqual(len(seen), 3, "three sides of a cube are seen")
        self.assert_shaded(pairs)

    def test_what_is_not_covered_is_empty(self):
        self.open("cube")
        self.show("charts")
        picture = self.picture()
        for view in ("#surface", "#plane"):
            left, top, width, height = self.box(view)
            for x, y in ((0.02, 0.2), (0.98, 0.2), (0.02, 0.98), (0.98, 0.98)):
                color = picture((left + x * width, top + y * height))
                self.assertGreater(min(color), 220, (view, x, y))

    def test_measures_have_the_colors_of_their_scales(self):
        data = self.open("sphere")
        triangles = range(0, len(data.numbers("charts")), 7)
        places = self.places(triangles)
        for measure, name in zip(data.report["measures"], MEASURES):
            self.assertEqual(measure["name"], name)
            self.show(name)
            values, picture = data.numbers(name)[::7], self.picture()
            colors = self.browser.run("return arguments[1].map((x) => colorOfValue(arguments[0], x));", measure,
                                      list(values))
            for color, place in zip(colors, places):
                self.assertLessEqual(difference(picture(place["plane"]), color), 2)
            self.assert_shaded([(picture(place["surface"]), color) for color, place in zip(colors, places)
                                if place["surface"]])
            self.assertGreater(len(set(map(tuple, colors))), 5)

    def test_lightness_tells_values(self):
        self.open("cube")
        scales = self.browser.run("return [SEQUENTIAL, DIVERGING];")
        sequential, diverging = ([0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in scale] for scale in scales)
        for darkening in (sequential, diverging[127::-1], diverging[128:]):
            steps = [a - b for a, b in zip(darkening, darkening[1:])]
            self.assertGreater(min(steps), -1, "but for rounding")
            self.assertGreater(sum(steps), 120)
        smaller, larger = scales[1][32], scales[1][-32]
        self.assertGreater(smaller[2], smaller[0] + 50, "smaller is blue")
        self.assertGreater(larger[0], larger[2] + 50, "larger is orange")

    def test_checkerboard_has_squares_of_equal_size_in_the_plane(self):
        data = self.open("cube")
        charts = data.numbers("charts")
        squares = int(self.text("#squares-value"))
        places, picture, tones = self.places(range(len(charts))), self.picture(), []
        colors, pairs = self.chart_colors(6), []
        for triangle, (chart, place) in enumerate(zip(charts, places)):
            u, v = (squares * x for x in data.middle_in_plane(triangle))
            if max(abs(u - math.floor(u) - 0.5), abs(v - math.floor(v) - 0.5)) < 0.35:  # not near a side
                is_light = (math.floor(u) + math.floor(v)) % 2 != 0
                expected = tuple(x + 0.76 * (255 - x) if is_light else x for x in colors[chart])
                self.assertLessEqual(difference(picture(place["plane"]), expected), 3)
                if place["surface"]:
                    pairs.append((picture(place["surface"]), expected))
                tones.append(is_light)
        self.assert_shaded(pairs)
        self.assertIn(True, tones)
        self.assertIn(False, tones)

    def test_seams_are_drawn_in_both_views(self):
        self.open("cube")
        self.show("charts")

        def dark_pixels() -> list[int]:
            picture, boxes = self.picture(), [map(int, self.box(view)) for view in ("#surface", "#plane")]
            return [sum(max(picture((x, y))) < 60 for x in range(left, left + width, 2)
                        for y in range(top, top + height, 2)) for left, top, width, height in boxes]

        self.assertGreater(min(dark_pixels()), 150)
        self.click("#seams")
        self.assertLess(max(dark_pixels()), 5)


class Links(PageTest):
    """Faces in both views"""

    def assert_tooltip(self, data: ReportData, triangle: int) -> None:
        """It tells the face and its measures."""
        text = self.text(".tooltip")
        self.assertIn(f"Face {data.numbers('faces')[triangle] + 1:,}, chart {data.numbers('charts')[triangle] + 1}", text)
        for measure in data.report["measures"]:
            value = self.browser.run("return valueText(...arguments);", measure,
                                     data.numbers(measure["name"])[triangle])
            self.assertIn(value, text)

    def test_a_face_under_the_mouse_is_highlighted_in_both_views(self):
        data = self.open("sphere")
        self.show("area_change")
        for view, other in (("plane", "surface"), ("surface", "plane")):
            triangle, place = self.best_seen(range(50, len(data.numbers("charts")), 31))
            before = self.picture()
            self.browser.mouse(move(place[view]))
            picture = self.picture()
            for side in (view, other):
                self.assertGreater(difference(before(place[side]), HIGHLIGHT), 60)
                self.assertLessEqual(difference(picture(place[side]), HIGHLIGHT), 2)
            self.assert_tooltip(data, triangle)
            left, top, width, height = self.box("#" + view)
            self.browser.mouse(move((left + 0.97 * width, top + 0.97 * height)))
            self.assertEqual(self.text(".tooltip"), "")
            self.assertEqual(self.picture()(place[other]), before(place[other]))

    def test_all_triangles_of_a_polygon_are_one_face(self):
        data = self.open("cube")
        self.show("charts")
        triangle, place = self.best_seen(range(len(data.numbers("charts"))))
        faces = data.numbers("faces")
        others = [t for t in range(len(faces)) if faces[t] == faces[triangle]]
        self.assertEqual(len(others), 2)
        self.browser.mouse(move(place["plane"]))
        picture = self.picture()
        for there in self.places(others):
            self.assertLessEqual(difference(picture(there["surface"]), HIGHLIGHT), 2)

    def test_a_click_turns_the_surface_to_the_face(self):
        data = self.open("sphere")
        hidden = [t for t, place in enumerate(self.places(range(len(data.numbers("charts"))))) if not place["surface"]]
        self.assertGreater(len(hidden), 100)
        for triangle in hidden[::197]:
            plane = self.places([triangle])[0]["plane"]
            self.browser.click(plane)
            self.assertEqual(self.browser.run("return flattenReport.selected();"), triangle)
            place = self.places([triangle])[0]
            self.assertEqual(place["plane"], plane, "the view that was clicked stays")
            self.assertLessEqual(difference(self.picture()(place["surface"]), HIGHLIGHT), 2)
            self.assertIn(f"Face {data.numbers('faces')[triangle] + 1:,}", self.text("#selection"))
        self.browser.press(ESCAPE)
        self.assertEqual(self.browser.run("return flattenReport.selected();"), -1)
        self.assertIn("No face selected", self.text("#selection"))

    def test_a_click_on_the_surface_shows_the_face_in_the_plane(self):
        data = self.open("sphere")
        left, top, _, _ = self.box("#plane")
        self.browser.mouse(move((left + 50, top + 50)), {"type": "pointerDown", "button": 0},
                           move((SIZE[0] - 5, top + 50)), {"type": "pointerUp", "button": 0})
        triangle, place = self.best_seen(range(len(data.numbers("charts"))), False)
        self.browser.click(place["surface"])
        self.assertEqual(self.browser.run("return flattenReport.selected();"), triangle)
        place = self.places([triangle])[0]
        self.assertLessEqual(difference(self.picture()(place["plane"]), HIGHLIGHT), 2)

    def test_both_sides_of_a_seam_are_highlighted(self):
        data = self.open("cube")
        borders, uv = data.numbers("borders"), data.numbers("wedge_uv")
        left, bottom, right, top = data.report["box"]
        x, y, width, height = self.box("#sheet")

        def middle(i: int) -> tuple[float, float]:
            a, b = borders[i], borders[i + 1]
            return (x + width * ((uv[2 * a] + uv[2 * b]) / 2 - left) / (right - left),
                    y + height * (top - (uv[2 * a + 1] + uv[2 * b + 1]) / 2) / (top - bottom))

        seam = borders[2]
        sides = [i for i in range(0, len(borders), 3) if borders[i + 2] == seam]
        self.assertGreaterEqual(len(sides), 2)
        self.browser.mouse(move(middle(0)))
        picture = self.picture()
        for i in sides:
            around = [(dx, dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
            place = middle(i)
            self.assertLess(min(difference(picture((place[0] + dx, place[1] + dy)), HIGHLIGHT) for dx, dy in around), 40)

    def test_worst_faces_are_shown_in_both_views(self):
        data = self.open("dinosaur")
        for measure in data.report["measures"]:
            panel = f"[data-measure={measure['name']}] .worst button"
            steps = [f"{panel}:nth-child({k})" for k in (1, 3, 3, 2)]
            for step, index in zip(steps, (0, 1, 2, 1)):
                self.click(step)
                triangle = measure["worst"][index]["triangle"]
                self.assertEqual(self.browser.run("return flattenReport.selected();"), triangle)
                place = self.places([triangle])[0]
                self.assertTrue(place["surface"] and place["plane"], (measure["name"], index, place))
                self.assertIn(f"{index + 1} of {len(measure['worst'])}", self.text(f"[data-measure={measure['name']}]"))
            picture = self.picture()
            self.assertLessEqual(difference(picture(place["plane"]), HIGHLIGHT), 2)
            self.assertEqual(self.browser.run("return document.querySelector('.modes :checked').value;"), measure["name"])


class Controls(PageTest):
    """What people do"""

    def cameras(self) -> dict:
        """From where both views are seen"""
        return json.loads(self.browser.run("return JSON.stringify(flattenReport.camera());"))

    def changes(self, action) -> set[str]:
        """What an action changes of the cameras"""
        before = self.cameras()
        action()
        after = self.cameras()
        return {f"{view} {part}" for view, state in before.items() for part in state if state[part] != after[view][part]}

    def drag(self, view: str, button: int = 0) -> None:
        """From the middle of a view to the right"""
        left, top, width, height = self.box(view)
        x, y = left + width / 2, top + height / 2
        self.browser.mouse(move((x, y)), {"type": "pointerDown", "button": button}, move((x + 40, y + 10)),
                           {"type": "pointerUp", "button": button})

    def test_drags_turn_and_pan(self):
        self.open("sphere")
        self.assertEqual(self.changes(lambda: self.drag("#surface")), {"surface rotation"})
        self.assertEqual(self.changes(lambda: self.drag("#surface", 2)), {"surface target"})
        self.assertEqual(self.changes(lambda: self.drag("#plane")), {"plane center"})
        self.assertEqual(self.browser.run("return flattenReport.selected();"), -1, "a drag is no click")

    def test_the_wheel_zooms_to_the_mouse(self):
        data = self.open("sphere")
        triangle, place = self.best_seen(range(0, len(data.numbers("charts")), 13))
        for view in ("surface", "plane"):
            x, y = map(round, place[view])
            before = self.places([triangle])[0][view]
            self.browser.perform({"type": "wheel", "id": "wheel", "actions": [
                {"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": -200, "duration": 0}]})
            after = self.places([triangle])[0][view]
            self.assertLess(math.dist(before, after), 12)
        self.assertLess(self.cameras()["plane"]["unitsPerPixel"], 0.9 / self.box("#sheet")[2] * 2)

    def test_one_finger_turns_and_two_zoom(self):
        self.open("sphere")
        left, top, width, height = self.box("#surface")
        x, y = left + width / 2, top + height / 2
        self.assertEqual(self.changes(lambda: self.browser.touch([(x, y), (x + 30, y)])), {"surface rotation"})
        distance = self.cameras()["surface"]["distance"]
        self.browser.touch([(x - 30, y), (x - 60, y), (x - 90, y)], [(x + 30, y), (x + 60, y), (x + 90, y)])
        self.assertLess(self.cameras()["surface"]["distance"], 0.6 * distance)

    def test_keys_turn_the_view_with_the_focus(self):
        self.open("sphere")
        self.browser.run("document.querySelector('#surface').focus();")
        self.assertEqual(self.changes(lambda: self.browser.press(ARROW_RIGHT)), {"surface rotation"})
        self.assertEqual(self.changes(lambda: self.browser.press("+")), {"surface distance"})
        self.browser.press(HOME)
        home = self.cameras()["surface"]
        self.click("#reset")
        self.assertEqual(self.cameras()["surface"], home)

    def test_nothing_is_drawn_while_nothing_changes(self):
        self.open("sphere")
        counted = ("const kind = WebGL2RenderingContext.prototype, draw = kind.drawArrays; let count = 0;"
                   "kind.drawArrays = function(...values) { ++count; return draw.apply(this, values); };"
                   "{} await new Promise((resolve) => setTimeout(resolve, 400));"
                   "kind.drawArrays = draw; return count;")
        self.assertEqual(self.browser.run(counted.replace("{}", "")), 0)
        self.assertGreater(self.browser.run(counted.replace("{}", "flattenReport.show('charts');")), 1)

    def test_a_chart_is_shown_alone(self):
        data = self.open("sphere")
        self.show("charts")
        charts = data.numbers("charts")
        self.click("#charts tbody tr:nth-child(5)")
        chart = int(self.browser.run("return document.querySelector('#charts tbody tr.current').dataset.chart;"))
        color = self.chart_colors(6)[chart]
        places, picture = self.places(range(len(charts))), self.picture()
        seen = [place for place, number in zip(places, charts) if number == chart and all(place.values())]
        self.assertGreater(len(seen), charts.count(chart) // 2)
        for place in seen:
            self.assertLessEqual(difference(picture(place["plane"]), color), 2)
        for place, number in zip(places, charts):
            if number != chart and place["surface"]:
                red, green, blue = picture(place["surface"])
                self.assertLess(max(red, green, blue) - min(red, green, blue), 45, "the others are grey")
        self.browser.press(ESCAPE)
        self.assertEqual(self.browser.run("return document.querySelectorAll('#charts .current').length;"), 0)


class Page(PageTest):
    """What is told, and where"""

    def test_tables_tell_what_the_program_found(self):
        for name in self.pages:
            data = self.open(name)
            report = data.report
            self.assertEqual(self.text("h1"), report["title"])
            self.assertIn(f"{report['triangles']:,} triangles", self.text("#subtitle"))
            rows = self.text("#rows")
            for row in report["rows"]:
                for text in row[1:]:
                    self.assertIn(text.strip(), rows)
            shown = self.browser.run("return document.querySelectorAll('#charts tbody tr').length;")
            self.assertEqual(shown, len(report["charts"]))
            for note in report["notes"]:
                self.assertIn(note, self.text("#notes"))

    def test_histograms_tell_ranges_and_shares(self):
        data = self.open("sphere")
        for measure in data.report["measures"]:
            panel = f"[data-measure={measure['name']}]"
            self.browser.run("document.querySelector(arguments[0]).scrollIntoView();", panel)
            left, top, width, height = self.box(panel + " .bars")
            shares = measure["histogram"]["shares"]
            largest = shares.index(max(shares))
            self.browser.mouse(move((left + (largest + 0.5) / len(shares) * width, top + height / 2)))
            told = self.text(panel + " .told")
            share = float(re.search(r"([\d.]+) % of the area", told)[1])
            self.assertAlmostEqual(share, 100 * shares[largest], delta=0.5)
            low = measure["histogram"]["first"] + largest * measure["histogram"]["width"]
            self.assertIn(self.browser.run("return valueText(...arguments);", measure, low), told)

    def test_narrow_windows_do_not_scroll_sideways(self):
        for name in self.pages:
            self.browser.resize(380, 800)
            self.open(name)
            for width in (1024, 768, 380):
                self.browser.resize(width, 800)
                for mode in ("checkerboard", *MEASURES):
                    self.show(mode)
                    self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth;"), width)
            self.browser.rest()
            surface, plane = self.box("#surface"), self.box("#plane")
            self.assertGreaterEqual(plane[1], surface[1] + surface[3], "one view is below the other")
            self.assertGreater(surface[3], 200)

    def test_colors_are_at_the_same_places_in_narrow_windows(self):
        self.browser.resize(380, 1300)
        data = self.open("cube")
        charts = data.numbers("charts")
        self.show("charts")
        triangle, place = self.best_seen(range(len(charts)))
        color = self.chart_colors(6)[charts[triangle]]
        picture = self.picture()
        self.assertLessEqual(difference(picture(place["plane"]), color), 2)
        self.assertGreater(shade(picture(place["surface"]), color), 0.4)

    def test_nothing_is_asked_of_the_network(self):
        for name in self.pages:
            data = self.open(name)
            asked = self.browser.run("return performance.getEntriesByType('resource').map((entry) => entry.name);")
            self.assertEqual([address for address in asked if not address.startswith("data:")], [])
            self.assertIsNone(re.search(r"<(script|link|img|iframe)[^>]*(src|href)=.?(?!.?data:)", data.text))
            self.assertIn("Permission is hereby granted", data.text, "the licence of three.js")

    def test_thinned_surfaces_say_so(self):
        data = self.open("cube")
        self.assertFalse(self.browser.run("return flattenReport.thinned();"))
        self.assertEqual(self.text("#thinned"), "")
        page = self.folder / "thinned.html"
        page.write_text(data.replaced(data.report | {"triangles": 1234567}, {}), encoding="utf-8")
        self.browser.open(page)
        self.assertTrue(self.browser.run("return flattenReport.thinned();"))
        self.assertIn(f"Shown: {data.report['shown_triangles']:,} of 1,234,567 triangles.", self.text("#thinned"))

    def test_large_surfaces_are_shown(self):
        page = self.folder / "large.html"
        size = 317  # 200,978 triangles
        page.write_text(wavy_sheet(self.open("cube"), size), encoding="utf-8")
        self.browser.open(page)
        # On a machine with other work, the browser may answer before the scripts of the page have run.
        self.browser.run("while(typeof flattenReport === 'undefined') await new Promise(requestAnimationFrame);"
                         "await flattenReport.ready;")
        triangle = size * size + 101
        self.select(triangle)
        self.show("charts")
        place = self.places([triangle])[0]
        self.assertTrue(place["surface"] and place["plane"])
        picture = self.picture()
        for where in place.values():
            self.assertLessEqual(difference(picture(where), HIGHLIGHT), 2)
        self.select(-1)
        self.browser.mouse(move(place["plane"]))
        self.assertRegex(self.text(".tooltip"), r"^Face 10\d,\d\d\d, chart 1\b")

    def test_what_is_missing_is_named(self):
        data = self.open("cube")
        page = self.folder / "broken.html"
        page.write_text(data.text.replace('id="array-faces"', 'id="array-fases"'), encoding="utf-8")
        self.browser.open(page)
        self.assertIn("faces", self.text("#failure"))
        self.assertTrue(self.browser.complaints())


class WithoutWebGL(PageTest):
    """Browsers on machines that do not draw in space"""

    @classmethod
    def setUpClass(cls):
        cls.browser = Chromium(SIZE, "--disable-3d-apis")
        cls.addClassCleanup(cls.browser.close)

    def test_tables_and_histograms_are_there(self):
        data = self.open("dinosaur")
        self.assertIn("WebGL", self.text("#webgl"))
        self.assertEqual(self.box("#views")[3], 0)
        self.assertIn(data.report["rows"][1][1], self.text("#rows"))
        bars = self.browser.run("return document.querySelectorAll('.bars .bar').length;")
        self.assertEqual(bars, sum(len(measure["histogram"]["shares"]) for measure in data.report["measures"]))
        self.click("[data-measure=angle_change] .worst button")
        worst = data.report["measures"][0]["worst"][0]
        self.assertIn(f"Face {worst['face'] + 1:,}", self.text("#selection"))
        self.show("charts")
        self.browser.press(ESCAPE)


if __name__ == "__main__":
    missing = missing_programs() + ([] if Image else ["python3-pil"])
    if missing:
        print(f"skipped: {' and '.join(missing)} not found")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
