# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""The scripts that users copy, on small inputs."""

import json
import os
import struct
import subprocess
import sys

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest

FOLDER = os.path.join(os.path.dirname(__file__), "..", "..", "examples", "python")


def run(name, *arguments):
    command = [sys.executable, os.path.join(FOLDER, name), *map(str, arguments)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def test_texture_mesh(tmp_path):
    assert "flips 0" in run("texture_mesh.py", tmp_path / "knot.glb")
    data = (tmp_path / "knot.glb").read_bytes()
    magic, version, size, text_size, kind = struct.unpack("<4sIII4s", data[:20])
    assert (magic, version, size, kind) == (b"glTF", 2, len(data), b"JSON")
    scene = json.loads(data[20:20 + text_size])
    blob = data[28 + text_size:]
    assert scene["buffers"][0]["byteLength"] == len(blob)

    def array(number, dtype, columns):
        view = scene["bufferViews"][number]
        part = blob[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
        return np.frombuffer(part, dtype=dtype).reshape(-1, columns)

    points, uv, faces = array(0, "<f4", 3), array(1, "<f4", 2), array(2, "<u4", 3)
    assert len(points) == len(uv) == scene["accessors"][0]["count"] and faces.max() < len(points)
    # They are seen from outside, where the volume that they enclose is positive. With v downwards they are clockwise in the texture.
    a, b, c = (points[faces[:, k]] for k in range(3))
    assert (np.cross(a, b) * c).sum() > 0
    assert ffm.is_bijective(faces[:, ::-1], uv)
    assert blob[scene["bufferViews"][3]["byteOffset"]:][:8] == b"\x89PNG\r\n\x1a\n"


def test_compare_with_xatlas(tmp_path):
    points, faces = meshes.sphere()
    ffm.export(tmp_path / "ball.obj", points, faces)
    lines = [line.split() for line in run("compare_with_xatlas.py", tmp_path / "ball.obj").splitlines()]
    atlas = ffm.unwrap(points.astype(np.float32), faces, resolution=1024, padding=2, dtype=np.float32)
    row = next(line for line in lines if "flip_free_maps" in line)
    assert row[1:7] == [str(len(faces)), "flip_free_maps", str(len(atlas.summary.charts)), "0", "no", "0"]
    assert float(row[7]) == pytest.approx(100 * atlas.summary.occupancy, abs=0.1)


def test_flatten_scan(tmp_path):
    out = run("flatten_scan.py", "--cells", 20, tmp_path / "scan.obj")
    assert "800 triangles" in out and "iteration" in out and "flips 0" in out
    lines = [line.split() for line in (tmp_path / "scan.obj").read_text().splitlines()]
    uv = np.array([line[1:] for line in lines if line[0] == "vt"], dtype=float)
    faces = np.array([[int(word.split("/")[0]) for word in line[1:]] for line in lines if line[0] == "f"]) - 1
    assert len(faces) == 800 and meshes.flips(faces, uv) == 0


def test_bend_solid(tmp_path):
    assert "180.0 degrees: success" in run("bend_solid.py", "--cubes", 12, tmp_path / "bar.mesh")
    words = (tmp_path / "bar.mesh").read_text().split()
    at, to = words.index("Vertices"), words.index("Tetrahedra")
    points = np.array(words[at + 2:to], dtype=float).reshape(-1, 4)[:, :3]
    tetrahedra = np.array(words[to + 2:-1], dtype=int).reshape(-1, 5)[:, :4] - 1
    assert len(tetrahedra) == 12 * 4 * 6 and meshes.flips(tetrahedra, points) == 0
