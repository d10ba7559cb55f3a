# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""UV maps without flips in Blender 3.4 and later: Edit > Preferences > Add-ons > Install, then menu UV.

The work is done by the Python module flip_free_maps where Blender's Python can import it, and by the program of that name
otherwise, whose path is in the add-on's preferences, or which is found on the PATH.
"""

bl_info = {
    "name": "UV Maps without Flips",
    "author": "The Flip_free_maps authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "UV menu of the 3D View in Edit Mode, UV menu of the UV Editor",
    "description": "Unwraps with bounded distortion, no flipped face and no overlap; repairs and packs UV maps",
    "category": "UV",
}

import contextlib
import json
import math
import os
import shutil
import subprocess
import tempfile
import threading

import bmesh
import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

# Corners whose UVs are nearer than this are joined, in parts of the texture's side.
SAME = 1e-5


class Refused(Exception):
    """What has no result, with a sentence for the user."""


class Watch:
    """How far the work is, which is told in one thread and read, or ended, in another."""

    def __init__(self):
        self.share = 0.0
        self.text = ""
        self.is_cancelled = False
        self.process = None

    def tell(self, share, text):
        """False once the work is to end with what there is."""
        self.share = max(self.share, min(share, 1.0))
        self.text = text
        return not self.is_cancelled

    def cancel(self):
        self.is_cancelled = True
        process = self.process
        if process is not None:
            process.terminate()


# ---------------------------------------------------------------------------------------------------------------------
# Who does the work. Engines take numpy arrays; UVs of single patches are in the units of the points.


class ModuleEngine:
    def __init__(self):
        import flip_free_maps

        self.module = flip_free_maps

    @contextlib.contextmanager
    def _errors(self):
        try:
            yield
        except self.module.Error as error:
            raise Refused(error.message) from error

    def unwrap(self, points, values, offsets, seams, pinned, uv, options, watch):
        """An image for each corner of polygons, and a sentence. Those of pinned polygons are given and stay."""

        def progress(report):
            share = {"cut": 0.0, "flatten": 0.1 + 0.8 * report.faces_done / max(1, report.faces), "pack": 0.9}[report.phase]
            return watch.tell(share, f"{report.charts_done} of {report.charts} charts")

        with self._errors():
            atlas = self.module.unwrap(points, (values, offsets), seams=seams, progress=progress, dtype=np.float32,
                                       max_distortion=options["max_distortion"], pack=options["pack"], rotate=options["rotate"],
                                       resolution=options["resolution"], padding=options["padding"],
                                       branches=options["branches"], tolerance=options["tolerance"],
                                       time_limit=options["time_limit"], pinned=pinned, uv=uv)
        return np.float64(atlas.corners), _sentence(len(atlas.summary.charts), atlas.summary.to_dict(), options["pack"])

    def flatten(self, points, triangles, start, fixed, soft, tolerance, watch):
        """A map of a patch, from a start without flips if there is one."""

        def progress(report):
            return watch.tell(0, f"iteration {report.iteration}, energy {report.energy:.4f}")

        with self._errors():
            return self.module.parameterize(points, triangles, start="auto" if start is None else start, fixed=fixed, soft=soft,
                                            tolerance=tolerance, progress=progress).uv

    def repair(self, points, triangles, uv, fix_border, watch):
        def progress(report):
            return watch.tell(0, f"iteration {report.iteration}, {report.flips} flips")

        with self._errors():
            return self.module.repair(points, triangles, uv, fix_border=fix_border, progress=progress).uv

    def pack(self, triangles, uv, pinned, options, watch):
        with self._errors():
            result = self.module.pack(triangles, uv, pinned=pinned, rotate=options["rotate"], resolution=options["resolution"],
                                      padding=options["padding"])
        return np.float64(result.uv), _sentence(result.summary.charts, result.summary.to_dict(), True)


class ProgramEngine:
    def __init__(self, program):
        self.program = program

    def _run(self, command, polygons, arguments, watch, reports=True):
        """Runs the program on a polygon mesh (points, values, offsets), perhaps with images and those of corners if their numbers
        are not those of points; returns the images of the corners and the summary."""
        with tempfile.TemporaryDirectory(prefix="flip_free_maps_") as folder:
            path = {name: os.path.join(folder, name) for name in ("in.obj", "out.obj", "out.json")}
            _write_obj(path["in.obj"], *polygons)
            line = [self.program, command, path["in.obj"], "-o", path["out.obj"], "--json", path["out.json"], "--quiet"]
            for name, value in arguments.items():
                if isinstance(value, np.ndarray):
                    file = os.path.join(folder, name.strip("-"))
                    np.savetxt(file, value, fmt="%d" if value.dtype.kind in "iu" else "%.17g")
                    value = file
                elif isinstance(value, tuple):
                    file = os.path.join(folder, name.strip("-") + ".obj")
                    _write_obj(file, *value)
                    value = file
                line += [name] if value is True else [] if value in (None, False) else [name, str(value)]
            message = self._follow(line + (["--progress", "json"] if reports else []), watch)
            if message is not None:
                raise Refused(message)
            with open(path["out.json"], encoding="utf-8") as file:
                summary = json.load(file)
            return _read_images(path["out.obj"], len(polygons[1])), summary

    def _follow(self, line, watch):
        """None when the program ended well, and what it said otherwise."""
        said = ended = None
        try:
            process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, encoding="utf-8",
                                       errors="replace")
        except OSError as error:
            return f"{self.program}: {error.strerror}"
        with process:
            watch.process = process
            if watch.is_cancelled:
                process.terminate()
            for text in process.stderr:
                report = _json_of(text)
                if report is None:
                    said = text.strip() or said
                elif report["phase"] == "end":
                    ended = report["message"]
                else:
                    done = f"{report['charts_done']} of {report['charts']} charts" if "charts" in report else \
                        f"iteration {report['iteration']}"
                    watch.tell(report["share"], done)
        watch.process = None
        if process.returncode == 0:
            return None
        if watch.is_cancelled:
            return "cancelled; there was no map yet"
        return ended or said or f"{self.program} ended with the code {process.returncode}"

    def unwrap(self, points, values, offsets, seams, pinned, uv, options, watch):
        arguments = {"--margin": options["padding"] / options["resolution"], "--no-rotation": not options["rotate"],
                     "--no-pack": not options["pack"], "--max-distortion": options["max_distortion"],
                     "--branches": options["branches"], "--tolerance": options["tolerance"],
                     "--time-limit": options["time_limit"], "--seams": seams if len(seams) else None,
                     "--pinned": np.flatnonzero(pinned) if pinned.any() else None}
        polygons = (points, values, offsets) + ((uv, np.arange(len(uv))) if pinned.any() else ())
        uv, summary = self._run("unwrap", polygons, arguments, watch)
        return uv, _sentence(len(summary["charts"]), summary, options["pack"])

    def flatten(self, points, triangles, start, fixed, soft, tolerance, watch):
        values, offsets = triangles.ravel(), 3 * np.arange(len(triangles) + 1)
        arguments = {"--tolerance": tolerance}
        if start is not None:
            arguments["--start"] = (points, values, offsets, start)
        if fixed is not None:
            arguments["--fixed"] = fixed
        if soft is not None:
            arguments["--soft"] = np.column_stack([soft[0], soft[1], np.broadcast_to(soft[2], len(soft[0]))])
        uv, _ = self._run("parameterize", (points, values, offsets), arguments, watch)
        return _by_vertex(uv, values, len(points))

    def repair(self, points, triangles, uv, fix_border, watch):
        values, offsets = triangles.ravel(), 3 * np.arange(len(triangles) + 1)
        uv, _ = self._run("repair", (points, values, offsets, uv), {"--fix-border": fix_border}, watch)
        return _by_vertex(uv, values, len(points))

    def pack(self, triangles, uv, pinned, options, watch):
        values, offsets = triangles.ravel(), 3 * np.arange(len(triangles) + 1)
        # To the program vertices at the same place are one: islands lie in planes of their own.
        points = np.column_stack([uv, components(len(uv), triangles[:, [0, 1]].ravel(), triangles[:, [1, 2]].ravel())])
        arguments = {"--margin": options["padding"] / options["resolution"], "--no-rotation": not options["rotate"],
                     "--pinned": np.flatnonzero(pinned) if pinned.any() else None}
        uv, summary = self._run("pack", (points, values, offsets, uv), arguments, watch, reports=False)
        return _by_vertex(uv, values, len(points)), _sentence(summary["charts"], summary, True)


def _sentence(charts, summary, is_packed):
    text = f"{charts} charts" if charts != 1 else "1 chart"
    if is_packed:
        text += f", {100 * summary['occupancy']:.0f} % of the square"
    if "energy" in summary:
        text += f", distortion {summary['energy']:.4f}"
    return text


def _json_of(text):
    try:
        report = json.loads(text)
    except ValueError:
        return None
    return report if isinstance(report, dict) and "phase" in report else None


def _write_obj(path, points, values, offsets, uv=None, uv_values=None):
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in points.tolist())
        if uv is not None:
            file.writelines("vt %.17g %.17g\n" % tuple(p) for p in uv.tolist())
        numbers = (values + 1).tolist()
        corners = [str(v) for v in numbers]
        if uv is not None:
            corners = [f"{v}/{t}" for v, t in zip(numbers, numbers if uv_values is None else (uv_values + 1).tolist())]
        ends = offsets.tolist()
        file.writelines("f " + " ".join(corners[first:last]) + "\n" for first, last in zip(ends[:-1], ends[1:]))


def _read_images(path, number_of_corners):
    images, corners = [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "vt":
                images.append((float(words[1]), float(words[2])))
            elif words and words[0] == "f":
                corners += [int(word.split("/")[1]) - 1 for word in words[1:]]
    if len(corners) != number_of_corners:
        raise Refused("the program wrote other faces than it was given")
    return np.array(images)[corners]


def _by_vertex(corner_uv, values, number_of_vertices):
    uv = np.zeros((number_of_vertices, 2))
    uv[values] = corner_uv
    return uv


def find_engine(context):
    """The engine that the preferences ask for."""
    addon = context.preferences.addons.get(__name__)
    wish = addon.preferences.engine if addon else "AUTO"
    if wish != "PROGRAM":
        try:
            return ModuleEngine()
        except ImportError as error:
            if wish == "MODULE":
                raise Refused(f"Blender's Python cannot import the module flip_free_maps: {error}") from error
    path = bpy.path.abspath(addon.preferences.program) if addon and addon.preferences.program else shutil.which("flip_free_maps")
    if not path:
        raise Refused("neither the module flip_free_maps nor the program was found; see the add-on's preferences")
    if not (os.path.isfile(path) and os.access(path, os.X_OK)):
        raise Refused(f"{path} is no program")
    return ProgramEngine(path)


# ---------------------------------------------------------------------------------------------------------------------
# Meshes as arrays


def components(size, a, b):
    """The numbers of connected components of a graph with edges from a to b, as the least number of a node in each."""
    label = np.arange(size)
    while True:
        low = np.minimum(label[a], label[b])
        new = label.copy()
        np.minimum.at(new, label[a], low)
        np.minimum.at(new, label[b], low)
        while (new[new] != new).any():
            new = new[new]
        if (new == label).all():
            return label
        label = new


@contextlib.contextmanager
def readable_mesh(item):
    """The mesh of an object, which can be read in Edit Mode, too."""
    if item.mode != "EDIT":
        yield item.data
        return
    item.update_from_editmode()
    copy = item.data.copy()
    try:
        yield copy
    finally:
        bpy.data.meshes.remove(copy)


def read(collection, name, dtype, columns=1):
    array = np.empty(len(collection) * columns, dtype)
    collection.foreach_get(name, array)
    return array if columns == 1 else array.reshape(-1, columns)


class Faces:
    """Faces of all meshes that are edited, or selected in Object Mode, as arrays. Corners are numbered one after the other."""

    def __init__(self, context, only_selected):
        self.parts = []
        arrays = {name: [] for name in ("points", "values", "sizes", "uv", "is_pinned", "edges", "is_seam", "triangles", "is_chosen")}
        points = corners = edges = 0
        for item in self._objects(context):
            with readable_mesh(item) as mesh:
                if len(mesh.polygons) == 0:
                    continue
                self.parts.append((item, slice(corners, corners + len(mesh.loops)), len(mesh.polygons)))
                arrays["points"].append(self._points(item, mesh))
                arrays["values"].append(read(mesh.loops, "vertex_index", np.int32) + np.int64(points))
                arrays["sizes"].append(read(mesh.polygons, "loop_total", np.int32))
                arrays["edges"].append(read(mesh.loops, "edge_index", np.int32) + np.int64(edges))
                arrays["is_seam"].append(read(mesh.edges, "use_seam", bool))
                layer = mesh.uv_layers.active
                arrays["uv"].append(np.float64(read(layer.data, "uv", np.float32, 2)) if layer else np.zeros((len(mesh.loops), 2)))
                arrays["is_pinned"].append(read(layer.data, "pin_uv", bool) if layer else np.zeros(len(mesh.loops), bool))
                mesh.calc_loop_triangles()
                arrays["triangles"].append(read(mesh.loop_triangles, "loops", np.int32, 3) + np.int64(corners))
                if item.mode == "EDIT":
                    is_chosen = ~read(mesh.polygons, "hide", bool)
                    arrays["is_chosen"].append(is_chosen & read(mesh.polygons, "select", bool) if only_selected else is_chosen)
                else:
                    arrays["is_chosen"].append(np.ones(len(mesh.polygons), bool))
                points, corners, edges = points + len(mesh.vertices), corners + len(mesh.loops), edges + len(mesh.edges)
        if not self.parts:
            raise Refused("there is no mesh with faces")
        for name, blocks in arrays.items():
            setattr(self, name, np.concatenate(blocks))
        if not self.is_chosen.any():
            raise Refused("no face is selected")
        self.offsets = np.concatenate([[0], np.cumsum(self.sizes)])
        self.face_of = np.repeat(np.arange(len(self.sizes)), self.sizes)
        self._pair_edges()

    @staticmethod
    def _objects(context):
        if context.mode == "EDIT_MESH":
            return context.objects_in_mode_unique_data
        seen = {item.data.name: item for item in context.selected_objects if item.type == "MESH" and item.mode == "OBJECT"}
        return list(seen.values())

    @staticmethod
    def _points(item, mesh):
        """In the world's lengths, by a matrix that does not mirror."""
        matrix = np.array(item.matrix_world.to_3x3())
        if np.linalg.det(matrix) < 0:
            matrix = -matrix
        return np.float64(read(mesh.vertices, "co", np.float32, 3)) @ matrix.T

    def _pair_edges(self):
        """Pairs of corners from which the same edge begins, or ends, and whether UVs are the same on both sides of it."""
        following = np.arange(1, len(self.values) + 1)
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        order = np.argsort(self.edges, kind="stable")
        is_pair = self.edges[order[1:]] == self.edges[order[:-1]]
        c, d = order[:-1][is_pair], order[1:][is_pair]
        is_opposite = self.values[c] != self.values[d]
        c_end = following[c]
        at_begin, at_end = np.where(is_opposite, following[d], d), np.where(is_opposite, d, following[d])
        near = (np.abs(self.uv[c] - self.uv[at_begin]) < SAME) & (np.abs(self.uv[c_end] - self.uv[at_end]) < SAME)
        self.pairs = c, d
        self.is_marked = self.is_seam[self.edges[c]]
        self.is_joined = near.all(axis=1)
        self.pair_ends = np.stack([self.values[c], self.values[c_end]], axis=1)
        joins = self.is_joined & ~self.is_marked
        self.vertex_of = components(len(self.values), np.concatenate([c[joins], c_end[joins]]),
                                    np.concatenate([at_begin[joins], at_end[joins]]))
        self.island_of = components(len(self.sizes), self.face_of[c[joins]], self.face_of[d[joins]])

    def seams(self, is_used, keep_islands):
        """Edges between faces that are used, which are to be cut."""
        c, d = self.pairs
        is_cut = self.is_marked | (~self.is_joined if keep_islands else False)
        is_cut &= is_used[self.face_of[c]] & is_used[self.face_of[d]]
        return np.unique(np.sort(self.pair_ends[is_cut], axis=1), axis=0)

    def islands(self, is_wanted):
        """For each island with a face that is wanted, the numbers of its triangles."""
        wanted = np.unique(self.island_of[is_wanted])
        island = self.island_of[self.face_of[self.triangles[:, 0]]]
        order = np.argsort(island, kind="stable")
        first = np.searchsorted(island[order], wanted, side="left")
        last = np.searchsorted(island[order], wanted, side="right")
        return [order[a:b] for a, b in zip(first, last)]

    def patch(self, numbers):
        """(vertices, triangles, corners): the triangles of an island as indices into vertices, of which each stands for the
        corners that are one; it has the point and the UV of the corner in `vertices`."""
        vertices, triangles = np.unique(self.vertex_of[self.triangles[numbers]], return_inverse=True)
        return vertices, triangles.reshape(-1, 3)

    def spread(self, uv, vertices, images):
        """Gives all corners that are one of the vertices its image."""
        place = np.searchsorted(vertices, self.vertex_of)
        place[place == len(vertices)] = 0
        is_theirs = vertices[place] == self.vertex_of
        uv[is_theirs] = images[place[is_theirs]]

    def write(self, uv, is_written):
        """Writes the UVs of corners of faces."""
        first = 0
        for item, corners, number in self.parts:
            faces = np.flatnonzero(is_written[first:first + number])
            offsets = self.offsets[first:first + number + 1] - corners.start
            first += number
            if len(faces) == 0:
                continue
            values = uv[corners]
            if item.mode == "EDIT":
                self._write_edited(item.data, faces, offsets, values)
            else:
                mesh = item.data
                layer = mesh.uv_layers.active or mesh.uv_layers.new()
                old = read(layer.data, "uv", np.float32, 2)
                is_new = np.repeat(is_written[first - number:first], np.diff(offsets))
                old[is_new] = values[is_new]
                layer.data.foreach_set("uv", old.ravel())
                mesh.update()

    @staticmethod
    def _write_edited(mesh, faces, offsets, values):
        edited = bmesh.from_edit_mesh(mesh)
        layer = edited.loops.layers.uv.verify()
        edited.faces.ensure_lookup_table()
        for face in faces.tolist():
            images = values[offsets[face]:offsets[face + 1]].tolist()
            for loop, image in zip(edited.faces[face].loops, images):
                loop[layer].uv = image
        bmesh.update_edit_mesh(mesh, loop_triangles=False, destructive=False)


