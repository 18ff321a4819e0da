# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in Blender, on generated meshes:
blender --background --factory-startup --python test_blender.py -- ADD-ON [FOLDER]"""

import contextlib
import os
import subprocess
import sys
import unittest
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes
from addon import install
from scenes import edit, faces_as_lists, leave, polygons_of, seams_of, select_faces, selected_faces, uv_of


def faults_of(*objects):
    """The faces of some objects that are flipped or overlap others, with each other as well."""
    from abf_unwrap.blender_mesh import read_mesh
    from abf_unwrap.certificate import faults

    whole = scenes.joined([read_mesh(found, "ALL") for found in objects])
    return faults(whole, whole.uv, whole.uv).tolist()


def coordinates_of(objects):
    """The coordinates of each object, to be compared, without the signs of zeros: Blender 5 changes these when
    edit mode begins or ends."""
    return [(uv_of(each) + np.float32(0)).tobytes() if each.data.uv_layers else None for each in objects]


class InBlender(unittest.TestCase):
    def setUp(self):
        scenes.clear()

    def certify(self, *objects):
        self.assertEqual(faults_of(*objects), [])

    def assert_fails(self, operator, expected, *objects, **options):
        """An operator is refused, and the coordinates stay."""
        before = coordinates_of(objects)
        with self.assertRaisesRegex(RuntimeError, expected):
            operator(**options)
        self.assertEqual(coordinates_of(objects), before)


class Extension(unittest.TestCase):
    @unittest.skipIf(bpy.app.version < (4, 2), "Blender has had extensions since 4.2")
    def test_blender_accepts_the_zip_file(self):
        """By its own rules for extensions."""
        addon = Path(sys.argv[sys.argv.index("--") + 1])
        if addon.suffix != ".zip":
            self.skipTest("the add-on is a folder")
        rules = Path(bpy.utils.system_resource("SCRIPTS")) / "addons_core/bl_pkg/cli/blender_ext.py"
        checked = subprocess.run([sys.executable, rules, "validate", addon], capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)


class Certificates(InBlender):
    def test_rounding(self):
        """Faces that are too small for single precision are named."""
        from abf_unwrap.blender_mesh import read_mesh
        from abf_unwrap.certificate import faults_of_rounding

        mesh = read_mesh(scenes.add_patch(is_planar=True), "ALL")
        uv = mesh.uv.astype(float)
        self.assertEqual(faults_of_rounding(mesh, uv).tolist(), [])
        self.assertEqual(faults_of_rounding(mesh, uv * 1e-9 + 0.5).tolist(), list(range(40)))
        uv[mesh.corner_faces() == 7] = np.nan
        self.assertEqual(len(faults_of_rounding(mesh, uv * 1e-9 + 0.5)), 39)


class Unwrap(InBlender):
    def test_a_tube_is_unrolled_along_its_seam(self):
        tube = scenes.add_tube()
        faces = faces_as_lists(tube)
        self.assertEqual(bpy.ops.uv.abf_unwrap(), {"FINISHED"})
        self.assertEqual(faces_as_lists(tube), faces)  # still quads
        self.certify(tube)
        measures = abf.measure(
            scenes.read(tube, "vertices", "co", np.float32, 3), polygons_of(tube), uv_of(tube).astype(float)
        )
        self.assertLess(measures["l2_stretch"], 1.001)

    def test_coordinates_are_those_of_the_module(self):
        tube = scenes.add_tube()
        bpy.ops.uv.abf_unwrap(resolution=512, gutter=3)
        atlas = abf.atlas(
            scenes.read(tube, "vertices", "co", np.float32, 3),
            polygons_of(tube),
            marked_seams=seams_of(tube),
            stretch_bound=np.inf,
            seam_price=np.inf,
            resolution=512,
            gutter=3,
        )
        self.assertTrue(np.array_equal(uv_of(tube), np.asarray(atlas.uv, np.float32)))

    def test_only_selected_faces(self):
        tube = scenes.add_tube()
        bpy.ops.uv.abf_unwrap()
        before = uv_of(tube)
        chosen = np.arange(len(tube.data.polygons)) < 40
        select_faces(tube, chosen)
        edit()
        bpy.ops.uv.abf_unwrap(resolution=64)
        self.assertEqual(bpy.context.mode, "EDIT_MESH")
        leave()
        corners = np.repeat(chosen, 4)
        self.assertTrue(np.array_equal(uv_of(tube)[~corners], before[~corners]))
        self.assertFalse((uv_of(tube)[corners] == before[corners]).all(axis=1).any())
        self.assertEqual(selected_faces(tube).tolist(), list(range(40)))

    def test_pins_stay(self):
        patch = scenes.add_patch(is_planar=True)
        corners = [0, len(patch.data.loops) - 2]  # opposite corners of the patch
        scenes.pin(patch, corners)
        places = uv_of(patch)[corners]
        bpy.ops.uv.abf_unwrap()
        np.testing.assert_allclose(uv_of(patch)[corners], places, atol=1e-5)
        self.certify(patch)

    def test_pinned_islands_beside_others(self):
        """Two tubes in one mesh: the pinned one stays in place, the other one is packed."""
        scenes.add_tube()
        other = scenes.add_tube("other")
        bpy.ops.object.join()
        bpy.ops.uv.abf_unwrap()
        before = uv_of(other)
        scenes.pin(other, [0, 93])
        bpy.ops.uv.abf_unwrap()
        moved = np.abs(uv_of(other) - before).max(axis=1) > 1e-3
        self.assertEqual((moved[:384].any(), moved[384:].all()), (False, True))

    def test_scale_of_the_object(self):
        """A patch that its object stretches is unwrapped as if its mesh were stretched."""
        patch = scenes.add_patch()
        patch.scale = (1, 3, 1)
        bpy.context.view_layer.update()
        bpy.ops.uv.abf_unwrap()
        stretched = scenes.add_patch("stretched")
        stretched.data.transform(patch.matrix_world)
        patch.select_set(False)
        bpy.ops.uv.abf_unwrap()
        np.testing.assert_allclose(uv_of(patch), uv_of(stretched), atol=1e-5)


class AutoSeams(InBlender):
    def test_closed_surfaces_of_polygons(self):
        for seed in range(3):
            scenes.clear()
            found = scenes.add_polygons(seed)
            faces = faces_as_lists(found)
            bpy.ops.uv.abf_auto_seams()
            self.assertEqual(faces_as_lists(found), faces)
            self.assertGreater(len(seams_of(found)), 0)
            self.certify(found)

    def test_seams_are_those_of_the_module(self):
        found = scenes.add_polygons(5)
        bpy.ops.uv.abf_auto_seams(purpose="few-charts", seams="hidden", stretch_bound=1.3)
        atlas = abf.atlas(
            scenes.read(found, "vertices", "co", np.float32, 3),
            polygons_of(found),
            purpose="few-charts",
            seams="hidden",
            stretch_bound=1.3,
        )
        self.assertTrue(np.array_equal(uv_of(found), np.asarray(atlas.uv, np.float32)))
        pairs = {tuple(sorted(pair)) for pair in np.asarray(atlas.seams).tolist()}
        self.assertEqual({tuple(sorted(pair)) for pair in seams_of(found).tolist()}, pairs)

    def test_marked_seams(self):
        found = scenes.add_polygons(6)
        marked = scenes.read(found, "edges", "vertices", np.int32, 2)[100]
        for keep in (True, False):
            flags = np.zeros(len(found.data.edges), bool)
            flags[100] = True
            found.data.edges.foreach_set("use_seam", flags)
            bpy.ops.uv.abf_auto_seams(keep_marked=keep)
            self.assertEqual(marked.tolist() in seams_of(found).tolist(), keep)

    def test_more_seams_for_a_smaller_bound(self):
        lengths = []
        for bound in (1.02, 2.0):
            scenes.clear()
            found = scenes.add_polygons(7)
            bpy.ops.uv.abf_auto_seams(purpose="few-charts", stretch_bound=bound)
            lengths.append(len(seams_of(found)))
        self.assertGreater(lengths[0], lengths[1])

    def test_three_faces_at_an_edge(self):
        vertices = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (-1, 1, 0), (-1, -1, 0)]
        found = scenes.add("fins", vertices, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
        bpy.ops.uv.abf_auto_seams()
        self.certify(found)
        self.assertGreater(np.ptp(uv_of(found)), 0.1)

    def test_messages_name_objects(self):
        from abf_unwrap.atlas_tasks import with_names
        from abf_unwrap.blender_mesh import read_mesh

        meshes = [read_mesh(scenes.add_patch(name), "ALL") for name in ("rock", "tree")]
        self.assertEqual(with_names("mesh 1: 'mesh 0'", meshes), "tree: 'rock'")
        self.assertEqual(with_names("'mesh': bad", meshes[:1]), "'rock': bad")


class Islands(InBlender):
    def test_unfold(self):
        """All faces lie on each other."""
        patch = scenes.add_patch(uv=np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (40, 1)))
        self.assertEqual(len(faults_of(patch)), 40)
        bpy.ops.uv.abf_unfold()
        self.certify(patch)

    def test_pack_objects_into_one_square(self):
        objects = [scenes.add_patch(f"patch {k}", 4 + k, 3, is_planar=True) for k in range(3)]
        for found in objects:
            select_faces(found, np.ones(len(found.data.polygons)))
        edit()
        bpy.ops.uv.abf_pack()
        leave()
        self.certify(*objects)
        for found in objects:
            self.assertTrue(((uv_of(found) >= 0) & (uv_of(found) <= 1)).all())

    def test_pack_keeps_shapes(self):
        patch = scenes.add_patch(is_planar=True)
        before = uv_of(patch)
        bpy.ops.uv.abf_pack()
        np.testing.assert_allclose(distances(uv_of(patch)) * scale(before, uv_of(patch)), distances(before), rtol=1e-3)

    def test_pack_names_what_has_no_area(self):
        patch = scenes.add_patch(is_planar=True)
        uv = uv_of(patch)
        uv[:4] = uv[0]  # the first face
        patch.data.uv_layers.active.data.foreach_set("uv", uv.ravel())
        self.assert_fails(bpy.ops.uv.abf_pack, ".", patch)
        self.assertIn(0, selected_faces(patch))

    def test_pack_names_what_has_no_area_among_several_objects(self):
        objects = [scenes.add_patch(f"patch {k}", is_planar=True) for k in range(3)]
        uv = uv_of(objects[1])
        uv[-4:] = uv[-1]  # the last face
        objects[1].data.uv_layers.active.data.foreach_set("uv", uv.ravel())
        for found in objects:
            select_faces(found, np.ones(40))
        edit()
        self.assert_fails(bpy.ops.uv.abf_pack, ".", *objects)
        leave()
        self.assertIn(39, selected_faces(objects[1]))
        self.assertLess(len(selected_faces(objects[1])), 40)

    def test_straighten(self):
        patch = scenes.add_patch(is_planar=True)
        before = uv_of(patch)
        bpy.ops.uv.abf_straighten()
        uv = uv_of(patch)
        self.certify(patch)
        np.testing.assert_allclose(uv.min(axis=0) + uv.max(axis=0), before.min(axis=0) + before.max(axis=0), atol=1e-4)
        np.testing.assert_allclose(np.prod(np.ptp(uv, axis=0)), np.prod(np.ptp(before, axis=0)), rtol=1e-4)

    def test_straighten_with_pinned_corners(self):
        patch = scenes.add_patch(is_planar=True)
        numbers = polygons_of(patch)[1]
        scenes.pin(patch, [np.flatnonzero(numbers == vertex)[0] for vertex in (0, 8, 45, 53)])  # of the patch
        bpy.ops.uv.abf_straighten()
        uv, side = uv_of(patch), {}
        for corner, vertex in enumerate(numbers):
            side[vertex] = uv[corner]
        for ends in ((0, 8, 1), (45, 53, 1), (0, 45, 9), (8, 53, 9)):
            points = np.array([side[v] for v in range(ends[0], ends[1] + 1, ends[2])])
            self.assertLess(np.ptp(points, axis=0).min(), 1e-5)

    def test_straighten_wants_a_disk(self):
        tube = scenes.add_tube()
        for edge in tube.data.edges:
            edge.use_seam = False
        self.assert_fails(bpy.ops.uv.abf_straighten, "tube", tube)
        self.assertGreater(len(selected_faces(tube)), 0)


def distances(uv):
    return np.linalg.norm(uv - np.roll(uv, 1, axis=0), axis=1)


def scale(before, after):
    return distances(before).sum() / distances(after).sum()


class Stretch(InBlender):
    def test_colours(self):
        patch = scenes.add_patch(height=0, is_planar=True)
        uv = uv_of(patch)
        uv[:4] += [[-1, 0], [0, 0], [0, 0], [-1, 0]]  # the first face becomes twice as wide
        uv[-4:] = uv[[-3, -4, -1, -2]]  # the last one is flipped
        patch.data.uv_layers.active.data.foreach_set("uv", uv.ravel())
        bpy.ops.uv.abf_show_stretch()
        colours = patch.data.color_attributes["Angle stretch"].data
        self.assertGreater(colours[0].color[0], colours[0].color[2])  # red
        self.assertGreater(colours[8].color[2], colours[8].color[0])  # blue
        self.assertEqual([round(v) for v in colours[len(uv) - 1].color], [1, 0, 1, 1])
        self.assertEqual(patch.data.color_attributes.active_color.name, "Angle stretch")
        bpy.ops.uv.abf_show_stretch(measure="AREA")
        self.assertEqual(patch.data.color_attributes.active_color.name, "Area stretch")
        self.assertEqual(len(patch.data.color_attributes), 2)

    def test_without_coordinates(self):
        self.assert_fails(bpy.ops.uv.abf_show_stretch, "patch has no UV layer", scenes.add_patch())


class Layers(InBlender):
    def test_a_new_layer(self):
        patch = scenes.add_patch(is_planar=True)
        before = uv_of(patch)
        bpy.ops.uv.abf_unwrap(uv_layer="NEW")
        self.assertEqual(len(patch.data.uv_layers), 2)
        self.assertTrue(np.array_equal(uv_of(patch, "UVMap"), before))
        self.assertEqual(patch.data.uv_layers.active_index, 1)
        self.certify(patch)

    def test_too_many_layers(self):
        patch = scenes.add_patch(is_planar=True)
        other = scenes.add_patch("other", is_planar=True)
        while len(other.data.uv_layers) < 8:
            other.data.uv_layers.new()
        self.assert_fails(bpy.ops.uv.abf_unwrap, "other cannot have another UV layer", patch, other, uv_layer="NEW")
        self.assertEqual(len(patch.data.uv_layers), 1)


class Running(InBlender):
    def test_undo(self):
        for begin in (edit, leave):
            scenes.clear()
            name = scenes.add_patch(is_planar=True).name
            select_faces(bpy.data.objects[name], np.ones(40))
            before = uv_of(bpy.data.objects[name])
            begin()
            bpy.ops.ed.undo_push(message="before")
            bpy.ops.uv.abf_auto_seams("EXEC_DEFAULT", True)
            self.assertFalse(np.array_equal(uv_of(bpy.data.objects[name]), before))
            bpy.ops.ed.undo()
            self.assertTrue(np.array_equal(uv_of(bpy.data.objects[name]), before))

    def test_cancelled(self):
        """The module gives up when it is told to, and what comes too late is not written."""
        from abf_unwrap.job import Job

        found = scenes.add_polygons(9, subdivisions=5)
        found.data.uv_layers.new()
        before, begin, progress, errors = uv_of(found), Job.run, Job.progress, []

        def cancel_when_told(job, stage, share):
            job.cancel()
            return progress(job, stage, share)

        def cancel_at_the_end(job):
            begin(job)
            errors.append(job.error)
            job.cancel()

        Job.progress, Job.run = cancel_when_told, cancel_at_the_end
        try:
            self.assertEqual(bpy.ops.uv.abf_auto_seams(), {"CANCELLED"})
            Job.progress = progress
            self.assertEqual(bpy.ops.uv.abf_auto_seams(), {"CANCELLED"})
        finally:
            Job.progress, Job.run = progress, begin
        self.assertIsInstance(errors[0], abf.Cancelled)
        self.assertIsNone(errors[1])
        self.assertTrue(np.array_equal(uv_of(found), before))

    def test_the_mesh_changes_meanwhile(self):
        from abf_unwrap.job import Job

        patch = scenes.add_patch(is_planar=True)
        run = Job.run

        def run_and_change(job):
            run(job)
            patch.data.vertices.add(1)

        Job.run = run_and_change
        try:
            self.assert_fails(bpy.ops.uv.abf_unwrap, "changed meanwhile", patch)
        finally:
            Job.run = run

    def test_same_bits_again(self):
        found = scenes.add_polygons(8)
        bpy.ops.uv.abf_auto_seams(keep_marked=False)
        before = uv_of(found)
        bpy.ops.uv.abf_auto_seams(keep_marked=False)
        self.assertTrue(np.array_equal(uv_of(found), before))

    def test_nothing_to_do(self):
        patch = scenes.add_patch(is_planar=True)
        select_faces(patch, np.zeros(40))
        edit()
        for name in ("abf_unwrap", "abf_auto_seams", "abf_unfold", "abf_pack", "abf_straighten"):
            self.assert_fails(getattr(bpy.ops.uv, name), "No face is selected", patch)

    def test_a_selected_object_without_selected_faces(self):
        """It does not take part, and the other one does."""
        objects = [scenes.add_patch(f"patch {k}", is_planar=True) for k in range(2)]
        before = uv_of(objects[1])
        select_faces(objects[0], np.ones(40))
        select_faces(objects[1], np.zeros(40))
        edit()
        bpy.ops.uv.abf_unwrap()
        leave()
        self.assertTrue(np.array_equal(uv_of(objects[1]), before))
        self.certify(objects[0])


class Selection(InBlender):
    """Which faces take part."""

    def setUp(self):
        super().setUp()
        self.tool_settings = bpy.context.scene.tool_settings
        self.addCleanup(setattr, self.tool_settings, "use_uv_select_sync", self.tool_settings.use_uv_select_sync)

    def assert_moved(self, found, before, expected):
        moved = (uv_of(found) != before).any(axis=1).reshape(-1, 4).any(axis=1)
        self.assertEqual(moved.tolist(), expected.tolist())

    def test_hidden_faces_stay(self):
        patch = scenes.add_patch(is_planar=True)
        before = uv_of(patch)
        select_faces(patch, np.ones(40))
        patch.data.polygons.foreach_set("hide", np.arange(40) < 8)
        edit()
        bpy.ops.uv.abf_unwrap()
        leave()
        self.assert_moved(patch, before, np.arange(40) >= 8)

    def test_in_the_uv_editor(self):
        """Without sync, the faces that are selected there; with sync, those of the mesh."""
        for sync in (False, True):
            with self.subTest(sync=sync):
                scenes.clear()
                patch = scenes.add_patch(is_planar=True)
                select_faces(patch, np.ones(40))
                before = uv_of(patch)
                self.tool_settings.use_uv_select_sync = sync
                edit()
                with scenes.uv_editor():
                    scenes.select_in_uv_editor(patch, np.arange(40) < 16)
                    bpy.ops.uv.abf_unwrap()
                leave()
                self.assert_moved(patch, before, (np.arange(40) < 16) | sync)

    def test_nothing_in_the_uv_editor(self):
        patch = scenes.add_patch(is_planar=True)
        select_faces(patch, np.ones(40))
        self.tool_settings.use_uv_select_sync = False
        edit()
        with scenes.uv_editor():
            scenes.select_in_uv_editor(patch, np.zeros(40))
            for name in ("abf_unwrap", "abf_pack", "abf_set_density", "abf_select_faults"):
                self.assert_fails(getattr(bpy.ops.uv, name), "No face is selected in the UV editor", patch)

    def test_without_sync_in_the_3d_viewport(self):
        patch = scenes.add_patch(is_planar=True)
        select_faces(patch, np.ones(40))
        before = uv_of(patch)
        self.tool_settings.use_uv_select_sync = False
        edit()
        with scenes.uv_editor():
            scenes.select_in_uv_editor(patch, np.arange(40) < 16)
        bpy.ops.uv.abf_unwrap()
        leave()
        self.assert_moved(patch, before, np.ones(40, bool))


class Objects(InBlender):
    """Where the mesh is not all that the user sees."""

    def test_instances(self):
        """Two objects with one mesh: it is unwrapped once."""
        patch = scenes.add_patch()
        twin = bpy.data.objects.new("twin", patch.data)
        bpy.context.scene.collection.objects.link(twin)
        twin.select_set(True)
        bpy.ops.uv.abf_unwrap()
        self.certify(patch)
        self.assertIs(twin.data.uv_layers.active.data[0].id_data, patch.data)

    def test_modifiers(self):
        """The mesh below the modifiers is unwrapped, and they stay."""
        patch, plain = scenes.add_patch(), scenes.add_patch("plain")
        plain.select_set(False)
        patch.modifiers.new("Subdivision", "SUBSURF")
        bpy.ops.uv.abf_unwrap()
        patch.select_set(False)
        plain.select_set(True)
        bpy.ops.uv.abf_unwrap()
        self.assertTrue(np.array_equal(uv_of(patch), uv_of(plain)))
        self.assertEqual([each.type for each in patch.modifiers], ["SUBSURF"])

    def test_shape_keys(self):
        """The map is that of the basis, also in edit mode with another key, and the keys stay."""
        patch, plain = scenes.add_patch(), scenes.add_patch("plain")
        patch.shape_key_add(name="Basis")
        key = patch.shape_key_add(name="flat")
        points = scenes.read(patch, "vertices", "co", np.float32, 3) * np.float32([1, 3, 0])
        key.data.foreach_set("co", points.ravel())
        patch.active_shape_key_index = 1
        for found in (patch, plain):
            bpy.ops.object.select_all(action="DESELECT")
            found.select_set(True)
            bpy.context.view_layer.objects.active = found
            select_faces(found, np.ones(40))
            edit()
            bpy.ops.uv.abf_unwrap()
            leave()
        self.assertTrue(np.array_equal(uv_of(patch), uv_of(plain)))
        after = np.empty(points.size, np.float32)
        patch.data.shape_keys.key_blocks["flat"].data.foreach_get("co", after)
        np.testing.assert_array_equal(after.reshape(-1, 3), points)


class Presets(InBlender):
    def test_presets_are_their_options(self):
        """A preset gives what its options give one by one."""
        from abf_unwrap.presets import PRESETS

        for name, (_, _, options) in PRESETS.items():
            with self.subTest(preset=name):
                maps = []
                # No option has blocks, which the preset of light maps has
                given = {key: value for key, value in options.items() if key != "block"}
                for keywords in ({"preset": name}, given):
                    scenes.clear()
                    found = scenes.add_polygons(3)
                    bpy.ops.uv.abf_auto_seams(**keywords)
                    maps.append(uv_of(found))
                self.assertEqual(np.array_equal(*maps), "block" not in options)

    def test_light_maps_have_blocks_of_their_own(self):
        found = scenes.add_polygons(3)
        found.data.uv_layers.new(name="UVMap")
        bpy.ops.uv.abf_auto_seams(preset="LIGHT_MAP")
        self.assertEqual(found.data.uv_layers.active_index, 1)
        self.certify(found)
        owners = {}
        for island, points in enumerate(scenes.points_of_islands(found)):
            for block in np.unique(np.floor(points * 512 / 4).astype(int), axis=0).tolist():
                self.assertEqual(owners.setdefault(tuple(block), island), island)

    def test_the_panel_hides_what_a_preset_sets(self):
        from abf_unwrap.presets import PRESETS

        operator = bpy.ops.uv.abf_auto_seams
        scenes.add_patch()
        for name in ("CUSTOM", *PRESETS):
            shown = scenes.shown_options(operator, preset=name)
            self.assertIn("preset", shown)
            self.assertEqual("resolution" in shown, name == "CUSTOM")
        self.assertNotIn("density", scenes.shown_options(operator))
        self.assertIn("density", scenes.shown_options(operator, pack_into="TILES"))


class Density(InBlender):
    def test_tiles(self):
        """Twice the density takes four times the area in the plane, and tiles are numbered as those of UDIM."""
        areas = []
        for density in (100, 200):
            scenes.clear()
            found = scenes.add_polygons(4)
            bpy.ops.uv.abf_auto_seams(purpose="texture", resolution=256, pack_into="TILES", density=density)
            self.certify(found)
            areas.append(scenes.area_in_plane(found))
            uv = uv_of(found).reshape(-1, 2)
            tiles = {tuple(np.floor(uv[face.loop_indices].mean(axis=0)).astype(int)) for face in found.data.polygons}
            self.assertGreater(len(tiles), 1)
            self.assertTrue(all(0 <= column < 10 for column, _ in tiles))
            for face in found.data.polygons:
                corners = uv[face.loop_indices]
                self.assertTrue((np.floor(corners.min(axis=0)) + 1 >= corners.max(axis=0)).all())
        self.assertAlmostEqual(areas[1] / areas[0], 4, delta=0.05)

    def test_set_and_show(self):
        patch = scenes.add_patch(height=0, is_planar=True)
        scene = bpy.context.scene
        self.addCleanup(setattr, scene.unit_settings, "scale_length", scene.unit_settings.scale_length)
        for unit in (1, 0.01):
            scene.unit_settings.scale_length = unit
            bpy.ops.uv.abf_set_density(density=300 / unit, resolution=1000)
            uv = uv_of(patch)
            np.testing.assert_allclose(np.ptp(uv, axis=0), np.array([8, 5]) * 0.3, rtol=1e-5)
            np.testing.assert_allclose(uv.min(axis=0) + uv.max(axis=0), [8, 5], rtol=1e-5)
            with scenes.reports() as said:
                bpy.ops.uv.abf_show_density(resolution=1000)
            self.assertIn(f"{300 / unit:.4g} texels per metre in the median of 1 islands", said[-1])

    def test_without_coordinates_or_area(self):
        patch = scenes.add_patch()
        for operator in (bpy.ops.uv.abf_set_density, bpy.ops.uv.abf_show_density, bpy.ops.uv.abf_select_faults):
            self.assert_fails(operator, "patch has no UV layer", patch)
        patch.data.uv_layers.new()
        patch.data.uv_layers.active.data.foreach_set("uv", np.zeros(320, np.float32))
        self.assert_fails(bpy.ops.uv.abf_set_density, "an island has no area", patch)


class Faults(InBlender):
    def patch(self):
        """The first face is mirrored, the last one lies inside the one before, and face 20 is large."""
        patch = scenes.add_patch(height=0, is_planar=True)
        uv = uv_of(patch)
        uv[:4] = uv[[1, 0, 3, 2]] - 20
        uv[-4:] = uv[-8:-4].mean(axis=0) + (uv[-4:] - uv[-4:].mean(axis=0)) / 2
        uv[80:84] = uv[80:84] * 3 + 50
        patch.data.uv_layers.active.data.foreach_set("uv", uv.ravel())
        select_faces(patch, np.ones(40))
        return patch

    def test_each_fault(self):
        for what, expected in (
            ({"FLIPPED"}, [0]),
            ({"OVERLAPPING"}, [38, 39]),
            ({"STRETCHED"}, [20, 39]),
            ({"OVERLAPPING", "FLIPPED"}, [0, 38, 39]),
        ):
            for mode in (edit, leave):
                with self.subTest(what=what, mode=mode.__name__):
                    scenes.clear()
                    patch = self.patch()
                    before = uv_of(patch)
                    mode()
                    bpy.ops.uv.abf_select_faults(what=what, largest=2)
                    leave()
                    self.assertEqual(selected_faces(patch).tolist(), expected)
                    self.assertTrue(np.array_equal(uv_of(patch), before))

    def test_in_the_uv_editor(self):
        patch = self.patch()
        tool_settings = bpy.context.scene.tool_settings
        self.addCleanup(setattr, tool_settings, "use_uv_select_sync", tool_settings.use_uv_select_sync)
        tool_settings.use_uv_select_sync = False
        edit()
        with scenes.uv_editor():
            bpy.ops.uv.select_all(action="SELECT")
            bpy.ops.uv.abf_select_faults()
            leave()
            self.assertEqual(len(selected_faces(patch)), 40)
            self.assertEqual(scenes.uv_selected_faces(patch).tolist(), [0, 38, 39])


class BadInput(InBlender):
    def test_broken_faces_are_selected(self):
        patch = scenes.add_patch(is_planar=True)
        patch.data.vertices[0].co.z = float("nan")
        self.assert_fails(bpy.ops.uv.abf_pack, "patch: vertex 0 .*not finite", patch)
        self.assertEqual(selected_faces(patch).tolist(), [0])
        patch.data.vertices[0].co.z = 0
        patch.data.uv_layers.active.data[-1].uv.x = float("nan")
        patch.data.update()
        for name in ("abf_pack", "abf_unfold", "abf_set_density", "abf_select_faults"):
            self.assert_fails(getattr(bpy.ops.uv, name), "patch: face 39 .*not finite", patch)
            self.assertEqual(selected_faces(patch).tolist(), [39])

    def test_faces_that_are_oriented_differently(self):
        faces = scenes.grid_faces(8, 5)
        faces[20].reverse()
        points = [(x, y, 0) for y in range(6) for x in range(9)]
        patch = scenes.add("patch", points, faces, uv=[points[v][:2] for face in faces for v in face])
        self.assert_fails(bpy.ops.uv.abf_select_faults, "patch: faces .* are oriented differently", patch)
        self.assertIn(20, selected_faces(patch))

    def test_a_seam_at_a_broken_face(self):
        """The second face has no area."""
        vertices = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (5, 5, 5), (6, 5, 5), (7, 5, 5)]
        found = scenes.add("bad", vertices, [[0, 1, 2, 3], [4, 5, 6]], seams=[(4, 5)])
        self.assert_fails(bpy.ops.uv.abf_unwrap, "bad: the seam between vertices 4 and 5 is at broken faces", found)
        self.assertEqual(selected_faces(found).tolist(), [1])

    def test_flags_that_are_stored_once(self):
        """Blender 5.0 keeps a flag that all edges of a new mesh have as one value."""
        mesh = bpy.data.meshes.new("new")
        mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, float("nan"), 0)], [], [(0, 1, 2)])
        found = bpy.data.objects.new("new", mesh)
        bpy.context.scene.collection.objects.link(found)
        found.select_set(True)
        self.assert_fails(bpy.ops.uv.abf_unwrap, "new: vertex 2", found)
        self.assertTrue(scenes.read(found, "edges", "select", bool).all())

    def test_broken_meshes(self):
        patch = scenes.add_patch(is_planar=True)
        patch.data.vertices[7].co.z = float("nan")
        for name in ("abf_unwrap", "abf_auto_seams", "abf_unfold", "abf_pack", "abf_straighten", "abf_show_stretch"):
            self.assert_fails(getattr(bpy.ops.uv, name), "patch: vertex 7 .*not finite", patch)

    def test_dirty_meshes(self):
        """Operators end, in the mode in which they began. What they refuse stays as it is, with a reason."""
        operators = [name for name in dir(bpy.ops.uv) if name.startswith("abf_")]
        self.assertEqual(len(operators), 9)
        refused = 0
        for seed in range(90):
            with self.subTest(seed=seed):
                random = np.random.default_rng(seed)
                scenes.clear()
                objects = [scenes.add_dirty(random, f"dirty {k}") for k in range(random.integers(1, 4))]
                bpy.context.view_layer.update()
                before = coordinates_of(objects)
                if random.random() < 0.5:
                    edit()
                mode = bpy.context.mode
                try:
                    with scenes.uv_editor() if seed % 2 else contextlib.nullcontext():
                        getattr(bpy.ops.uv, operators[seed % 9])()
                except RuntimeError as error:
                    refused += 1
                    self.assertNotIn("Traceback", str(error))
                    self.assertIn("dirty", str(error).replace("No face", "dirty"))
                    self.assertEqual(coordinates_of(objects), before)
                self.assertEqual(bpy.context.mode, mode)
        self.assertTrue(20 < refused < 70, refused)

    def test_no_faces(self):
        self.assert_fails(bpy.ops.uv.abf_unwrap, "points has no faces", scenes.add("points", [(0, 0, 0)], []))

    def test_no_area(self):
        found = scenes.add("flat", [(0, 0, 0), (1, 0, 0), (2, 0, 0)], [[0, 1, 2]], uv=np.zeros((3, 2)))
        for name in ("abf_unwrap", "abf_auto_seams", "abf_unfold", "abf_pack", "abf_straighten"):
            self.assert_fails(getattr(bpy.ops.uv, name), ".", found)

    def test_bad_options(self):
        patch = scenes.add_patch(is_planar=True)
        self.assert_fails(bpy.ops.uv.abf_auto_seams, "stretch", patch, stretch_bound=0.5)
        self.assert_fails(bpy.ops.uv.abf_pack, ".", patch, resolution=8, gutter=256)


if __name__ == "__main__":
    abf = install()
    result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.stdout.flush()
    os._exit(not result.wasSuccessful())  # Blender would return 0
