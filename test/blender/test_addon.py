# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""The add-on, in Blender's background mode, with one of its engines: FLIP_FREE_MAPS_ENGINE is MODULE or PROGRAM.

usage: blender -b --factory-startup --python-exit-code 1 -P test_addon.py
"""

import os
import sys
import time
import types

import bmesh
import bpy
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ENGINE = os.environ["FLIP_FREE_MAPS_ENGINE"]
sys.path.insert(0, os.environ.get("FLIP_FREE_MAPS_MODULE", ""))
bpy.ops.preferences.addon_install(filepath=os.path.join(HERE, "..", "..", "examples", "blender", "uv_flip_free_maps.py"))
bpy.ops.preferences.addon_enable(module="uv_flip_free_maps")
import uv_flip_free_maps as addon  # noqa: E402

PREFERENCES = bpy.context.preferences.addons["uv_flip_free_maps"].preferences
PREFERENCES.engine = ENGINE
PREFERENCES.program = os.environ.get("FLIP_FREE_MAPS_PROGRAM", "")


# ---------------------------------------------------------------------------------------------------------------------
# Meshes and what is true of them


def fresh(make, *arguments, **options):
    """An object of a primitive, alone in the scene, in Edit Mode with all faces selected."""
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    make(*arguments, **options)
    edit()
    return bpy.context.active_object


def edit():
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="SELECT")


class Layout:
    """The UV map of an object as it is."""

    def __init__(self, item):
        if item.mode == "EDIT":
            item.update_from_editmode()
        mesh = item.data.copy()
        layer = mesh.uv_layers.active
        self.uv = np.float64(addon.read(layer.data, "uv", np.float32, 2))
        self.vertex = addon.read(mesh.loops, "vertex_index", np.int32)
        self.edge = addon.read(mesh.loops, "edge_index", np.int32)
        self.start = addon.read(mesh.polygons, "loop_start", np.int32)
        self.size = addon.read(mesh.polygons, "loop_total", np.int32)
        self.is_seam = addon.read(mesh.edges, "use_seam", bool)
        mesh.calc_loop_triangles()
        self.triangles = addon.read(mesh.loop_triangles, "loops", np.int32, 3)
        self.polygon = addon.read(mesh.loop_triangles, "polygon_index", np.int32)
        bpy.data.meshes.remove(mesh)

    def flips(self):
        """Polygons that are not laid out counterclockwise: Blender's triangles of them are not, and if they have four corners, those
        along one of the diagonals are not either. (Which diagonal suits the image is nothing that Blender asks for.)"""
        wrong = set(self.polygon[addon.twice_areas(self.triangles, self.uv) <= 0].tolist())
        return sum(not self.size[i] == 4 or not self.is_positive_quad(self.uv[self.start[i]:self.start[i] + 4]) for i in wrong)

    @staticmethod
    def is_positive_quad(uv):
        return any(min(np.cross(uv[b] - uv[a], uv[c] - uv[a]) for a, b, c in halves) > 0
                   for halves in (((0, 1, 2), (0, 2, 3)), ((0, 1, 3), (1, 2, 3))))

    def split_edges(self):
        """Edges between two faces that are at two places."""
        following = np.arange(len(self.vertex)) + 1
        following[self.start + self.size - 1] = self.start
        places = {}
        for loop, edge in enumerate(self.edge):
            ends = {int(self.vertex[k]): tuple(self.uv[k]) for k in (loop, following[loop])}
            places.setdefault(int(edge), []).append(ends)
        return {edge for edge, sides in places.items()
                if any(abs(np.subtract(sides[0][v], side[v])).max() > 1e-5 for side in sides[1:] for v in side)}


def overlaps(*layouts):
    """Pairs of triangles whose interiors meet: they are apart when a line along one of their sides parts them."""
    corners = np.concatenate([layout.uv[layout.triangles] for layout in layouts])
    n = len(corners)
    low, high = corners.min(axis=1), corners.max(axis=1)
    near = (low[:, None] < high[None]).all(axis=2) & (low[None] < high[:, None]).all(axis=2)
    i, j = np.nonzero(np.triu(near, 1))
    is_apart = np.zeros(len(i), bool)
    for a, b in ((i, j), (j, i)):
        for k in range(3):
            p, q = corners[a, k], corners[a, (k + 1) % 3]
            side = q - p
            normal = np.stack([side[:, 1], -side[:, 0]], axis=1)
            is_apart |= (np.einsum("ij,ikj->ik", normal, corners[b] - p[:, None]) >= -1e-12).all(axis=1)
    return int((~is_apart).sum()), n


def check_atlas(item, *more):
    layouts = [Layout(item), *map(Layout, more)]
    for layout in layouts:
        assert layout.flips() == 0, f"{layout.flips()} flips"
        assert layout.uv.min() >= 0 and layout.uv.max() <= 1
    assert overlaps(*layouts)[0] == 0
    return layouts[0]


def edited(item):
    mesh = bmesh.from_edit_mesh(item.data)
    mesh.faces.ensure_lookup_table()
    mesh.edges.ensure_lookup_table()
    mesh.verts.ensure_lookup_table()
    return mesh, mesh.loops.layers.uv.verify()


def islands(item):
    faces = addon.Faces(bpy.context, False)
    return len(np.unique(faces.island_of))


# ---------------------------------------------------------------------------------------------------------------------
# Tests


PRIMITIVES = (
    (bpy.ops.mesh.primitive_monkey_add, {}),
    (bpy.ops.mesh.primitive_cube_add, {}),
    (bpy.ops.mesh.primitive_ico_sphere_add, {"subdivisions": 3}),
    (bpy.ops.mesh.primitive_torus_add, {"major_segments": 24, "minor_segments": 8}),
    (bpy.ops.mesh.primitive_cylinder_add, {"vertices": 20}),
)


def test_unwrap_primitives():
    for make, options in PRIMITIVES:
        item = fresh(make, **options)
        assert bpy.ops.uv.flip_free_unwrap() == {"FINISHED"}
        layout = check_atlas(item)
        area = addon.twice_areas(layout.triangles, layout.uv).sum() / 2
        print(f"  {item.name}: {len(layout.size)} faces, {islands(item)} islands, {100 * area:.0f} % of the square")
        assert 0.2 < area < 1


def test_subdivided_and_without_uv():
    item = fresh(bpy.ops.mesh.primitive_monkey_add)
    bpy.ops.mesh.subdivide(number_cuts=1, smoothness=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    item.data.uv_layers.remove(item.data.uv_layers[0])
    # In Object Mode all of the mesh is taken; the new layer is the mesh's only one.
    assert bpy.ops.uv.flip_free_unwrap("INVOKE_DEFAULT", quality="DRAFT", margin=2, resolution=2048) == {"FINISHED"}
    assert len(item.data.uv_layers) == 1
    layout = Layout(item)
    assert layout.flips() == 0 and 0 <= layout.uv.min() and layout.uv.max() <= 1


def test_seams():
    item = fresh(bpy.ops.mesh.primitive_cube_add)
    bpy.ops.mesh.mark_seam()
    bpy.ops.uv.flip_free_unwrap(cuts="SEAMS")
    assert len(check_atlas(item).split_edges()) == 12 and islands(item) == 6
    # A meridian opens a ball, and no other edge is cut.
    item = fresh(bpy.ops.mesh.primitive_uv_sphere_add, segments=16, ring_count=8)
    mesh, _ = edited(item)
    for edge in mesh.edges:
        edge.seam = all(abs(v.co.y) < 1e-5 and v.co.x > -1e-5 for v in edge.verts)
    bmesh.update_edit_mesh(item.data)
    bpy.ops.uv.flip_free_unwrap(cuts="SEAMS")
    layout = check_atlas(item)
    assert layout.split_edges() <= set(np.flatnonzero(layout.is_seam).tolist())
    assert len(layout.split_edges()) >= 7 and islands(item) == 1
    # The bound asks for more.
    bpy.ops.uv.flip_free_unwrap(cuts="AUTO", max_distortion=1.05)
    assert islands(item) > 1


def test_existing_islands():
    item = fresh(bpy.ops.mesh.primitive_torus_add, major_segments=24, minor_segments=8)
    bpy.ops.uv.flip_free_unwrap()
    before = Layout(item)
    assert bpy.ops.uv.flip_free_unwrap(cuts="SEAMS", keep_islands=True) == {"FINISHED"}
    after = check_atlas(item)
    assert after.split_edges() == before.split_edges()


def test_selected_faces():
    item = fresh(bpy.ops.mesh.primitive_monkey_add)
    before = Layout(item)
    mesh, _ = edited(item)
    for face in mesh.faces:
        face.select = face.index % 7 < 3
    bmesh.update_edit_mesh(item.data)
    bpy.ops.uv.flip_free_unwrap()
    after = Layout(item)
    is_chosen = np.repeat(np.arange(len(after.size)) % 7 < 3, after.size)
    assert (after.uv[~is_chosen] == before.uv[~is_chosen]).all()
    assert (after.uv[is_chosen] != before.uv[is_chosen]).any(axis=1).mean() > 0.9
    bpy.ops.uv.flip_free_unwrap(faces="ALL")
    check_atlas(item)


def pinned_grid(shift):
    """A hilly grid with a UV layer, three of whose corners are pinned, the last after it was moved."""
    item = fresh(bpy.ops.mesh.primitive_grid_add, x_subdivisions=10, y_subdivisions=10, size=2)
    mesh, layer = edited(item)
    for v in mesh.verts:
        v.co.z = 0.4 * np.sin(3 * v.co.x) * np.cos(2 * v.co.y)
    for face in mesh.faces:
        for loop in face.loops:
            x, y = loop.vert.co.x, loop.vert.co.y
            loop[layer].uv = (0.4 + 0.3 * x, 0.4 + 0.3 * y)
            if abs(abs(x) - 1) < 1e-5 and abs(abs(y) - 1) < 1e-5 and x + y > -1.5:
                if x + y > 1.5:
                    loop[layer].uv = (0.7 + shift, 0.7 + shift)
                loop[layer].pin_uv = True
    bmesh.update_edit_mesh(item.data)
    return item


def test_pins():
    for shift in (0.0, 0.05, -0.35):
        item = pinned_grid(shift)
        before = Layout(item)
        assert (before.flips() > 0) == (shift == -0.35)
        faces = addon.Faces(bpy.context, False)
        assert faces.is_pinned.sum() == 3
        assert bpy.ops.uv.flip_free_unwrap() == {"FINISHED"}
        after = Layout(item)
        assert (after.uv[faces.is_pinned] == before.uv[faces.is_pinned]).all(), shift
        assert after.flips() == 0 and not after.split_edges()
        assert (after.uv != before.uv).any()


def test_repair():
    item = pinned_grid(-0.6)
    assert Layout(item).flips() > 0
    assert bpy.ops.uv.flip_free_repair() == {"FINISHED"}
    repaired = Layout(item)
    assert repaired.flips() == 0 and not repaired.split_edges()
    # Nothing is left to do, and nothing is done.
    bpy.ops.uv.flip_free_repair()
    assert (Layout(item).uv == repaired.uv).all()


def test_pack():
    item = fresh(bpy.ops.mesh.primitive_cube_add)
    # All faces lie upon each other, one of them mirrored.
    mesh, layer = edited(item)
    for face in mesh.faces:
        for loop, image in zip(face.loops, ((0, 0), (1, 0), (1, 1), (0, 1))):
            loop[layer].uv = (1 - image[0], image[1]) if face.index == 0 else image
    bmesh.update_edit_mesh(item.data)
    assert bpy.ops.uv.flip_free_pack(margin=8) == {"FINISHED"}
    layout = Layout(item)
    assert overlaps(layout)[0] == 0 and layout.uv.min() >= 0 and layout.uv.max() <= 1
    assert layout.flips() == 1
    areas = np.abs(addon.twice_areas(layout.triangles, layout.uv))
    assert areas.max() < 1.0001 * areas.min()


def test_islands_with_pins_stay():
    item = fresh(bpy.ops.mesh.primitive_cube_add)
    mesh, layer = edited(item)
    for face in mesh.faces:
        for loop, image in zip(face.loops, ((0, 0), (1, 0), (1, 1), (0, 1))):
            # The last face lies in the middle, the others upon each other.
            is_last = face.index == 5
            loop[layer].uv = (0.4 + 0.3 * image[0], 0.35 + 0.3 * image[1]) if is_last else image
            loop[layer].pin_uv = is_last and image == (0, 0)
    bmesh.update_edit_mesh(item.data)
    before = Layout(item)
    is_pinned = np.repeat(np.arange(6) == 5, 4)
    assert bpy.ops.uv.flip_free_pack(margin=8) == {"FINISHED"}
    packed = check_atlas(item)
    assert (packed.uv[is_pinned] == before.uv[is_pinned]).all() and (packed.uv[~is_pinned] != before.uv[~is_pinned]).any()
    # Its map has the least distortion already, up to the direction of its pin.
    assert bpy.ops.uv.flip_free_unwrap(keep_islands=True) == {"FINISHED"}
    again = check_atlas(item)
    pin = np.flatnonzero(is_pinned)[0]
    assert (again.uv[pin] == before.uv[pin]).all()


def test_several_objects():
    first = fresh(bpy.ops.mesh.primitive_cube_add)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=2, location=(3, 0, 0))
    second = bpy.context.active_object
    # A mirrored object, of another scale.
    second.scale = (-2, 2, 2)
    first.select_set(True)
    bpy.context.view_layer.update()
    edit()
    assert bpy.ops.uv.flip_free_unwrap() == {"FINISHED"}
    check_atlas(first, second)
    lengths = [np.sqrt(addon.twice_areas(layout.triangles, layout.uv).sum()) for layout in map(Layout, (first, second))]
    # A cube of area 24, and a ball of radius 2.
    assert abs(lengths[1] / lengths[0] - np.sqrt(4 * np.pi * 4 / 24)) < 0.1


def test_undo():
    item = fresh(bpy.ops.mesh.primitive_cube_add)
    before = Layout(item)
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.uv.flip_free_unwrap()
    assert (Layout(item).uv != before.uv).any()
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    assert (Layout(bpy.context.active_object).uv == before.uv).all()


class FakeOperator(addon.Task, addon.Packed):
    """What Blender makes of the operator, with a window that is none."""

    bl_label = "Unwrap"
    faces, cuts, keep_islands, max_distortion, pack, quality, time_limit = "SELECTED", "AUTO", False, 1.01, True, "HIGH", 0
    margin, resolution, rotate = 4, 1024, True
    work = addon.UV_OT_flip_free_unwrap.work

    def __init__(self):
        self.said = []

    def report(self, kinds, text):
        self.said.append((kinds, text))


def modal_run(event_of):
    """Runs the operator as Blender does with a window; `event_of(step)` is what happens in each step."""
    operator = FakeOperator()
    log = types.SimpleNamespace(status=[], progress=[], ended=0)
    manager = types.SimpleNamespace(
        event_timer_add=lambda seconds, window: "timer", modal_handler_add=lambda operator: None, progress_begin=lambda a, b: None,
        progress_update=log.progress.append, event_timer_remove=lambda timer: setattr(log, "ended", log.ended + 1),
        progress_end=lambda: None)
    context = types.SimpleNamespace(
        mode=bpy.context.mode, objects_in_mode_unique_data=bpy.context.objects_in_mode_unique_data, window=None,
        preferences=bpy.context.preferences, window_manager=manager,
        workspace=types.SimpleNamespace(status_text_set=log.status.append))
    assert operator._begin(context, in_thread=True)
    operator._timer = "timer"
    for step in range(6000):
        answer = operator.modal(context, types.SimpleNamespace(type=event_of(step), value="PRESS"))
        if answer != {"RUNNING_MODAL"}:
            break
        time.sleep(0.01)
    assert log.ended == 1 and log.status[-1] is None
    return answer, operator, log


def test_modal():
    item = fresh(bpy.ops.mesh.primitive_monkey_add)
    bpy.ops.mesh.subdivide(number_cuts=2)
    answer, operator, log = modal_run(lambda step: "TIMER")
    assert answer == {"FINISHED"}, operator.said
    assert operator.said[-1][0] == {"INFO"} and "charts" in operator.said[-1][1]
    assert any("%" in text for text in log.status if text) and sorted(log.progress) == log.progress
    assert Layout(item).flips() == 0
    # Esc ends with what there is: a map without flips, or no change when there is none yet.
    before = Layout(item)
    answer, operator, log = modal_run(lambda step: "ESC" if step == 0 else "TIMER")
    after = Layout(item)
    if answer == {"FINISHED"}:
        assert "ended early" in operator.said[-1][1], operator.said
        assert after.flips() == 0
    else:
        assert ENGINE == "PROGRAM" and operator.said[-1][0] == {"WARNING"}, operator.said
        assert (after.uv == before.uv).all()


def test_refusals():
    def message(call):
        try:
            call()
        except RuntimeError as error:
            return str(error)
        raise AssertionError("nothing was refused")

    item = fresh(bpy.ops.mesh.primitive_cube_add)
    before = Layout(item)
    bpy.ops.mesh.select_all(action="DESELECT")
    assert "no face is selected" in message(bpy.ops.uv.flip_free_unwrap)
    bpy.ops.mesh.select_all(action="SELECT")
    mesh, _ = edited(item)
    mesh.verts[0].co.x = float("nan")
    assert "finite" in message(bpy.ops.uv.flip_free_unwrap)
    assert (Layout(item).uv == before.uv).all()
    fresh(bpy.ops.mesh.primitive_cube_add)
    PREFERENCES.engine, PREFERENCES.program = "PROGRAM", "/nowhere/flip_free_maps"
    try:
        assert "/nowhere/flip_free_maps is no program" in message(bpy.ops.uv.flip_free_unwrap)
    finally:
        PREFERENCES.engine, PREFERENCES.program = ENGINE, os.environ.get("FLIP_FREE_MAPS_PROGRAM", "")


def main():
    tests = [(name, test) for name, test in globals().items() if name.startswith("test_")]
    wanted = os.environ.get("FLIP_FREE_MAPS_TESTS", "")
    for name, test in tests:
        if wanted in name:
            begin = time.time()
            test()
            print(f"{name}: {time.time() - begin:.1f} s", flush=True)
    bpy.ops.preferences.addon_disable(module="uv_flip_free_maps")
    print("all tests passed")


main()