def twice_areas(triangles, uv):
    a, b, c = (uv[triangles[:, k]] for k in range(3))
    return (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])


def similarity(source, target, may_scale=True):
    """The similarity, as (factor, shift) of complex numbers, that takes points as near to others as it can."""
    s, t = source[:, 0] + 1j * source[:, 1], target[:, 0] + 1j * target[:, 1]
    s_mean, t_mean = s.mean(), t.mean()
    s, t = s - s_mean, t - t_mean
    factor = (np.conj(s) @ t) / max((np.abs(s) ** 2).sum(), 1e-300)
    if not may_scale or factor == 0:
        factor = factor / abs(factor) if factor != 0 else 1
    return factor, t_mean - factor * s_mean


def moved(uv, motion):
    z = motion[0] * (uv[:, 0] + 1j * uv[:, 1]) + motion[1]
    return np.stack([z.real, z.imag], axis=1)


def space_areas(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1)


# ---------------------------------------------------------------------------------------------------------------------
# What the operators do


def flatten_pinned(engine, points, triangles, uv, is_pinned, tolerance, watch):
    """Flattens an island anew whose pins stay where they are; returns the map and whether they do exactly.

    From a map without flips they do. Otherwise the island is flattened freely, laid upon its pins, and drawn towards them."""
    pins = np.flatnonzero(is_pinned)
    places = uv[pins]
    is_held_apart = len(np.unique(places, axis=0)) > 1
    free = engine.flatten(points, triangles, None, None, None, tolerance, watch)
    motion = similarity(free[pins], places) if is_held_apart else similarity(free, uv)
    if len(pins) == 1 or not is_held_apart:
        motion = motion[0], complex(*places[0]) - motion[0] * complex(*free[pins[0]])
    scaled = points * abs(motion[0])
    if (twice_areas(triangles, uv) > 0).all():
        return engine.flatten(scaled, triangles, uv, pins, None, tolerance, watch), True
    start = moved(free, motion)
    drawn = engine.flatten(scaled, triangles, start, None, (pins, places, 1e4), tolerance, watch)
    snapped = drawn.copy()
    snapped[pins] = places
    if not (twice_areas(triangles, snapped) > 0).all():
        return drawn, False
    return engine.flatten(scaled, triangles, snapped, pins, None, tolerance, watch), True


