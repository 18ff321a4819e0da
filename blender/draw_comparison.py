# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture of the manual that compares maps: Blender's monkey with a texture, and its islands below,
coloured by their change of areas. In bpy from PyPI: python draw_comparison.py -- ADD-ON PICTURE.png"""

import sys
from pathlib import Path

import bpy
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "test"), str(HERE.parent / "benchmark/Angle_based_flattening")]
import scenes
from addon import install

NAMES = ["Auto Seams and Unwrap", "*Angle Based*", "*Minimum Stretch*", "*Smart UV Project*"]
WIDTH = 2.6  # of a column


def material(name, source):
    """One that shines by itself, so that the picture has the colours of the source: a node, and its output."""
    made = bpy.data.materials.new(name)
    if bpy.app.version < (5, 0):
        made.use_nodes = True  # always so from then on
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    links.new(emission.outputs[0], output.inputs["Surface"])
    if source is not None:
        node, socket = source(nodes)
        links.new(node.outputs[socket], emission.inputs["Color"])
    else:
        emission.inputs["Color"].default_value = (0.02, 0.02, 0.02, 1)
    return made


def texture(nodes):
    image = bpy.data.images.new("checker", 1024, 1024)
    image.generated_type = "UV_GRID"
    node = nodes.new("ShaderNodeTexImage")
    node.image = image
    return node, "Color"


def colours(nodes):
    node = nodes.new("ShaderNodeVertexColor")
    node.layer_name = "Area stretch"
    return node, "Color"


def lines(name, points, pairs, place, width):
    """Edges as tubes."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, pairs, [])
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    bpy.ops.object.select_all(action="DESELECT")
    made.select_set(True)
    bpy.context.view_layer.objects.active = made
    bpy.ops.object.convert(target="CURVE")
    made = bpy.context.object
    made.data.bevel_depth, made.location = width, place
    made.data.materials.append(bpy.data.materials["line"])


def add_islands(found, place):
    """The map as a mesh in the plane of the picture, and its square."""
    uv = scenes.uv_of(found)
    points = np.column_stack([uv[:, 0], np.zeros(len(uv)), uv[:, 1]]) * 2
    flat = scenes.add("islands", points, [face.loop_indices for face in found.data.polygons])
    colour = flat.data.color_attributes.new("Area stretch", "BYTE_COLOR", "CORNER")
    values = np.empty(4 * len(uv), np.float32)
    found.data.color_attributes["Area stretch"].data.foreach_get("color", values)
    colour.data.foreach_set("color", values)
    flat.data.materials.append(bpy.data.materials["colours"])
    flat.location = place
    pairs = [tuple(edge.vertices) for edge in flat.data.edges]
    lines("edges", [tuple(point) for point in points], pairs, (place[0], place[1] - 0.02, place[2]), 0.003)
    square = [(0, 0, 0), (2, 0, 0), (2, 0, 2), (0, 0, 2)]
    lines("square", square, [(0, 1), (1, 2), (2, 3), (3, 0)], place, 0.006)


def add_text(text, place):
    curve = bpy.data.curves.new("text", "FONT")
    curve.body, curve.size, curve.align_x = text, 0.2, "CENTER"
    made = bpy.data.objects.new("text", curve)
    made.rotation_euler, made.location = (np.pi / 2, 0, 0), place
    made.data.materials.append(bpy.data.materials["line"])
    bpy.context.scene.collection.objects.link(made)


def draw(picture):
    from blender import OPERATORS  # of the benchmark

    scenes.clear()
    for name, source in (("texture", texture), ("colours", colours), ("line", None)):
        material(name, source)
    bpy.context.tool_settings.use_uv_select_sync = True
    bpy.ops.mesh.primitive_monkey_add()
    first = bpy.context.object
    for k, name in enumerate(NAMES):
        bpy.ops.object.select_all(action="DESELECT")
        found = first if k == 0 else first.copy()
        if k > 0:  # with the seams of the first one
            found.data = first.data.copy()
            bpy.context.scene.collection.objects.link(found)
        found.select_set(True)
        bpy.context.view_layer.objects.active = found
        scenes.select_faces(found, np.ones(len(found.data.polygons)))
        bpy.ops.object.mode_set(mode="EDIT")
        OPERATORS[name]()
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.ops.uv.abf_show_stretch(measure="AREA", largest=1.5, in_viewport=False)
        found.data.materials.clear()
        found.data.materials.append(bpy.data.materials["texture"])
        found.location, found.rotation_euler = (k * WIDTH, 0, 3.4), (0, 0, 0.4)
        add_islands(found, (k * WIDTH - 1, 0, 0))
        add_text(name.strip("*"), (k * WIDTH, 0, 4.6))
    render(picture)


def render(picture):
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.data.type, camera.data.ortho_scale = "ORTHO", WIDTH * len(NAMES) + 0.3
    camera.location = ((len(NAMES) - 1) * WIDTH / 2, -20, 2.35)
    camera.rotation_euler = (np.pi / 2, 0, 0)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 64, False
    scene.world = bpy.data.worlds.new("white")
    if bpy.app.version < (5, 0):
        scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 1000, 500, 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode, scene.render.image_settings.compression = "RGB", 100
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    install()
    draw(sys.argv[-1])
