# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""The interface of xatlas-python."""

import flip_free_maps as xatlas
import meshes
import numpy as np
import pytest


@pytest.mark.parametrize("mesh", [meshes.sphere(), meshes.torus(), meshes.sheet()], ids=["sphere", "torus", "sheet"])
def test_parametrize(mesh):
    points, faces = mesh
    vmapping, indices, uvs = xatlas.parametrize(points, faces)
    assert vmapping.dtype == np.uint32 and vmapping.ndim == 1
    assert indices.dtype == np.uint32 and indices.shape == faces.shape
    assert uvs.dtype == np.float32 and uvs.shape == (len(vmapping), 2)
    assert uvs.min() >= 0 and uvs.max() <= 1
    assert meshes.is_atlas_of(faces, vmapping, indices)
    assert len(np.unique(indices)) == len(vmapping)
    assert meshes.flips(indices, uvs) == 0
    assert xatlas.is_bijective(indices, uvs)


def test_types_that_pipelines_have():
    points, faces = meshes.sphere(1)
    expected = xatlas.parametrize(points.astype(np.float32), faces)
    for p in (points.astype(np.float32), np.asfortranarray(points.astype(np.float32)), points.astype(np.float32).tolist()):
        for f in (faces.astype(np.uint32), faces.astype(np.int32), faces.astype(np.uint64), faces.tolist(), faces.astype(float)):
            for array, other in zip(xatlas.parametrize(p, f), expected):
                assert np.array_equal(array, other) and array.dtype == other.dtype


def test_normals_and_uvs_are_accepted():
    points, faces = meshes.sphere(1)
    expected = xatlas.parametrize(points, faces)
    for array, other in zip(xatlas.parametrize(points, faces, points, points[:, :2]), expected):
        assert np.array_equal(array, other)


def test_duplicated_vertices_make_no_seams():
    points, faces = meshes.sphere(1)
    atlas = xatlas.Atlas()
    atlas.add_mesh(points, faces)
    atlas.generate()
    soup = xatlas.Atlas()
    soup.add_mesh(points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3))
    soup.generate()
    assert soup.chart_count == atlas.chart_count
    vmapping, indices, uvs = soup[0]
    # Each vertex is one of the soup, so that its other attributes are found there.
    assert np.array_equal(vmapping[indices].ravel(), np.arange(3 * len(faces)))
    assert np.array_equal(uvs[indices], atlas[0][2][atlas[0][1]])


def test_sheets_that_only_touch_stay_apart():
    points, faces = meshes.sphere(0)
    # Two octahedra with a common edge, from (1, 0, 0) to (0, 1, 0), which has four triangles when their vertices are one.
    other = points * [-1, 1, 1] + [2, 0, 0]
    other[1] = points[1]
    soup = np.concatenate([points, other])
    both = np.concatenate([faces, faces[:, ::-1] + len(points)])
    vmapping, indices, uvs = xatlas.parametrize(soup, both)
    assert meshes.is_atlas_of(both, vmapping, indices)
    assert meshes.flips(indices, uvs) == 0


def surfaces_of_all_kinds():
    points, faces = meshes.sheet(4)
    fin = np.concatenate([points, [[0.4, 0.3, 2]]])
    flipped = faces.copy()
    flipped[5] = flipped[5, ::-1]
    # Four cells of a flat ring touch in the middle.
    flat = points * [1, 1, 0]
    touching = np.concatenate([faces[:16].reshape(4, 4, 3), faces[16:].reshape(4, 4, 3)], axis=2)
    keep = np.ones((4, 4), dtype=bool)
    keep[1, 1] = keep[2, 2] = False
    yield "fin", fin, np.concatenate([faces, [[6, 7, 25]]])
    yield "twice", points, np.concatenate([faces, faces])
    yield "flipped", points, flipped
    yield "without area", fin, np.concatenate([[[3, 3, 4]], faces, [[6, 7, 7], [0, 1, 2]]])
    yield "touching", flat, touching[keep].reshape(-1, 3)


@pytest.mark.parametrize("texels", [0, 100])
@pytest.mark.parametrize("points, faces", [entry[1:] for entry in surfaces_of_all_kinds()],
                         ids=[entry[0] for entry in surfaces_of_all_kinds()])