def unwrap(engine, faces, keep_islands, options, watch):
    """(uv, which faces have new ones, a sentence)"""
    uv = faces.uv.copy()
    c = np.flatnonzero(faces.is_pinned & faces.is_chosen[faces.face_of])
    has_pins = np.isin(faces.island_of, np.unique(faces.island_of[faces.face_of[c]]))
    notes, sentence = [], ""
    pinned = faces.islands(has_pins & faces.is_chosen)
    for numbers in pinned:
        vertices, triangles = faces.patch(numbers)
        is_pinned = np.isin(vertices, faces.vertex_of[faces.is_pinned])
        try:
            images, is_exact = flatten_pinned(engine, faces.points[faces.values[vertices]], triangles, faces.uv[vertices],
                                              is_pinned, options["tolerance"], watch)
        except Refused as refused:
            raise Refused(f"an island with pins cannot be flattened: {refused}") from refused
        faces.spread(uv, vertices, images)
        if not is_exact:
            notes.append("pins cannot be reached exactly without flips")
    is_free = faces.is_chosen & ~has_pins
    if is_free.any():
        # What has pins is where it is; all else is packed around it.
        is_laid = is_free | (has_pins & options["pack"])
        corners = is_laid[faces.face_of]
        offsets = np.concatenate([[0], np.cumsum(faces.sizes[is_laid])])
        uv[corners], sentence = engine.unwrap(faces.points, faces.values[corners], offsets, faces.seams(is_free, keep_islands),
                                              has_pins[is_laid], uv[corners], options, watch)
    if pinned:
        notes.insert(0, f"{len(pinned)} with pins")
    if watch.is_cancelled:
        notes.append("ended early")
    return uv, faces.is_chosen | has_pins, ", ".join([sentence] * bool(sentence) + notes)


