# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the picture of the manual's page, in a window of Blender:
xvfb-run blender --factory-startup --enable-event-simulate --python take_picture.py -- ADD-ON [MODULE] PICTURE.png"""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent / "test"))
import scenes
from addon import install


def area_of(kind):
    return next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == kind)


def region_of(area, kind):
    return next(region for region in area.regions if region.type == kind)


def override(area):
    window = bpy.context.window_manager.windows[0]
    return bpy.context.temp_override(window=window, area=area, region=region_of(area, "WINDOW"))


def checkered():
    """A material with squares that show the coordinates."""
    image = bpy.data.images.new("checker", 1024, 1024)
    image.generated_type = "UV_GRID"
    material = bpy.data.materials.new("checker")
    material.use_nodes = True
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    material.node_tree.nodes.active = node
    return material


def steps():
    """A generator that yields where Blender has to draw."""
    window = bpy.context.window_manager.windows[0]
    window.workspace = bpy.data.workspaces["UV Editing"]
    yield
    scenes.clear()
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.object
    monkey.data.materials.append(checkered())
    scenes.select_faces(monkey, np.ones(len(monkey.data.polygons)))
    for kind in ("OUTLINER", "PROPERTIES"):
        with override(area_of(kind)):
            bpy.ops.screen.area_close()
    yield
    view, editor = area_of("VIEW_3D"), area_of("IMAGE_EDITOR")
    with override(view):
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.uv.abf_auto_seams("EXEC_DEFAULT", seams="hidden")
        bpy.context.tool_settings.use_uv_select_sync = True
        bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    view.spaces.active.shading.color_type = "TEXTURE"
    view.spaces.active.overlay.show_floor = view.spaces.active.overlay.show_cursor = False
    editor.spaces.active.show_region_ui = True
    yield
    editor.spaces.active.image = None  # islands are seen better without
    yield
    with override(view):
        bpy.ops.view3d.view_axis(type="FRONT")
        bpy.ops.view3d.view_orbit(angle=0.5, type="ORBITRIGHT")
        bpy.ops.view3d.view_orbit(angle=0.3, type="ORBITUP")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.view3d.view_selected()
        bpy.ops.mesh.select_all(action="DESELECT")
    with override(editor):
        bpy.ops.image.view_all(fit_view=True)
        bpy.ops.image.view_zoom_out(location=(0, 0.5))
    yield
    # The tabs are at the right side of the sidebar. Ours has been found when its panel is drawn.
    drawn, draw = [], bpy.types.IMAGE_PT_abf_unwrap.draw
    bpy.types.IMAGE_PT_abf_unwrap.draw = lambda panel, context: (drawn.append(True), draw(panel, context))[1]
    sidebar = region_of(editor, "UI")
    x = sidebar.x + sidebar.width - 8
    for y in range(sidebar.y + sidebar.height - 20, sidebar.y, -20):
        window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=x, y=y)
        for value in ("PRESS", "RELEASE"):
            window.event_simulate(type="LEFTMOUSE", value=value, x=x, y=y)
        yield
        if drawn:
            break
    yield
    bpy.ops.screen.screenshot(filepath=sys.argv[-1])


def run(rest):
    status = 0
    try:
        next(rest)
        return 0.3
    except StopIteration:
        pass
    except BaseException as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr, flush=True)
        status = 1
    os._exit(status)


if __name__ == "__main__":
    install()
    bpy.context.preferences.view.show_splash = False
    rest = steps()
    bpy.app.timers.register(lambda: run(rest), first_interval=1)
