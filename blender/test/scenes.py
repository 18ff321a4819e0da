# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes for the tests in Blender, and what the tests read of them."""

import contextlib

import bpy
import numpy as np


def clear():
    """Removes everything from the scene."""
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    bpy.data.batch_remove(list(bpy.data.objects) + list(bpy.data.meshes))


def add(name, vertices, faces, seams=(), uv=None):
    """An object with a mesh of polygons, which becomes the active and selected one beside those before."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(map(float, point)) for point in vertices], [], [tuple(map(int, face)) for face in faces])
    seams = {frozenset(map(int, pair)) for pair in seams}
    for edge in mesh.edges:
        edge.use_seam = frozenset(edge.vertices) in seams
    if uv is not None:
        mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", np.asarray(uv, np.float32).ravel())
    created = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(created)
    created.select_set(True)
    bpy.context.view_layer.objects.active = created
    return created


def grid_faces(columns, rows, wraps=False):
    """Quads of a grid of vertices, row by row; if it wraps, the last column is the first one."""
    width = columns if wraps else columns + 1
    return [
        [y * width + x, y * width + (x + 1) % width, (y + 1) * width + (x + 1) % width, (y + 1) * width + x]
        for y in range(rows)
        for x in range(columns)
    ]


def add_tube(name="tube", columns=16, rows=6):
    """An open tube of quads, with a straight seam: it can be unrolled."""
    angles = 2 * np.pi * np.arange(columns) / columns
    vertices = [(np.cos(a), np.sin(a), y / 2) for y in range(rows + 1) for a in angles]
    seam = [(y * columns, (y + 1) * columns) for y in range(rows)]
    return add(name, vertices, grid_faces(columns, rows, wraps=True), seam)


def add_patch(name="patch", columns=8, rows=5, height=0.5, uv=None, is_planar=False):
    """A curved patch of quads, without coordinates, or with given or planar ones."""
    vertices = [(x, y, height * np.sin(x / 2) * np.cos(y / 2)) for y in range(rows + 1) for x in range(columns + 1)]
    faces = grid_faces(columns, rows)
    if is_planar:
        uv = [vertices[v][:2] for face in faces for v in face]
    return add(name, vertices, faces, uv=uv)


def add_polygons(seed, name="polygons", subdivisions=3):
    """A closed surface of triangles, quads and larger polygons: a sphere of which edges are dissolved."""
    import bmesh

    random = np.random.default_rng(seed)
    shape = bmesh.new()
    bmesh.ops.create_icosphere(shape, subdivisions=subdivisions, radius=1)
    for vertex in shape.verts:
        vertex.co *= 1 + 0.2 * np.sin(3 * vertex.co.x + seed) * np.cos(2 * vertex.co.y)
    edges = [edge for edge in shape.edges if random.random() < 0.15]
    bmesh.ops.dissolve_edges(shape, edges=edges, use_verts=False)
    shape.verts.index_update()
    vertices = [tuple(vertex.co) for vertex in shape.verts]
    faces = [[vertex.index for vertex in face.verts] for face in shape.faces]
    shape.free()
    return add(name, vertices, faces)


def pin(found, corners):
    """Pins corners. Since Blender 3.5, pins are an attribute, and where it is not there yet, `pin_uv` of Blender 4.3
    pins others as well."""
    layer = found.data.uv_layers.active
    pins = np.zeros(len(layer.data), bool)
    pins[corners] = True
    if bpy.app.version < (3, 5):
        layer.data.foreach_set("pin_uv", pins)
    else:
        found.data.attributes.new(f".pn.{layer.name}", "BOOLEAN", "CORNER").data.foreach_set("value", pins)


def add_dirty(random, name):
    """Any polygons: with several at an edge, with points in the same place, without area, tiny or huge, turned, with
    any seams, pins, coordinates and selection."""
    if random.random() < 0.5:
        columns, rows = random.integers(1, 7, 2)
        faces = grid_faces(columns, rows)
        points = np.array([(x, y, random.normal() / 5) for y in range(rows + 1) for x in range(columns + 1)])
        faces = [face[::-1] if random.random() < 0.1 else face for face in faces]
    else:
        points = np.round(random.normal(size=(int(random.integers(5, 30)), 3)), int(random.integers(0, 3)))
        faces = [list(random.choice(len(points), int(random.integers(3, 6)), replace=False)) for _ in range(20)]
        # Blender does not take several faces of the same points for a mesh, and ends when it is to edit one.
        faces = list({frozenset(face): face for face in faces}.values())
    points[random.integers(len(points))] = points[random.integers(len(points))]
    points *= 10.0 ** random.choice([-20, -6, 0, 0, 0, 6, 20])
    planar = np.concatenate([points[face][:, :2] for face in faces])
    uv = [None, planar, -planar, 0 * planar, np.nan * planar, random.normal(size=planar.shape)][random.integers(6)]
    found = add(name, points, faces, uv=uv)
    found.data.edges.foreach_set("use_seam", random.random(len(found.data.edges)) < 0.15)
    if uv is not None:
        pin(found, np.flatnonzero(random.random(len(uv)) < random.choice([0, 0, 0.05])))
    found.scale = (1, 1, random.choice([-1, 0, 1, 1, 2]))
    select_faces(found, random.random(len(found.data.polygons)) < random.choice([0.3, 1, 1]))
    return found


def read(found, collection, name, kind, width=1):
    elements = getattr(found.data, collection)
    values = np.empty(len(elements) * width, kind)
    elements.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def uv_of(found, layer=None):
    """A copy of the coordinates of corners, in whatever mode the object is."""
    in_edit_mode = found.mode == "EDIT"
    if in_edit_mode:
        bpy.ops.object.mode_set(mode="OBJECT")
    data = (found.data.uv_layers[layer] if layer else found.data.uv_layers.active).data
    values = np.empty(2 * len(data), np.float32)
    data.foreach_get("uv", values)
    if in_edit_mode:
        bpy.ops.object.mode_set(mode="EDIT")
    return values.reshape(-1, 2)


def polygons_of(found):
    """The faces as offsets and vertices."""
    return np.append(read(found, "polygons", "loop_start", np.int32), len(found.data.loops)), read(
        found, "loops", "vertex_index", np.int32
    )


def faces_as_lists(found):
    return [list(face.vertices) for face in found.data.polygons]


def seams_of(found):
    """The marked seams as pairs of vertices."""
    return read(found, "edges", "vertices", np.int32, 2)[read(found, "edges", "use_seam", bool)]


def joined(meshes):
    """Meshes as the add-on reads them, as one."""
    from abf_unwrap.mesh_arrays import MeshArrays

    def after(counts):
        return np.cumsum([0, *counts])[:-1]

    def concatenate(name, shifts=None):
        arrays = [getattr(mesh, name) for mesh in meshes]
        return np.concatenate([array + shift for array, shift in zip(arrays, shifts)] if shifts is not None else arrays)

    vertices, edges = after(len(mesh.vertices) for mesh in meshes), after(len(mesh.edges) for mesh in meshes)
    sizes = np.concatenate([np.diff(mesh.offsets) for mesh in meshes])
    return MeshArrays(
        "joined",
        concatenate("vertices"),
        np.cumsum([0, *sizes]),
        concatenate("corner_vertices", vertices),
        concatenate("corner_edges", edges),
        concatenate("edges", vertices),
        concatenate("seams"),
        concatenate("chosen"),
        concatenate("uv"),
    )


def select_faces(found, chosen):
    """Selects faces, with the vertices and edges that belong to them, as in the mode of faces."""
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    for collection, name, domain in (("vertices", ".select_vert", "POINT"), ("edges", ".select_edge", "EDGE")):
        set_flags(found.data, collection, name, domain, np.zeros(len(getattr(found.data, collection)), bool))
    set_flags(found.data, "polygons", ".select_poly", "FACE", np.asarray(chosen, bool))
    found.data.update()


def set_flags(mesh, collection, name, domain, flags):
    """Blender 5.0.1 ends where `select` of edges is set in a mesh of from_pydata()."""
    if bpy.app.version < (5, 0):
        getattr(mesh, collection).foreach_set("select", flags)
        return
    if name in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[name])
    mesh.attributes.new(name, "BOOLEAN", domain).data.foreach_set("value", flags)


def selected_faces(found):
    return np.flatnonzero(read(found, "polygons", "select", bool))


@contextlib.contextmanager
def uv_editor():
    """The largest area of the window is a UV editor meanwhile, and the one that operators are called in."""
    window = bpy.context.window_manager.windows[0]
    area = max(window.screen.areas, key=lambda each: each.width * each.height)
    before, area.ui_type = area.ui_type, "UV"
    region = next(region for region in area.regions if region.type == "WINDOW")
    try:
        with bpy.context.temp_override(window=window, area=area, region=region):
            yield
    finally:
        area.ui_type = before


def select_in_uv_editor(found, chosen):
    """Selects faces of a mesh in edit mode where the UV editor has a selection of its own."""
    import bmesh

    shape = bmesh.from_edit_mesh(found.data)
    layer = shape.loops.layers.uv.active
    for face, flag in zip(shape.faces, chosen):
        if bpy.app.version >= (5, 0):
            face.uv_select = bool(flag)
        for loop in face.loops:
            if bpy.app.version >= (5, 0):
                loop.uv_select_vert = loop.uv_select_edge = bool(flag)
            else:
                loop[layer].select = loop[layer].select_edge = bool(flag)
    if bpy.app.version >= (5, 0):
        shape.uv_select_sync_valid = True
    bmesh.update_edit_mesh(found.data)


def uv_selected_faces(found):
    """The faces of which all corners are selected in the UV editor."""
    if bpy.app.version >= (5, 0):
        data, name = found.data.attributes[".uv_select_vert"].data, "value"
    else:
        data, name = found.data.uv_layers.active.data, "select"
    corners = np.empty(len(data), bool)
    data.foreach_get(name, corners)
    return np.flatnonzero([corners[face.loop_indices].all() for face in found.data.polygons])


@contextlib.contextmanager
def reports():
    """What operators report meanwhile."""
    from abf_unwrap.session import Session

    said, finish = [], Session.finish
    Session.finish = lambda session, report: finish(
        session, lambda level, text: (said.append(text), report(level, text))[1]
    )
    try:
        yield said
    finally:
        Session.finish = finish


def shown_options(operator, **options):
    """The names of the options that the redo panel shows with these values."""
    from abf_unwrap.task_operator import TaskOperator

    shown, begin = [], TaskOperator.begin
    TaskOperator.begin = lambda run, context: shown.append(type(run).option_names() - run.unused())
    try:
        operator(**options)
    finally:
        TaskOperator.begin = begin
    return shown[0]


def points_of_islands(found):
    """Points all over each island of the map."""
    from abf_unwrap.blender_mesh import read_mesh
    from abf_unwrap.islands import islands_of

    weights = np.array([(a, b, 12 - a - b) for a in range(13) for b in range(13 - a)]) / 12
    mesh, islands = read_mesh(found, "ALL"), []
    for island in islands_of(mesh, by_uv=True):
        points = []
        for begin, end in zip(island.offsets, island.offsets[1:]):
            uv = mesh.uv[island.corners[begin:end]]
            points += [weights @ uv[[0, k, k + 1]] for k in range(1, len(uv) - 1)]
        islands.append(np.concatenate(points))
    return islands


def area_in_plane(found):
    from abf_unwrap.blender_mesh import read_mesh
    from abf_unwrap.islands import islands_of

    mesh = read_mesh(found, "ALL")
    return sum(island.signed_areas(mesh.uv[island.corners].astype(float)).sum() for island in islands_of(mesh, True))


def edit(found=None):
    bpy.ops.object.mode_set(mode="EDIT")


def leave():
    bpy.ops.object.mode_set(mode="OBJECT")
