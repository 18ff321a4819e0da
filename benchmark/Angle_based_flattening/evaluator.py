# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures any atlas from its triangles in space and the coordinates of their corners, with numpy alone."""

import math

import numpy as np


def least_connected(count, groups):
    """The least element that each of the elements is connected with by groups, which are rows"""
    least, before = np.arange(count), None
    while before is None or (least != before).any():
        before = least.copy()
        np.minimum.at(least, groups, least[groups].min(axis=1)[:, None])
        least = least[least]
    return least


def merged(vertices, faces):
    """Faces of the first of all vertices at the same place"""
    _, first, place = np.unique(vertices, axis=0, return_index=True, return_inverse=True)
    return first[place.reshape(-1)][faces]


def charts_and_seams(faces, corners):
    """The chart of each face, and the edges on seams. Faces meet in pairs in each edge, by their order. A pair is in
    one chart if its faces have the same orientation and the same coordinates along the edge."""
    count = len(faces)
    ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    coordinates = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 2)
    turned = ends[:, 0] > ends[:, 1]
    ends[turned], coordinates[turned] = ends[turned, ::-1], coordinates[turned, ::-1]
    order = np.lexsort((ends[:, 1], ends[:, 0]))  # which is stable
    starts = np.r_[True, (ends[order][1:] != ends[order][:-1]).any(axis=1)]
    place = np.arange(len(order)) - np.maximum.accumulate(np.where(starts, np.arange(len(order)), 0))
    first = np.flatnonzero((place[:-1] % 2 == 0) & ~starts[1:])
    a, b = order[first], order[first + 1]
    whole = (turned[a] != turned[b]) & (coordinates[a] == coordinates[b]).all(axis=(1, 2))
    chart = least_connected(count, np.column_stack([a[whole], b[whole]]) // 3)
    return chart, ends[a[~whole]]


def plane_areas(corners):
    """Those of triangles in the plane, negative if they are flipped"""
    (x, y), (z, w) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    return (x * w - y * z) / 2


def turned_charts(corners, chart):
    """Charts that are mirrored as a whole are turned."""
    mirrored = np.bincount(chart, plane_areas(corners), len(chart)) < 0
    corners = corners.copy()
    corners[mirrored[chart], :, 0] *= -1
    return corners


def side(line, point):
    """On which side of lines from one point to another points are, and how far, times the length"""
    s, t = line
    return (t[..., 0] - s[..., 0]) * (point[..., 1] - s[..., 1]) - (t[..., 1] - s[..., 1]) * (point[..., 0] - s[..., 0])


def common_areas(left, right):
    """Of pairs of triangles of positive area. Each line of the one clips the other; edges outside become points on the
    line, so that polygons have equally many corners."""
    polygon = left
    for k in range(3):
        line = right[:, None, k], right[:, None, (k + 1) % 3]
        to = np.roll(polygon, -1, axis=1)
        here, there = side(line, polygon), side(line, to)
        with np.errstate(divide="ignore", invalid="ignore"):
            crossing = polygon + (here / (here - there))[..., None] * (to - polygon)
        begins = np.where((here >= 0)[..., None], polygon, np.where((there > 0)[..., None], crossing, line[0]))
        leaves = (here > 0) & (there < 0)
        ends = np.where(leaves[..., None], crossing, begins)
        polygon = np.stack([begins, ends], axis=2).reshape(len(left), 2 * polygon.shape[1], 2)
    x, y = (polygon - polygon[:, :1]).transpose(2, 0, 1)
    return (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1) / 2


def in_same_cells(low, high, cells):
    """Pairs of boxes that share a cell of a grid over all of them, in blocks; a pair may be there several times."""
    size = max((high.max(axis=0) - low.min(axis=0)).max(), 1e-300) / cells
    a, b = (np.floor((bound - low.min(axis=0)) / size).astype(int) for bound in (low, high))
    wide = b - a + 1
    count = wide.prod(axis=1)
    box = np.repeat(np.arange(len(low)), count)
    rest = np.arange(len(box)) - np.repeat(np.cumsum(count) - count, count)
    cell = (a[box, 0] + rest // wide[box, 1]) * (cells + 2) + a[box, 1] + rest % wide[box, 1]
    order = np.argsort(cell, kind="stable")
    box, cell = box[order], cell[order]
    for shift in range(1, len(box)):
        same = np.flatnonzero(cell[shift:] == cell[:-shift])
        if not len(same):
            return
        yield np.sort(np.column_stack([box[same], box[same + shift]]), axis=1)


def overlapping_pairs(corners, area, least=1e-7):
    """Pairs of triangles of positive area that share more than this part of the smaller one"""
    chosen = np.flatnonzero(area > 0)
    if len(chosen) < 2:
        return np.empty((0, 2), int)
    corners, area = corners[chosen], area[chosen]
    low, high = corners.min(axis=1), corners.max(axis=1)
    found = [np.empty((0, 2), int)]
    for pairs in in_same_cells(low, high, max(1, min(4096, int(len(chosen)**.5)))):
        a, b = pairs.T
        pairs = pairs[((low[a] < high[b]) & (low[b] < high[a])).all(axis=1)]
        for one, other in ((0, 1), (1, 0)):  # those that no edge separates
            for k in range(3):
                triangle, points = corners[pairs[:, one]], corners[pairs[:, other]]
                line = triangle[:, None, k], triangle[:, None, (k + 1) % 3]
                pairs = pairs[(side(line, points) > 0).any(axis=1)]
        pairs = np.unique(pairs, axis=0)
        a, b = pairs.T
        found.append(pairs[common_areas(corners[a], corners[b]) > least * np.minimum(area[a], area[b])])
    return chosen[np.unique(np.concatenate(found), axis=0)]


def inverse_stretches(points, corners, area):
    """The largest and the smallest length in space of a unit vector in the plane of each triangle, squared"""
    e, f = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    (x, y), (z, w) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    along_u = (e * w[:, None] - f * y[:, None]) / (2 * area[:, None])
    along_v = (f * x[:, None] - e * z[:, None]) / (2 * area[:, None])
    a, b, c = (along_u**2).sum(1), (along_v**2).sum(1), (along_u * along_v).sum(1)
    root = np.hypot(a - b, 2 * c)
    return (a + b + root) / 2, np.maximum((a + b - root) / 2, 0)


def evaluate(vertices, faces, corners, page=1.0):
    """Numbers of an atlas: corners has three points in the plane for each face, NaN or all the same where there are
    none, and the page has this area in the same unit. Density and w05 are those of texels on the surface, 1 for an
    isometric map that fills the page: the harmonic mean, and what 95 % of the surface have at least, each face in its
    worst direction. Without a page, each chart is measured alone, with its area in space. Charts then share no
    vertices, and faces without map are left out."""
    faces = merged(vertices, faces) if page else faces
    corners = np.nan_to_num(np.asarray(corners, float))
    chart, seams = charts_and_seams(faces, corners)
    corners = turned_charts(corners, chart)
    points, area = vertices[faces], plane_areas(corners)
    surface = np.linalg.norm(np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1) / 2
    if page is None:
        used = [np.bincount(chart, np.where(area != 0, part, 0), len(faces)) for part in (surface, abs(area))]
        with np.errstate(divide="ignore", invalid="ignore"):
            corners = corners * np.nan_to_num(np.sqrt(used[0] / used[1]))[chart][:, None, None]
        area = plane_areas(corners)
    mapped = area != 0
    pairs = overlapping_pairs(corners, area) if page else np.concatenate(
        [inside[overlapping_pairs(corners[inside], area[inside])] for inside in
         np.split(np.argsort(chart, kind="stable"), np.flatnonzero(np.diff(np.sort(chart))) + 1)])
    within = chart[pairs[:, 0]] == chart[pairs[:, 1]]
    total = (surface if page else surface[mapped]).sum()
    size = page or total
    largest, smallest = inverse_stretches(points[mapped], corners[mapped], abs(area[mapped]))
    worst = np.zeros(len(faces))
    worst[mapped] = total / size / np.maximum(largest, 1e-300)
    counted = (surface > 0) & (mapped | (page is not None))
    order = np.argsort(worst[counted], kind="stable")
    shares = np.cumsum(surface[counted][order])
    weights = surface[mapped]
    with np.errstate(divide="ignore", invalid="ignore"):
        squares = (weights * (largest + smallest)).sum() / weights.sum()
        inverse = (weights * (1 / largest + 1 / smallest))[weights > 0].sum() / weights.sum()
    return {"faces": len(faces), "charts": len(np.unique(chart[mapped])), "unmapped": int((~mapped).sum()),
            "seam": np.linalg.norm(vertices[seams[:, 0]] - vertices[seams[:, 1]], axis=1).sum() / math.sqrt(total),
            "flipped": int((area < 0).sum()), "within": int(within.sum()), "between": int((~within).sum()),
            "density": 2 * total / (squares * size),
            "w05": worst[counted][order][min(np.searchsorted(shares, .05 * shares[-1]), len(shares) - 1)],
            "dirichlet": 2 * math.sqrt(squares * inverse), "covered": abs(area).sum() / size if page else math.nan}