def test_surfaces_of_all_kinds(points, faces, texels):
    options = xatlas.PackOptions()
    options.texels_per_unit = texels
    atlas = xatlas.Atlas()
    atlas.add_mesh(points, faces)
    atlas.generate(pack_options=options)
    vmapping, indices, uvs = atlas[0]
    assert meshes.is_atlas_of(faces, vmapping, indices) and uvs.dtype == np.float32
    assert uvs.min() >= 0 and uvs.max() <= 1
    kept = indices[[len(np.unique(points[face], axis=0)) == 3 for face in faces]]
    assert meshes.flips(kept, uvs) == 0 and xatlas.is_bijective(kept, uvs)


def test_atlas_of_several_meshes():
    atlas = xatlas.Atlas()
    assert (len(atlas), atlas.mesh_count, atlas.chart_count, atlas.atlas_count, atlas.width, atlas.height) == (0, 0, 0, 0, 0, 0)
    # One of them occurs twice, at the same place.
    all_meshes = [meshes.sphere(1), meshes.sheet(5), meshes.torus(8, 5), meshes.sphere(1)]
    for points, faces in all_meshes:
        atlas.add_mesh(points, faces)
    with pytest.raises(RuntimeError):
        atlas.get_mesh(0)
    atlas.generate()
    assert len(atlas) == atlas.mesh_count == 4 and atlas.atlas_count == 1
    assert atlas.chart_count >= 4 and 0 < atlas.utilization <= 1 and atlas.texels_per_unit > 0
    assert atlas.width == atlas.height == 1024
    offset, indices_of_all, uvs_of_all = 0, [], []
    for number, (points, faces) in enumerate(all_meshes):
        vmapping, indices, uvs = atlas[number]
        assert meshes.is_atlas_of(faces, vmapping, indices)
        indices_of_all.append(indices + offset)
        uvs_of_all.append(uvs)
        offset += len(uvs)
    assert xatlas.is_bijective(np.concatenate(indices_of_all), np.concatenate(uvs_of_all))
    # Results are the caller's own.
    atlas[0][2][:] = 7
    assert atlas[0][2].max() <= 1


def test_index_errors():
    atlas = xatlas.Atlas()
    with pytest.raises(IndexError, match="out of bounds"):
        atlas.get_mesh(0)
    atlas.add_mesh(*meshes.sphere(0))
    atlas.generate()
    for index in (1, -1):
        with pytest.raises(IndexError, match="out of bounds"):
            atlas.get_mesh(index)


def test_wrong_shapes_are_told_as_by_xatlas():
    points, faces = meshes.sphere(0)
    atlas = xatlas.Atlas()
    random = np.random.default_rng(1).random
    for arguments, text in (
        ((random(1), faces), "Nx3"),
        ((random((1, 1)), faces), "Nx3"),
        ((points, random(1)), "Nx3"),
        ((points, random((1, 1))), "Nx3"),
        ((points, faces, random(1)), "Nx3"),
        ((points, faces, random((1, 1))), "Nx3"),
        ((points, faces, random((1, 3))), "first dimension"),
        ((points, faces, points, random(1)), "Nx2"),
        ((points, faces, points, random((1, 1))), "Nx2"),
        ((points, faces, points, random((1, 2))), "first dimension"),
    ):
        with pytest.raises(ValueError, match=text):
            atlas.add_mesh(*arguments)
    with pytest.raises(RuntimeError, match="out of range"):
        atlas.add_mesh(random((1, 3)), faces)
    assert len(atlas) == 0


def test_pack_options():
    options = xatlas.PackOptions()
    assert (options.padding, options.resolution, options.texels_per_unit, options.bilinear) == (0, 0, 0, True)
    options.resolution, options.padding, options.rotate_charts_to_axis, options.bruteForce = 256, 4, False, True
    atlas = xatlas.Atlas()
    atlas.add_mesh(*meshes.torus())
    chart_options = xatlas.ChartOptions()
    chart_options.max_distortion = 1.2
    atlas.generate(chart_options, pack_options=options)
    assert atlas.width == atlas.height == 256
    _, indices, uvs = atlas[0]
    # Charts keep half of the padding from the border of the texture.
    distance = (4 + 2) / 256 / 2
    assert uvs.min() >= distance * (1 - 1e-5) and uvs.max() <= 1 - distance * (1 - 1e-5)


