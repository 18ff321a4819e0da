# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints what Blender reads of each file, in a line of JSON, as the script `run` wants it.
Usage: blender -b --factory-startup -P read_in_blender.py -- FILE..."""

import json
import os
import sys

import bpy


def corners():
    """All faces, in coordinates of the world, with their layers of texture coordinates"""
    for thing in bpy.context.scene.objects:
        mesh = thing.data
        for face in mesh.polygons:
            yield [[*(thing.matrix_world @ mesh.vertices[mesh.loops[i].vertex_index].co),
                    *(x for layer in mesh.uv_layers for x in layer.data[i].uv)] for i in face.loop_indices]


output = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)  # What Blender says itself goes to standard error.
for path in sys.argv[sys.argv.index("--") + 1:]:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="io_mesh_ply")
    try:
        if path.endswith(".obj"):  # the axes as they are in the file
            bpy.ops.wm.obj_import(filepath=path, forward_axis="Y", up_axis="Z")
        elif path.endswith(".ply"):
            bpy.ops.import_mesh.ply(filepath=path)
        else:
            bpy.ops.preferences.addon_enable(module="io_scene_gltf2")
            bpy.ops.import_scene.gltf(filepath=path)
            for thing in bpy.context.scene.objects:  # Blender turns y to z
                thing.matrix_world = ((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1))
            bpy.context.view_layer.update()
        result = {"faces": list(corners())}
    except Exception as error:  # whatever an importer throws
        result = {"error": str(error)}
    print(json.dumps(result), file=output, flush=True)
