# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads Blender's meshes into arrays, and writes arrays into them, in object mode: edit mode has its own copy of
them."""

from __future__ import annotations

from typing import Any, Optional

import bpy
import numpy as np

from .mesh_arrays import BadInput, MeshArrays, MeshResult

NEW_LAYER = "ABF++"
MOST_LAYERS = 8  # of a mesh in Blender


def values(collection: Any, name: str, kind: Any, width: int = 1) -> np.ndarray:
    """A property of all elements of a collection, with a row for each if there are several values."""
    array = np.empty(len(collection) * width, kind)
    collection.foreach_get(name, array)
    return array.reshape(-1, width) if width > 1 else array


# A property of elements, and the attribute that has it from Blender 4.2 on, which is read many times as fast.
ATTRIBUTES = {
    ("vertices", "co"): ("position", "vector"),
    ("loops", "vertex_index"): (".corner_vert", "value"),
    ("loops", "edge_index"): (".corner_edge", "value"),
    ("edges", "vertices"): (".edge_verts", "value"),
}
FLAGS = {
    ("edges", "use_seam"): "uv_seam",
    ("polygons", "select"): ".select_poly",
    ("polygons", "hide"): ".hide_poly",
}


def elements_of(mesh: bpy.types.Mesh, elements: str, name: str, kind: Any, width: int = 1) -> np.ndarray:
    """A property of all vertices, edges, faces or corners."""
    if bpy.app.version < (4, 2):
        return values(getattr(mesh, elements), name, kind, width)
    attribute, value = ATTRIBUTES[elements, name]
    return values(mesh.attributes[attribute].data, value, kind, width)


def flags_of(mesh: bpy.types.Mesh, elements: str, name: str) -> np.ndarray:
    """A flag of all vertices, edges or faces. Before Blender 5.0, not all of them are attributes."""
    if bpy.app.version < (5, 0):
        return values(getattr(mesh, elements), name, bool)
    all_elements = getattr(mesh, elements)
    try:
        return flag_attribute(mesh, FLAGS[elements, name], len(all_elements))
    except RuntimeError:  # Blender 5.0 keeps flags that are all alike once, and finds no array of them
        return np.full(len(all_elements), getattr(all_elements[0], name))


def flag_attribute(mesh: bpy.types.Mesh, name: str, number: int) -> np.ndarray:
    """Without the attribute, no flag is set."""
    attribute = mesh.attributes.get(name)
    return np.zeros(number, bool) if attribute is None else values(attribute.data, "value", bool)


def uv_of(layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    """The coordinates of each corner."""
    if bpy.app.version < (4, 2):
        return values(layer.data, "uv", np.float32, 2)
    return values(layer.uv, "vector", np.float32, 2)


def pins_of(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer) -> np.ndarray:
    """A flag for each corner. `pin_uv` of all would make the attribute, and takes longer than all else."""
    if bpy.app.version < (4, 2):
        return values(layer.data, "pin_uv", bool)
    return flag_attribute(mesh, f".pn.{layer.name}", len(mesh.loops))


def mesh_objects(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The meshes that the user works on: those in edit mode, or else those that are selected. One object for each
    mesh."""
    if context.mode == "EDIT_MESH":
        candidates = context.objects_in_mode_unique_data
    else:
        candidates = context.selected_objects
    objects: dict[str, bpy.types.Object] = {}
    for candidate in candidates:
        if candidate.type == "MESH":
            objects.setdefault(candidate.data.name_full, candidate)
    return list(objects.values())


def selection_of(context: bpy.types.Context) -> str:
    """Which faces take part, as Blender's own operators have it: in edit mode, those that are selected in the
    mesh, or in the UV editor without sync, those that are also selected there."""
    if context.mode != "EDIT_MESH":
        return "ALL"
    in_uv_editor = context.area is not None and context.area.type == "IMAGE_EDITOR"
    return "UV" if in_uv_editor and not context.scene.tool_settings.use_uv_select_sync else "MESH"


def uv_selected_faces(mesh: bpy.types.Mesh) -> np.ndarray:
    """A flag for each face: whether all of it is selected in the UV editor."""
    if bpy.app.version >= (5, 0):  # which has one such selection for all layers
        return flag_attribute(mesh, ".uv_select_face", len(mesh.polygons))
    corners = values(mesh.uv_layers.active.data, "select", bool)
    return np.logical_and.reduceat(corners, values(mesh.polygons, "loop_start", np.int32))


def read_mesh(found: bpy.types.Object, selection: str) -> MeshArrays:
    """A mesh in the size that its object has in the scene. The selection is ALL, MESH or UV."""
    mesh = found.data
    if mesh.library is not None:
        raise BadInput(f"{found.name} is linked from another file: make it local first")
    if len(mesh.polygons) == 0:
        raise BadInput(f"{found.name} has no faces")
    vertices = elements_of(mesh, "vertices", "co", np.float32, 3)
    corner_vertices = elements_of(mesh, "loops", "vertex_index", np.int32)
    is_broken = ~np.isfinite(vertices).all(axis=1)
    if is_broken.any():
        corner_faces = np.repeat(np.arange(len(mesh.polygons)), values(mesh.polygons, "loop_total", np.int32))
        raise BadInput(
            f"{found.name}: vertex {np.flatnonzero(is_broken)[0]} has a coordinate that is not finite",
            [(found, corner_faces[is_broken[corner_vertices]])],
        )
    matrix = np.array(found.matrix_world.to_3x3())
    if not np.allclose(matrix.T @ matrix, np.eye(3), atol=1e-6):
        vertices = vertices.astype(float) @ matrix.T
    layer = mesh.uv_layers.active
    chosen = np.ones(len(mesh.polygons), bool)
    if selection != "ALL":
        chosen = flags_of(mesh, "polygons", "select") & ~flags_of(mesh, "polygons", "hide")
    if selection == "UV" and layer is not None:
        chosen &= uv_selected_faces(mesh)
    return MeshArrays(
        name=found.name,
        vertices=vertices,
        offsets=np.append(values(mesh.polygons, "loop_start", np.int32), np.int32(len(mesh.loops))),
        corner_vertices=corner_vertices,
        corner_edges=elements_of(mesh, "loops", "edge_index", np.int32),
        edges=elements_of(mesh, "edges", "vertices", np.int32, 2),
        seams=flags_of(mesh, "edges", "use_seam"),
        chosen=chosen,
        uv=None if layer is None else uv_of(layer),
        pinned=None if layer is None else pins_of(mesh, layer),
    )


