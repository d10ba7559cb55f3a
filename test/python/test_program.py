# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""The module gives what the program gives, bit for bit."""

import json
import subprocess

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest


def write_obj(path, points, faces, uv=None):
    lines = ["v %.17g %.17g %.17g" % tuple(p) for p in points]
    corner = "%d"
    if uv is not None:
        lines += ["vt %.17g %.17g" % tuple(p) for p in uv]
        corner = "%d/%d"
    lines += ["f " + " ".join(corner % ((v + 1,) * corner.count("%")) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def read_corners_of_polygons(path):
    """The texture coordinates of the corners of each face: a list of lists."""
    texture, corners = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "vt":
            texture.append([float(word) for word in words[1:3]])
        elif words and words[0] == "f":
            corners.append([texture[int(word.split("/")[1]) - 1] for word in words[1:]])
    return corners


def read_corners(path, number_of_faces):
    """The same of triangles, as an array."""
    corners = read_corners_of_polygons(path)
    assert len(corners) == number_of_faces
    return np.array(corners)


def run(program, *arguments):
    subprocess.run([program, *map(str, arguments), "--quiet"], check=True)


@pytest.mark.parametrize("mesh", [meshes.sphere(3), meshes.torus(32, 16), meshes.sheet(20)], ids=["sphere", "torus", "sheet"])
def test_unwrap(program, tmp_path, mesh):
    points, faces = mesh
    write_obj(tmp_path / "in.obj", points, faces)
    for options, arguments in (({}, []), ({"max_distortion": 1.1, "margin": 0.01, "rotate": False, "branches": "none"},
                                          ["--max-distortion", 1.1, "--margin", 0.01, "--no-rotation", "--branches", "none"])):
        run(program, "unwrap", tmp_path / "in.obj", "-o", tmp_path / "out.obj", "--json", tmp_path / "out.json", *arguments)
        atlas = ffm.unwrap(points, faces, **options)
        assert np.array_equal(read_corners(tmp_path / "out.obj", len(faces)), atlas.corners)
        expected, fields = json.loads((tmp_path / "out.json").read_text()), atlas.summary.to_dict()
        assert expected.keys() == fields.keys()
        for name in ("status", "message", "energy", "scale", "occupancy", "seam_edges", "seam_length", "number_of_charts"):
            assert fields[name] == expected[name]


def test_unwrap_polygons(program, tmp_path):
    points, faces = meshes.quads(12)
    # Polygons of three, four and five corners, a fin on an edge, a face of two places, and one that is turned round.
    given = faces.tolist()
    given[3] = given[3][::-1]
    given[20:21] = [given[20][:3], [given[20][0], *given[20][2:]]]
    points = np.concatenate([points, [(points[0] + points[1]) / 2, [0.4, 0.3, 2]]])
    given[0].insert(1, len(points) - 2)
    given += [[40, 41, len(points) - 1], [50, 50, 51]]
    seams = [[56, 57], [57, 58]]
    (tmp_path / "seams").write_text("".join("%d %d\n" % tuple(edge) for edge in seams))
    write_obj(tmp_path / "in.obj", points, given)
    run(program, "unwrap", tmp_path / "in.obj", "-o", tmp_path / "out.obj", "--seams", tmp_path / "seams")
    atlas = ffm.unwrap(points, given, seams=seams)
    expected = [corner for polygon in read_corners_of_polygons(tmp_path / "out.obj") for corner in polygon]
    assert np.array_equal(np.array(expected), atlas.corners)
    assert atlas.summary.parted_edges > 0 and atlas.summary.faces_without_area > 0


@pytest.mark.parametrize("options", [{}, {"method": "slim"}, {"energy": "amips", "max_iterations": 5}, {"bijective": True},
                                     {"start": "tutte", "border": "square", "weights": "cotangent", "fix_border": True}], ids=str)
def test_parameterize(program, tmp_path, options):
    points, faces = meshes.sheet(24)
    write_obj(tmp_path / "in.obj", points, faces)
    arguments = []
    for name, value in options.items():
        arguments += ["--" + name.replace("_", "-")] + ([] if value is True else [value])
    run(program, "parameterize", tmp_path / "in.obj", "-o", tmp_path / "out.obj", *arguments)
    uv, _ = ffm.parameterize(points, faces, **options)
    assert np.array_equal(read_corners(tmp_path / "out.obj", len(faces)), uv[faces])


def test_repair(program, tmp_path):
    points, faces = meshes.sheet(12)
    uv = points[:, :2] + 0.1 * np.random.default_rng(2).random((len(points), 2))
    write_obj(tmp_path / "in.obj", points, faces, uv)
    run(program, "repair", tmp_path / "in.obj", "-o", tmp_path / "out.obj", "--json", tmp_path / "out.json")
    # The program numbers the vertices of each island anew, and lays the result upon the map that was given.
    summary = json.loads((tmp_path / "out.json").read_text())
    result = ffm.repair(points, faces, uv)
    assert summary["flips"] == result.summary.flips == 0
    assert summary["energy"] == pytest.approx(result.summary.energy, rel=1e-3)


def test_deform(program, tmp_path):
    points, faces = meshes.sheet(12)
    points = points * [1, 1, 0]
    handles, targets = [0, 12, 156], [[0, 0], [1, 0.3], [-0.2, 1]]
    write_obj(tmp_path / "in.obj", points, faces)
    (tmp_path / "in.handles").write_text("".join("%d %.17g %.17g\n" % (v, *p) for v, p in zip(handles, targets)))
    run(program, "deform", tmp_path / "in.obj", "--handles", tmp_path / "in.handles", "-o", tmp_path / "out.obj")
    written = [line.split()[1:] for line in (tmp_path / "out.obj").read_text().splitlines() if line.startswith("v ")]
    result, _ = ffm.deform(points, faces, handles, targets)
    assert np.array_equal(np.array(written, dtype=float), result)


def write_mesh(path, points, tetrahedra):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += ["%.17g %.17g %.17g 0" % tuple(p) for p in points] + ["Tetrahedra", str(len(tetrahedra))]
    lines += ["%d %d %d %d 0" % tuple(t + 1) for t in tetrahedra] + ["End"]
    path.write_text("\n".join(lines) + "\n")


def read_mesh(path):
    words = path.read_text().split()
    at = words.index("Vertices")
    number = int(words[at + 1])
    return np.array(words[at + 2:at + 2 + 4 * number], dtype=float).reshape(-1, 4)[:, :3]


def test_solids(program, tmp_path):
    points, tetrahedra = meshes.bar(6, 3)
    write_mesh(tmp_path / "in.mesh", points, tetrahedra)
    handles = np.flatnonzero((points[:, 0] == 0) | (points[:, 0] == 6))
    targets = points[handles] + (points[handles][:, :1] > 0) * np.array([[-1, 2, 0.5]])
    (tmp_path / "in.handles").write_text("".join("%d %.17g %.17g %.17g\n" % (v, *p) for v, p in zip(handles, targets)))
    run(program, "deform", tmp_path / "in.mesh", "--handles", tmp_path / "in.handles", "-o", tmp_path / "out.mesh")
    assert np.array_equal(read_mesh(tmp_path / "out.mesh"), ffm.deform(points, tetrahedra, handles, targets).points)

    boundary = ffm.boundary_vertices(tetrahedra)
    places = points[boundary] + 0.2 * np.sin(points[boundary][:, [1, 2, 0]])
    (tmp_path / "to.handles").write_text("".join("%d %.17g %.17g %.17g\n" % (v, *p) for v, p in zip(boundary, places)))
    run(program, "map-volume", tmp_path / "in.mesh", tmp_path / "to.handles", "-o", tmp_path / "out.mesh")
    assert np.array_equal(read_mesh(tmp_path / "out.mesh"), ffm.map_volume(points, tetrahedra, places).points)