def test_texels_per_unit():
    points, faces = meshes.torus()
    options = xatlas.PackOptions()
    options.texels_per_unit = 40
    atlas = xatlas.Atlas()
    atlas.add_mesh(points, faces)
    atlas.generate(pack_options=options)
    assert 40 <= atlas.texels_per_unit < 41
    vmapping, indices, uvs = atlas[0]
    report = xatlas.measure(points[vmapping], indices, uvs)
    assert report.flips == 0
    # Lengths in pixels over lengths on the surface.
    scale = np.sqrt(report.image_area / report.rest_area) * atlas.width
    assert abs(scale / atlas.texels_per_unit - 1) < 0.05


def test_what_cannot_be_had_is_said():
    cannot_be_had = {"max_chart_area": 1.0, "max_boundary_length": 2.0, "use_input_mesh_uvs": True, "normal_seam_weight": 2000}
    for name, value in cannot_be_had.items():
        options = xatlas.ChartOptions()
        setattr(options, name, value)
        with pytest.raises(ValueError, match=name):
            xatlas.Atlas().generate(options)
    for name, value in (("max_chart_size", 64), ("blockAlign", True), ("create_image", True)):
        options = xatlas.PackOptions()
        setattr(options, name, value)
        with pytest.raises(ValueError, match=name):
            xatlas.Atlas().generate(pack_options=options)
    options = xatlas.PackOptions()
    options.resolution, options.texels_per_unit = 64, 3
    with pytest.raises(ValueError, match="several textures"):
        xatlas.Atlas().generate(pack_options=options)
    options = xatlas.ChartOptions()
    options.max_cost = 8
    with pytest.warns(UserWarning, match="max_cost"):
        xatlas.Atlas().generate(options)
    with pytest.raises(AttributeError):
        options.max_costs = 8
    with pytest.raises(RuntimeError):
        xatlas.Atlas().chart_image


def test_uv_meshes_are_packed():
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    atlas = xatlas.Atlas()
    atlas.add_uv_mesh(square, faces)
    atlas.add_uv_mesh(3 * square, faces)
    with pytest.raises(RuntimeError):
        atlas.add_mesh(*meshes.sphere(0))
    atlas.generate()
    assert atlas.chart_count == 2
    (v0, f0, uv0), (v1, f1, uv1) = atlas[0], atlas[1]
    assert np.array_equal(v1, np.arange(4)) and np.array_equal(f1, faces)
    assert xatlas.is_bijective(np.concatenate([f0, f1 + 4]), np.concatenate([uv0, uv1]))
    sides = [np.linalg.norm(uv[1] - uv[0]) for uv in (uv0, uv1)]
    assert abs(sides[1] / sides[0] - 3) < 1e-4


def test_verbose(capsys):
    atlas = xatlas.Atlas()
    atlas.add_mesh(*meshes.sphere(0))
    atlas.generate(verbose=True)
    assert "1024 x 1024" in capsys.readouterr().out


def test_export(tmp_path):
    points, faces = meshes.sphere(0)
    vmapping, indices, uvs = xatlas.parametrize(points, faces)
    path = tmp_path / "sphere.obj"
    xatlas.export(str(path), points[vmapping], indices, uvs, points[vmapping])
    lines = [line.split() for line in path.read_text().splitlines()]
    written = {word: np.array([line[1:] for line in lines if line[0] == word]) for word in ("v", "vt", "vn", "f")}
    assert np.array_equal(written["v"].astype(float), points[vmapping])
    assert np.array_equal(written["vt"].astype(np.float32), uvs)
    assert np.array_equal(np.char.partition(written["f"], "/")[..., 0].astype(int), indices.astype(int) + 1)
    xatlas.export(str(path), points, faces)
    assert "f 1 2 5\n" in path.read_text() and "/" not in path.read_text()