def repair(engine, faces, fix_border, watch):
    uv = faces.uv.copy()
    is_written = np.zeros(len(faces.sizes), bool)
    flips = 0
    notes = []
    islands = faces.islands(faces.is_chosen)
    for k, numbers in enumerate(islands):
        areas = twice_areas(faces.triangles[numbers], faces.uv)
        if (areas > 0).all() or watch.is_cancelled:
            continue
        watch.tell(k / len(islands), f"island {k + 1} of {len(islands)}")
        vertices, triangles = faces.patch(numbers)
        points, old = faces.points[faces.values[vertices]], faces.uv[vertices]
        # The island keeps its size, and as nearly as it can its place.
        size = math.sqrt(np.abs(areas).sum() / max(space_areas(points, triangles).sum(), 1e-300)) or 1
        try:
            new = engine.repair(points * size, triangles, old, fix_border, watch)
        except Refused as refused:
            notes.append(f"an island was left as it is: {refused}")
            continue
        if not fix_border:
            new = moved(new, similarity(new, old, may_scale=False))
        faces.spread(uv, vertices, new)
        is_written[faces.face_of[faces.triangles[numbers, 0]]] = True
        flips += int((areas <= 0).sum())
    if not is_written.any() and notes:
        raise Refused(notes[0])
    if watch.is_cancelled:
        notes.append("ended early")
    found = f"{flips} flipped triangles repaired" if is_written.any() else "no face is flipped"
    return uv, is_written, "; ".join([found] + notes)


