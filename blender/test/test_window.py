# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in a window of Blender, where operators run beside it and Esc ends them:
xvfb-run blender --factory-startup --enable-event-simulate --python test_window.py -- ADD-ON [FOLDER]"""

import os
import sys
import traceback
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes
from addon import install
from scenes import edit, select_faces, uv_of

STEP = 0.1  # seconds between two looks


def window_context():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type in {"VIEW_3D", "IMAGE_EDITOR"})
    area.ui_type = "UV"
    region = next(region for region in area.regions if region.type == "WINDOW")
    return {"window": window, "screen": window.screen, "area": area, "region": region}


def press(key):
    for value in ("PRESS", "RELEASE"):
        bpy.context.window_manager.windows[0].event_simulate(type=key, value=value, x=400, y=400)


jobs = []


def keep_jobs():
    """Keeps the jobs that operators start."""
    from abf_unwrap.job import Job

    start = Job.start

    def start_and_keep(job):
        jobs.append(job)
        start(job)

    Job.start = start_and_keep


def checks():
    """A generator that yields where Blender has to go on."""
    scenes.clear()
    found = scenes.add_polygons(1, subdivisions=5)
    found.data.uv_layers.new()
    found.data.update()
    name, before = found.name, uv_of(found)
    select_faces(found, np.ones(len(found.data.polygons)))
    edit()
    bpy.ops.ed.undo_push(message="before")
    yield
    with bpy.context.temp_override(**window_context()):
        bpy.ops.uv.select_all(action="SELECT")
        assert bpy.ops.uv.abf_auto_seams("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    assert jobs and not jobs[-1].is_cancelled
    press("ESC")
    for _ in range(100):
        yield
        if bpy.context.mode == "EDIT_MESH":
            break
    assert jobs[-1].is_cancelled, "Esc was not heard"
    assert bpy.context.mode == "EDIT_MESH", "the operator did not end"
    assert np.array_equal(uv_of(bpy.data.objects[name]), before), "a cancelled run changed coordinates"

    with bpy.context.temp_override(**window_context()):
        assert bpy.ops.uv.abf_auto_seams("INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    for _ in range(600):
        yield
        if bpy.context.mode == "EDIT_MESH":
            break
    assert jobs[-1].error is None, jobs[-1].error
    assert jobs[-1].stage, "no progress was told"
    after = uv_of(bpy.data.objects[name])
    assert not np.array_equal(after, before), "coordinates were not written"
    yield
    assert bpy.context.window_manager.operators[-1].bl_idname == "UV_OT_abf_auto_seams", "the redo panel has no options"
    with bpy.context.temp_override(**window_context()):
        bpy.ops.ed.undo()
    assert np.array_equal(uv_of(bpy.data.objects[name]), before), "undo did not bring the coordinates back"


def run(steps):
    try:
        next(steps)
        return STEP
    except StopIteration:
        status = 0
    except BaseException:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


if __name__ == "__main__":
    install()
    keep_jobs()
    steps = checks()
    bpy.app.timers.register(lambda: run(steps), first_interval=1)
