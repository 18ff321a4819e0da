# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper says of pairs of methods, and on how many meshes it is seen."""

from math import inf

from comparison import METHODS, Results, geometric_mean
from report import DASH, cell, table

# What the paper says; the number; the quotient of which methods; the bounds between which it lies; and
# the faces of the smallest mesh of which the paper says so
RELATIONS = [
    ("ABF++ is as little distorted as ABF (Section 1)", "energy", "abf++", "abf", 0.998, 1.002, 0),
    ("So it is if Newton's method stops at a gradient of norm 1 (Section 4)",
     "energy", "paper-abf++", "abf++", 0.998, 1.01, 0),
    ("ABF++ is up to ten times faster than ABF (Tables I, II: 4 to 15 times)",
     "seconds", "abf", "paper-abf++", 4, inf, 1000),
    ("So is our ABF++", "seconds", "abf", "abf++", 4, inf, 1000),
    ("ABF in logarithms is slower than ABF (Section 2.2)", "seconds", "log-abf", "abf", 1, inf, 1000),
    ("LSCM stretches more than ABF++ (Section 6.2)", "stretch", "lscm", "abf++", 1, inf, 0),
    ("HLSCM stretches more than ABF++ (Table II: 3 to 120 times)", "stretch", "hlscm", "abf++", 1, inf, 0),
    ("HLSCM stretches more than HABF++ (Tables II, III: 3 to 120 times)",
     "stretch", "hlscm", "habf++", 1, inf, 0),
    ("It stretches ten times more (Section 6.1)", "stretch", "hlscm", "habf++", 10, inf, 0),
    ("LSCM has a larger energy than ABF++ (Table II, of HLSCM)",
     "energy", "lscm", "abf++", 1, inf, 0),
    ("LSCM changes the surface's own angles more than ABF++, by area (not in the paper)",
     "angle_change", "lscm", "abf++", 1, inf, 0),
    ("The same by corner", "corner_angle_change", "lscm", "abf++", 1, inf, 0),
    ("LSCM has a larger mean quasi-conformal ratio than ABF++ (not in the paper)",
     "quasi_conformal", "lscm", "abf++", 1, inf, 0),
    ("Shear of ABF++ and HLSCM is alike (Table II: 0.75 to 2.3)",
     "principal_shear", "hlscm", "abf++", 0.4, 2.5, 0),
    ("HABF++ stretches only little more than ABF++ (Table II: at most 8 %)",
     "stretch", "habf++", "abf++", 0.9, 1.08, 0),
    ("HABF++ has a somewhat larger energy (Table II: 1.3 to 2 times)",
     "energy", "habf++", "abf++", 1, 2, 0),
    ("ABF++ is slower than HLSCM (Table II)", "seconds", "abf++", "hlscm", 1, inf, 50000),
    ("HABF++ is faster than HLSCM (Tables II, III: 3 to 7 times)",
     "seconds", "hlscm", "habf++", 1, inf, 50000),
    ("HABF++ is ten times faster than ABF++ (Table II: 7 to 30 times)",
     "seconds", "abf++", "habf++", 7, inf, 50000),
    ("Stretch minimization stretches less than ABF++ (Table II)", "stretch", "stretch", "abf++", 0, 1, 0),
    ("It has a larger energy (Table II: 800 times)", "energy", "stretch", "abf++", 1, inf, 0),
    ("It is slower (Tables I, II: 2 to 6 times)", "seconds", "stretch", "abf++", 1, inf, 1000),
    ("MIPS stretches less than LSCM (Section 6.2)", "stretch", "mips", "lscm", 0, 1, 0),
    ("A fixed border raises the energy (Section 1.1)", "energy", "conformal", "lscm", 1, inf, 0)]

# Whether a method flips nothing on any mesh, or some triangles on one of them at least
FLIPS = [
    ("ABF++ flips nothing (Section 4)", "abf++", False, 0),
    ("HABF++ flips nothing (Section 5)", "habf++", False, 0),
    ("MIPS flips nothing (Section 1.1)", "mips", False, 0),
    ("LSCM may flip", "lscm", True, 0),
    ("HLSCM may flip", "hlscm", True, 0),
    ("The unfolding of ABF breaks above 30,000 triangles (Section 4)", "abf", True, 30000)]

NAMES = {"seconds": "time", "angle_change": "angle change",
         "corner_angle_change": "angle change by corner", "quasi_conformal": "quasi-conformal ratio",
         "principal_shear": "principal shear"}


def verdict(seen: int, measured: int) -> str:
    if measured == 0:
        return "not measured"
    return "yes" if seen == measured else "on some" if seen else "NO"


def relations_table(results: Results) -> str:
    """All of them"""
    def title(method: str) -> str:
        return METHODS[method] if method in results.methods else method

    rows = []
    for text, name, left, right, least, most, faces in RELATIONS:
        all_quotients = results.quotients(name, left, right, faces)
        seen = int(all_quotients.between(least, most).sum())
        numbers = (all_quotients.min(), geometric_mean(all_quotients), all_quotients.max())
        rows.append([text, f"{NAMES.get(name, name)}, {title(left)} / {title(right)}",
                     *(cell(number, ".4g") for number in numbers),
                     f"{seen} of {len(all_quotients)}", verdict(seen, len(all_quotients))])
    for text, method, flips, faces in FLIPS:
        numbers = results.wide("flips")[method][results.meshes["faces"] >= faces].dropna()
        seen = int(((numbers > 0) == flips).sum())
        rows.append([text, f"flips of {title(method)}", cell(numbers.min(), ".0f"), DASH,
                     cell(numbers.max(), ".0f"), f"{seen} of {len(numbers)}",
                     verdict(len(numbers) if flips and seen else seen, len(numbers))])
    return table(["the paper says", "measured", "smallest", "geometric mean", "largest",
                  "seen on meshes", "seen"], rows, 2)