def pack(engine, faces, options, watch):
    islands = faces.islands(faces.is_chosen)
    numbers = np.concatenate(islands)
    vertices, triangles = faces.patch(numbers)
    uv = faces.uv[vertices]
    areas = twice_areas(triangles, uv)
    # Outlines are all that counts.
    triangles = np.where((areas < 0)[:, None], triangles[:, ::-1], triangles)[areas != 0]
    if len(triangles) == 0:
        raise Refused("no face has an area in the UV map")
    # Islands with a pin stay where they are.
    is_pinned = np.isin(vertices, faces.vertex_of[faces.is_pinned])
    images, sentence = engine.pack(triangles, uv, is_pinned[triangles].any(axis=1), options, watch)
    is_used = np.zeros(len(vertices), bool)
    is_used[triangles] = True
    result = faces.uv.copy()
    faces.spread(result, vertices[is_used], images[is_used])
    is_written = np.zeros(len(faces.sizes), bool)
    is_written[faces.face_of[faces.triangles[numbers, 0]]] = True
    return result, is_written, sentence


# ---------------------------------------------------------------------------------------------------------------------
# Operators


class Task:
    """An operator that works in a thread of its own while Blender shows how far it is, and at once in background mode or when it
    is repeated with other settings. Subclasses have `work(engine, faces)`, a function of a `Watch` that does not touch Blender's
    data, with the results of the functions above."""

    bl_options = {"REGISTER", "UNDO"}

    faces: EnumProperty(
        name="Faces",
        items=(("SELECTED", "Selected", "Selected faces; all in Object Mode"), ("ALL", "All", "All visible faces")),
    )

    @classmethod
    def poll(cls, context):
        return context.mode in {"EDIT_MESH", "OBJECT"} and context.active_object is not None and context.active_object.type == "MESH"

    def execute(self, context):
        return self._end(context) if self._begin(context, in_thread=False) else {"CANCELLED"}

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        if not self._begin(context, in_thread=True):
            return {"CANCELLED"}
        self._thread.join(0.2)
        if not self._thread.is_alive():
            return self._end(context)
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.window_manager.progress_begin(0, 100)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._watch.cancel()
        if event.type == "TIMER":
            if not self._thread.is_alive():
                self._leave(context)
                return self._end(context)
            watch = self._watch
            done = f"{self.bl_label}: {100 * watch.share:.0f} %, {watch.text}"
            context.workspace.status_text_set(done + ("    ending ..." if watch.is_cancelled else "    Esc: end with what there is"))
            context.window_manager.progress_update(100 * watch.share)
        return {"RUNNING_MODAL"}

    def cancel(self, context):
        """When Blender ends the operator."""
        self._watch.cancel()
        self._thread.join()
        self._leave(context)

    def _leave(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def _begin(self, context, in_thread):
        self._watch = Watch()
        self._outcome = None
        try:
            self._faces = Faces(context, self.faces == "SELECTED")
            work = self.work(find_engine(context), self._faces)
        except Refused as refused:
            self.report({"ERROR"}, str(refused))
            return False

        def run():
            try:
                self._outcome = work(self._watch)
            except Exception as error:
                self._outcome = error

        if in_thread:
            self._thread = threading.Thread(target=run, daemon=True)
            self._thread.start()
        else:
            run()
        return True

    def _end(self, context):
        if isinstance(self._outcome, Refused):
            self.report({"WARNING"} if self._watch.is_cancelled else {"ERROR"}, str(self._outcome))
            return {"CANCELLED"}
        if isinstance(self._outcome, Exception):
            raise self._outcome
        uv, is_written, sentence = self._outcome
        self._faces.write(uv, is_written)
        self.report({"INFO"}, f"{self.bl_label}: {sentence}")
        return {"FINISHED"}


class Packed:
    """The properties of operators that pack."""

    margin: IntProperty(name="Margin", description="Least distance between islands, in pixels", default=4, min=1, soft_max=64)
    resolution: IntProperty(name="Resolution", description="Side of the texture in pixels", default=1024, min=16, soft_max=16384)
    rotate: BoolProperty(name="Rotate", description="Turn islands to where they fit best, not by quarters only", default=True)

    def packing(self):
        return {"padding": self.margin, "resolution": self.resolution, "rotate": self.rotate}


class UV_OT_flip_free_unwrap(Task, Packed, bpy.types.Operator):
    """Unwrap with bounded distortion, without flipped faces and overlaps, along seams. Islands with pins are flattened as a whole,
    neither cut nor packed"""

    bl_idname = "uv.flip_free_unwrap"
    bl_label = "Unwrap without Flips"

    cuts: EnumProperty(
        name="Cuts",
        items=(
            ("AUTO", "Automatic", "Seams, and further cuts until no island is distorted more than allowed"),
            ("SEAMS", "Seams Only", "Seams, and further cuts only where faces could not be laid flat otherwise"),
        ),
    )
    keep_islands: BoolProperty(name="Keep Islands", description="Borders of the present UV islands are seams, too", default=False)
    max_distortion: FloatProperty(
        name="Distortion",
        description="Islands are cut until their mean symmetric Dirichlet energy is at most this; 1 is without distortion",
        default=1.025, min=1.0001, soft_max=2, precision=3, step=1,
    )
    pack: BoolProperty(name="Pack", description="Pack islands into the unit square; they lie side by side otherwise", default=True)
    quality: EnumProperty(
        name="Quality",
        items=(
            ("DRAFT", "Draft", "Islands are nearly as good as they can be"),
            ("NORMAL", "Normal", "Islands are as good as they can be, to the eye"),
            ("HIGH", "High", "Islands are as good as they can be, to many digits"),
        ),
        default="NORMAL",
    )
    time_limit: FloatProperty(
        name="Time Limit", description="Seconds after which nothing is improved any more; 0 is no limit", default=0, min=0, soft_max=600
    )

    def work(self, engine, faces):
        is_automatic = self.cuts == "AUTO"
        options = {
            **self.packing(),
            "pack": self.pack,
            "max_distortion": self.max_distortion if is_automatic else math.inf,
            "branches": "extremities" if is_automatic else "none",
            "tolerance": {"DRAFT": 1e-3, "NORMAL": None, "HIGH": 1e-8}[self.quality],
            "time_limit": self.time_limit or None,
        }
        keep_islands = self.keep_islands
        return lambda watch: unwrap(engine, faces, keep_islands, options, watch)


class UV_OT_flip_free_repair(Task, bpy.types.Operator):
    """Remove the flips of UV islands that have some, and then minimise their distortion. Islands keep their size and, as nearly as
    they can, their place"""

    bl_idname = "uv.flip_free_repair"
    bl_label = "Repair UVs"

    fix_border: BoolProperty(name="Keep Borders", description="The borders of islands keep their places", default=False)

    def work(self, engine, faces):
        fix_border = self.fix_border
        return lambda watch: repair(engine, faces, fix_border, watch)


class UV_OT_flip_free_pack(Task, Packed, bpy.types.Operator):
    """Pack UV islands into the unit square, by the same scale"""

    bl_idname = "uv.flip_free_pack"
    bl_label = "Pack UVs without Overlaps"

    def work(self, engine, faces):
        options = self.packing()
        return lambda watch: pack(engine, faces, options, watch)


class FlipFreeMapsPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    engine: EnumProperty(
        name="Work Is Done By",
        items=(
            ("AUTO", "Module or Program", "The Python module flip_free_maps where it can be imported, the program otherwise"),
            ("MODULE", "Module", "The Python module flip_free_maps"),
            ("PROGRAM", "Program", "The program flip_free_maps"),
        ),
    )
    program: StringProperty(name="Program", description="Path of the program flip_free_maps; empty: it is on the PATH", subtype="FILE_PATH")

    def draw(self, context):
        self.layout.prop(self, "engine")
        self.layout.prop(self, "program")
        try:
            engine = find_engine(context)
            text = "the module " + engine.module.__version__ if isinstance(engine, ModuleEngine) else engine.program
            self.layout.label(text=f"Found: {text}", icon="CHECKMARK")
        except Refused as refused:
            self.layout.label(text=str(refused), icon="ERROR")


OPERATORS = (UV_OT_flip_free_unwrap, UV_OT_flip_free_repair, UV_OT_flip_free_pack)
MENUS = ("VIEW3D_MT_uv_map", "IMAGE_MT_uvs")


def draw_menu(self, context):
    self.layout.separator()
    for operator in OPERATORS:
        self.layout.operator(operator.bl_idname)


def register():
    for cls in (*OPERATORS, FlipFreeMapsPreferences):
        bpy.utils.register_class(cls)
    for menu in MENUS:
        getattr(bpy.types, menu).append(draw_menu)


def unregister():
    for menu in MENUS:
        getattr(bpy.types, menu).remove(draw_menu)
    for cls in (FlipFreeMapsPreferences, *reversed(OPERATORS)):
        bpy.utils.unregister_class(cls)


if __name__ == "__main__":
    register()