def is_same_mesh(found: Optional[bpy.types.Object], arrays: MeshArrays) -> bool:
    """Whether the object still has a mesh as large as the one that was read. More cannot change while an operator runs
    but by a script."""
    if found is None or found.type != "MESH":
        return False
    mesh = found.data
    return (len(mesh.vertices), len(mesh.edges), len(mesh.loops), len(mesh.polygons)) == (
        len(arrays.vertices),
        len(arrays.edges),
        len(arrays.corner_vertices),
        arrays.number_of_faces,
    )


def can_have_layer(mesh: bpy.types.Mesh, makes_new: bool) -> bool:
    return len(mesh.uv_layers) < MOST_LAYERS or not (makes_new or mesh.uv_layers.active is None)


def writable_layer(mesh: bpy.types.Mesh, makes_new: bool) -> bpy.types.MeshUVLoopLayer:
    """The active UV layer, or a new one that begins with its coordinates."""
    if makes_new or mesh.uv_layers.active is None:
        mesh.uv_layers.active = mesh.uv_layers.new(name=NEW_LAYER)
    return mesh.uv_layers.active


def write_result(mesh: bpy.types.Mesh, layer: bpy.types.MeshUVLoopLayer, result: MeshResult) -> None:
    """Writes the coordinates that are not NaN, and the seams if there are any."""
    uv = result.uv.astype(np.float32)
    stays = np.isnan(uv[:, 0])
    if stays.any():
        uv[stays] = uv_of(layer)[stays]
    layer.data.foreach_set("uv", uv.ravel())  # `layer.uv` would write into what undo keeps, up to Blender 5.0
    if result.seams is not None:
        write_flags(mesh, "edges", "use_seam", "uv_seam", result.seams)
    mesh.update()


def write_flags(mesh: bpy.types.Mesh, elements: str, name: str, attribute: str, flags: np.ndarray) -> None:
    """A flag of all vertices, edges, faces or corners, which is an attribute from Blender 5.0 on. It is made
    anew there: if it had one value everywhere, which is kept once, Blender 5.0 ends as it writes others."""
    if bpy.app.version < (5, 0):
        collection = mesh.uv_layers.active.data if elements == "loops" else getattr(mesh, elements)
        collection.foreach_set(name, flags)
        return
    domain = {"vertices": "POINT", "edges": "EDGE", "polygons": "FACE", "loops": "CORNER"}[elements]
    before = mesh.attributes.get(attribute)
    if before is not None:
        mesh.attributes.remove(before)
    mesh.attributes.new(attribute, "BOOLEAN", domain).data.foreach_set("value", flags)


def select_faces(mesh: bpy.types.Mesh, faces: np.ndarray) -> None:
    """Selects these faces and no others."""
    corner_faces = np.repeat(np.arange(len(mesh.polygons)), values(mesh.polygons, "loop_total", np.int32))
    corners = np.isin(corner_faces, faces)
    for elements, attribute, chosen in (
        ("vertices", ".select_vert", elements_of(mesh, "loops", "vertex_index", np.int32)[corners]),
        ("edges", ".select_edge", elements_of(mesh, "loops", "edge_index", np.int32)[corners]),
        ("polygons", ".select_poly", faces),
    ):
        flags = np.zeros(len(getattr(mesh, elements)), bool)
        flags[chosen] = True
        write_flags(mesh, elements, "select", attribute, flags)
    mesh.update()


def select_uv_faces(mesh: bpy.types.Mesh, faces: np.ndarray) -> None:
    """Selects these faces and no others in the UV editor, where it has a selection of its own."""
    flags = np.zeros(len(mesh.polygons), bool)
    flags[faces] = True
    corners = np.repeat(flags, values(mesh.polygons, "loop_total", np.int32))
    write_flags(mesh, "loops", "select", ".uv_select_vert", corners)
    write_flags(mesh, "loops", "select_edge", ".uv_select_edge", corners)
    if bpy.app.version >= (5, 0):
        write_flags(mesh, "polygons", "", ".uv_select_face", flags)
    mesh.update()


def write_colours(mesh: bpy.types.Mesh, name: str, face_colours: np.ndarray) -> None:
    """A colour attribute with one colour (r, g, b) for all corners of each face; it becomes the active one."""
    attribute = mesh.color_attributes.get(name)
    if attribute is not None and (attribute.domain, attribute.data_type) != ("CORNER", "BYTE_COLOR"):
        mesh.color_attributes.remove(attribute)
        attribute = None
    if attribute is None:
        attribute = mesh.color_attributes.new(name=name, type="BYTE_COLOR", domain="CORNER")
    sizes = values(mesh.polygons, "loop_total", np.int32)
    colours = np.ones((len(mesh.loops), 4), np.float32)
    colours[:, :3] = np.repeat(face_colours, sizes, axis=0)
    attribute.data.foreach_set("color", colours.ravel())
    mesh.color_attributes.active_color = attribute
    mesh.update()
