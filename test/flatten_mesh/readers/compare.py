# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares what a program reads of a model with the truth. Faces and corners may be in any order, and faces may be
divided: a corner is right if its point and its texture coordinates are those of a corner of one face of the truth."""

import functools


def read_obj(path):
    """Faces of an OBJ file: for each corner the point, and u and v if there are some"""
    points, texture, faces = [], [], []
    for word, *rest in (line.split() for line in path.read_text().splitlines() if line.strip()):
        if word == "v":
            points.append(tuple(map(float, rest[:3])))
        elif word == "vt":
            texture.append(tuple(map(float, rest[:2])))
        elif word == "f":
            corners = [corner.split("/") for corner in rest]
            faces.append([points[int(c[0]) - 1] + (texture[int(c[1]) - 1] if len(c) > 1 and c[1] else ())
                          for c in corners])
    return faces


def normal(points):
    """Twice the vector area of a polygon"""
    pairs = list(zip(points, points[1:] + points[:1]))
    return [sum(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for a, b in pairs) for i in range(3)]


def near(a, b, tolerance):
    """Whether no number differs by more"""
    return all(abs(x - y) <= tolerance for x, y in zip(a, b))


def place_of(corner, face, tolerance):
    """The corner of a face with the same point, and whether the coordinates are the same; those of most sets count."""
    best = None, False
    for i, other in enumerate(face):
        if near(corner[:3], other[:3], tolerance):
            if len(corner) >= len(other) and near(corner[3:], other[3:], tolerance):
                return i, True
            best = i, False
    return best


def judge(truth, faces, tolerance):
    """The verdict, in a few words. Faces of the truth whose corners have no, or equal, coordinates have no chart: of
    them, nothing is required."""
    if not faces:
        return "an empty mesh"
    sets = max(len(corner) for face in truth for corner in face) // 2 - 1
    read = {(len(corner) - 3) // 2 for face in faces for corner in face}
    if read == {0}:
        return "no coordinates"
    at = functools.cache(lambda *point: [k for k, face in enumerate(truth)
                                         if any(near(point, corner[:3], tolerance) for corner in face)])
    charted = [len({corner[3:] for corner in face}) > 1 for face in truth]
    missing = [len(face) - 2 for face in truth]
    corners = right = turned = 0
    for face in faces:
        best = None
        for k in at(*face[0][:3]):
            other = truth[k]
            places = [place_of(corner, other, tolerance) for corner in face]
            if all(i is not None for i, _ in places) and len({i for i, _ in places}) == len(face):
                score = sum(same for _, same in places), missing[k] > 0
                if best is None or score > best[0]:
                    best = score, k, [i for i, _ in places]
        if best is None:
            if all(any(near(corner[:3], c[:3], tolerance) for f in truth for c in f) for corner in face):
                continue  # Its points are those of no face: some face is missing.
            return "wrong points"
        (same, _), k, places = best
        missing[k] -= len(face) - 2
        if charted[k]:
            corners += len(face)
            right += same
            front = sum(a * b for a, b in zip(*(normal([c[:3] for c in f]) for f in (face, truth[k]))))
            first = places.index(min(places))
            turned += front < 0 or places[first:] + places[:first] != sorted(places)
    dropped = sum(m > 0 for m, c in zip(missing, charted) if c)
    if corners == 0:
        return "drops all faces"
    if right < corners and sets > 1 and max(read) == 1 and \
            judge([[c[:5] for c in face] for face in truth], faces, tolerance) == "right":
        return "first set only"
    words = [f"drops {dropped} of {sum(charted)} faces"] * (dropped > 0)
    words += [f"{corners - right} of {corners} corners wrong"] * (right < corners)
    words += [f"{turned} triangles turned over"] * (turned > 0)
    return ", ".join(words) or "right"
