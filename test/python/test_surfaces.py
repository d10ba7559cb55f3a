# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Functions on surfaces."""

import json
import math

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest


@pytest.mark.parametrize("mesh", [meshes.sphere(), meshes.torus(), meshes.sheet()], ids=["sphere", "torus", "sheet"])
def test_unwrap(mesh):
    points, faces = mesh
    atlas = ffm.unwrap(points, faces)
    vertices, atlas_faces, uv, charts, summary = atlas
    assert summary.status == "success" and summary.flips == 0 and summary.faces == len(faces)
    assert uv.dtype == np.float64 and uv.min() >= 0 and uv.max() <= 1
    assert meshes.is_atlas_of(faces, vertices, atlas_faces)
    assert meshes.flips(atlas_faces, uv) == 0 and ffm.is_bijective(atlas_faces, uv)
    assert charts.shape == (len(faces),) and set(charts) == set(range(len(summary.charts)))
    assert np.array_equal(np.bincount(charts), [chart.faces for chart in summary.charts])
    assert np.array_equal(atlas.corners, uv[atlas_faces]) and atlas.corners.shape == (len(faces), 3, 2)
    report = ffm.measure(points[vertices], atlas_faces, uv / summary.scale)
    assert report.flips == 0 and report.energy == pytest.approx(summary.energy, rel=1e-6)
    assert report.image_area * summary.scale**2 == pytest.approx(summary.occupancy, rel=1e-6)


def test_options_of_unwrap():
    points, faces = meshes.sphere()
    topology = ffm.unwrap(points, faces, max_distortion=math.inf, branches="none")
    assert len(topology.summary.charts) == 1
    fine = ffm.unwrap(points, faces, max_distortion=1.01)
    assert max(chart.energy for chart in fine.summary.charts) <= 1.01
    assert fine.summary.energy < topology.summary.energy
    unpacked = ffm.unwrap(points, faces, pack=False)
    assert unpacked.summary.scale == 1
    assert ffm.measure(points[unpacked.vertices], unpacked.faces, unpacked.uv).image_area == pytest.approx(4 * math.pi, rel=0.2)
    wide = ffm.unwrap(points, faces, resolution=64, padding=8)
    assert wide.uv.min() >= 4 / 64 * (1 - 1e-9)
    single = ffm.unwrap(points, faces, dtype=np.float32)
    assert single.uv.dtype == np.float32 and meshes.flips(single.faces, single.uv) == 0
    with pytest.raises(TypeError):
        ffm.unwrap(points, faces, dtype=np.float16)
    with pytest.raises(ffm.InvalidOption) as error:
        ffm.unwrap(points, faces, max_distortion=0.5)
    assert error.value.status == "invalid_option" and "max_distortion" in error.value.message
    with pytest.raises(ffm.InvalidOption, match="branches must be one of"):
        ffm.unwrap(points, faces, branches="leaves")


def test_seams_of_unwrap():
    points, faces = meshes.sheet(6)
    middle = np.arange(7) * 7 + 3
    seams = np.stack([middle[:-1], middle[1:]], axis=1)
    atlas = ffm.unwrap(points, faces, seams=seams, max_distortion=math.inf)
    assert len(atlas.summary.charts) == 2 and atlas.summary.seam_edges == 6
    # No chart has vertices on both sides.
    column = atlas.vertices % 7
    for chart in (0, 1):
        columns = column[atlas.faces[atlas.charts == chart]]
        assert columns.max() <= 3 or columns.min() >= 3
    with pytest.raises(ffm.InvalidOption, match="no edge from 0 to 40"):
        ffm.unwrap(points, faces, seams=[[0, 40]])
    assert ffm.unwrap(points, faces, features=seams).summary.flips == 0


def test_unwrap_polygons():
    points, faces = meshes.quads(8)
    atlas = ffm.unwrap(points, faces)
    assert atlas.faces.shape == (64, 4) and atlas.corners.shape == (64, 4, 2) and atlas.summary.faces == 64
    assert meshes.is_atlas_of(faces, atlas.vertices, atlas.faces)
    corners, offsets = atlas.faces.ravel(), np.arange(0, 257, 4)
    assert min(meshes.areas(atlas.uv, corners, offsets)) > 0
    assert atlas.charts.shape == (64,) and np.array_equal(np.unique(atlas.charts), np.arange(len(atlas.summary.charts)))
    # A prism, whose top and bottom are hexagons that are not convex.
    ring = np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], dtype=float)
    prism = np.concatenate([np.column_stack([ring, np.full(6, z)]) for z in (0.0, 1.0)])
    sides = [[k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k] for k in range(6)]
    given = [list(range(5, -1, -1)), list(range(6, 12)), *sides]
    atlas = ffm.unwrap(prism, given)
    corners, offsets = atlas.faces
    assert np.array_equal(np.diff(offsets), [6, 6, 4, 4, 4, 4, 4, 4])
    assert np.array_equal(atlas.vertices[corners], np.concatenate(given))
    areas = np.array([float(a) / 2 for a in meshes.areas(atlas.uv, corners, offsets)]) / atlas.summary.scale**2
    # All faces are planar: their images are isometric.
    assert areas == pytest.approx([3, 3, 2, 1, 1, 1, 1, 2], rel=1e-3)
    cut = ffm.unwrap(prism, given, seams=[[0, 1], [6, 7]], features=[[0, 5]], max_distortion=math.inf)
    for ends in ((0, 1), (6, 7)):
        images = [frozenset(corners[f][k] for k in range(len(given[f])) if given[f][k] in ends) for f in range(8)
                  for corners in [np.split(cut.faces[0], cut.faces[1][1:-1])] if set(ends) <= set(given[f])]
        assert len(images) == 2 and images[0] != images[1]
    # A diagonal is no edge.
    with pytest.raises(ffm.InvalidOption, match="no edge from 0 to 7"):
        ffm.unwrap(prism, given, seams=[[0, 7]])
    with pytest.raises(ffm.NotTriangular):
        ffm.unwrap(prism, given, strict=True)
    html = atlas._repr_html_()
    assert html.endswith("</svg>") and html.count("M") >= 18


def test_surfaces_that_are_not_manifold():
    points, faces = meshes.sheet(4)
    count = len(faces)
    # A fin on the edge from 6 to 7, a face twice, one without area, and one with two places.
    fin = np.concatenate([points, [[0.4, 0.3, 2]]])
    for more, status, parted, flat, left_out in (([[6, 7, 25]], "non_manifold", 1, 0, 0), (faces[:1], "non_manifold", None, 0, 0),
                                                 ([[6, 7, 7]], "non_manifold", 0, 1, 1)):
        given = np.concatenate([faces, more])
        atlas = ffm.unwrap(fin, given)
        summary = atlas.summary
        assert summary.status == "success" and summary.flips == 0 and summary.faces == count + 1
        assert parted is None or summary.parted_edges == parted
        assert summary.faces_without_area == flat and summary.first_faces_without_area == [count] * flat
        assert meshes.is_atlas_of(given, atlas.vertices, atlas.faces) and (atlas.charts < 0).sum() == left_out
        kept = atlas.faces[atlas.charts >= 0]
        assert meshes.flips(kept, atlas.uv) == 0 and ffm.is_bijective(kept, atlas.uv)
        with pytest.raises(ffm.Error) as error:
            ffm.unwrap(fin, given, strict=True)
        assert error.value.status in (status, "degenerate_rest_element")
    flipped = faces.copy()
    flipped[5] = flipped[5, ::-1]
    atlas = ffm.unwrap(points, flipped)
    assert atlas.summary.parted_edges == 3 and meshes.flips(atlas.faces, atlas.uv) == 0
    with pytest.raises(ffm.NonManifold):
        ffm.unwrap(points, flipped, strict=True)
    collapsed = points.copy()
    collapsed[0] = collapsed[1]
    atlas = ffm.unwrap(collapsed, faces)
    assert atlas.summary.faces_without_area == 1 and atlas.charts[0] == -1 and atlas.charts[1:].min() == 0
    # Points at the same place are one.
    soup, numbers = points[faces].reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)
    assert np.array_equal(ffm.unwrap(soup, numbers).corners, ffm.unwrap(points, faces).corners)


def test_parameterize():
    points, faces = meshes.sheet()
    uv, summary = ffm.parameterize(points, faces)
    assert uv.shape == (len(points), 2) and uv.dtype == np.float64 and uv.flags.owndata and uv.flags.writeable
    assert summary.status == "success" and summary.converged and summary.bijective is None
    assert meshes.flips(faces, uv) == 0
    assert ffm.measure(points, faces, uv).energy == pytest.approx(summary.energy, rel=1e-9)


def test_methods_and_energies_meet():
    points, faces = meshes.sheet(8)
    expected = ffm.parameterize(points, faces).summary.energy
    for method in ("slim", "cm", "akvf", "projected-newton", "pp"):
        summary = ffm.parameterize(points, faces, method=method).summary
        assert summary.energy == pytest.approx(expected, rel=1e-4), method
    for energy in ("symmetric-gradient", "amips", "hencky", "exponential-symmetric-dirichlet"):
        uv, summary = ffm.parameterize(points, faces, energy=energy)
        assert meshes.flips(faces, uv) == 0 and summary.energy_name == energy.replace("-", "_")
    summary = ffm.parameterize(points, faces, preconditioner="killing", acceleration="none", linear_solver="eigen").summary
    assert summary.preconditioner == "killing" and summary.energy == pytest.approx(expected, rel=1e-4)
    for bad in ({"method": "magic"}, {"energy": "dark"}, {"preconditioner": "none"}, {"criterion": "taste"}, {"border": "star"},
                {"start": "late"}, {"weights": "heavy"}, {"method": "splitting"}, {"method": "cm", "energy": "amips"},
                {"tolerance": -1}, {"time_limit": 0}, {"time_limit": math.nan}, {"max_iterations": -2}, {"energy_parameter": 0}):
        with pytest.raises(ffm.InvalidOption):
            ffm.parameterize(points, faces, **bad)


def test_constraints():
    points, faces = meshes.sheet(8)
    start = points[:, :2].copy()
    uv, _ = ffm.parameterize(points, faces, start=start, fixed=[0, 8, 40])
    assert np.array_equal(uv[[0, 8, 40]], start[[0, 8, 40]])
    mask = np.zeros(len(points), dtype=bool)
    mask[[0, 8, 40]] = True
    assert np.array_equal(ffm.parameterize(points, faces, start=start, fixed=mask).uv, uv)
    border = (start == 0).any(axis=1) | (start == 1).any(axis=1)
    uv, _ = ffm.parameterize(points, faces, start=start, fix_border=True)
    assert np.array_equal(uv[border], start[border]) and meshes.flips(faces, uv) == 0
    pulled = np.array([[3.0, 0.0], [0.0, 3.0]])
    near = []
    for weight in (0.01, 1, 100):
        uv, _ = ffm.parameterize(points, faces, soft=([8, 72], pulled, weight))
        near.append(np.abs(uv[[8, 72]] - pulled).max())
    assert near[0] > near[1] > near[2] > 0
    uv, summary = ffm.parameterize(points, faces, bijective=True)
    assert summary.bijective and ffm.is_bijective(faces, uv)
    for border in ("square", "triangle", "octagon", [[0, 0], [2, 0], [1, 3]]):
        assert ffm.parameterize(points, faces, border=border, start="tutte").summary.flips == 0
    with pytest.raises(ffm.InvalidOption):
        ffm.parameterize(points, faces, border=[[0, 0], [1, 3], [2, 0]], start="tutte")
    with pytest.raises(ffm.InvalidOption, match="81"):
        ffm.parameterize(points, faces, fixed=[81])
    with pytest.raises(ValueError):
        ffm.parameterize(points, faces, fixed=mask[:-1])
    with pytest.raises(ValueError):
        ffm.parameterize(points, faces, start=start[:-1])
    with pytest.raises(ffm.StartNotFlipFree) as error:
        ffm.parameterize(points, faces, start=start * [-1, 1])
    assert error.value.summary.flips == len(faces)
    with pytest.raises(ValueError):
        ffm.parameterize(points, faces, soft=([8, 9], pulled[:1], 1))
    # Numbers of vertices are the caller's, also where points of no face come before.
    more = np.concatenate([points[:5] + 9, points])
    for places, weights in ((pulled * [[1], [np.nan]], 1), (pulled, [1, np.inf]), (pulled, [1, -1])):
        with pytest.raises(ffm.InvalidOption, match="number 1, of vertex 77,"):
            ffm.parameterize(more, faces + 5, soft=([13, 77], places, weights))


def test_limits_leave_a_valid_map():
    points, faces = meshes.sheet()
    uv, summary = ffm.parameterize(points, faces, method="aqp", max_iterations=2)
    assert summary.status == "iteration_limit" and not summary.converged and meshes.flips(faces, uv) == 0
    uv, summary = ffm.parameterize(points, faces, method="aqp", time_limit=1e-9)
    assert summary.status == "time_limit" and meshes.flips(faces, uv) == 0


def test_repair():
    points, faces = meshes.sheet(8)
    uv = points[:, :2].copy()
    uv[40] += 0.3
    assert meshes.flips(faces, uv) > 0
    given = uv.copy()
    repaired, summary = ffm.repair(points, faces, uv)
    assert meshes.flips(faces, repaired) == 0 and summary.flips == 0 and np.array_equal(uv, given)
    border = (points[:, :2] == 0).any(axis=1) | (points[:, :2] == 1).any(axis=1)
    kept, _ = ffm.repair(points, faces, uv, fix_border=True, polish=False)
    assert np.array_equal(kept[border], uv[border]) and meshes.flips(faces, kept) == 0
    # Two places of the border that are exchanged cannot be held there.
    uv[[0, 80]] = uv[[80, 0]]
    with pytest.raises(ffm.Error) as error:
        ffm.repair(points, faces, uv, fix_border=True, max_iterations=50)
    assert error.value.status == error.value.summary.status
    with pytest.raises(ffm.InvalidOption, match="image for each point"):
        ffm.repair(points, faces, uv[:-1])


def test_measure():
    points, faces = meshes.sheet(4)
    flat = points * [1, 1, 0]
    report = ffm.measure(flat, faces, 2 * flat[:, :2])
    assert report.status == "success" and report.faces == 32 and report.flips == 0
    assert report.rest_area == pytest.approx(1) and report.image_area == pytest.approx(4)
    assert report.min_singular_value == pytest.approx(2) and report.max_singular_value == pytest.approx(2)
    assert report.energy == pytest.approx((4 + 1 / 4) / 2) and report.energy_of_similarity == pytest.approx(1)
    report = ffm.measure(flat, faces, flat[:, :2] * [-1, 1])
    assert report.flips == 32 and report.energy == math.inf
    with pytest.raises(ffm.InvalidOption):
        ffm.measure(flat, faces, flat[:-1, :2])


def test_is_bijective():
    _, faces = meshes.sheet(4)
    uv = meshes.sheet(4)[0][:, :2]
    assert ffm.is_bijective(faces, uv) is True
    assert ffm.is_bijective(faces, uv, explain=True)[0] is True
    folded = uv.copy()
    folded[:, 0] = np.abs(folded[:, 0] - 0.5)
    answer, message = ffm.is_bijective(faces, folded, explain=True)
    assert answer is False and message
    answer, message = ffm.is_bijective([[0, 1, 99]], uv, explain=True)
    assert answer is False and "out of range" in message


def test_pack():
    points, faces = meshes.sphere()
    atlas = ffm.unwrap(points, faces, pack=False)
    uv, summary = ffm.pack(atlas.faces, atlas.uv, margin=0.05)
    assert uv.min() >= 0.025 * (1 - 1e-9) and uv.max() <= 1 - 0.025 * (1 - 1e-9)
    assert summary.charts == len(atlas.summary.charts) and ffm.is_bijective(atlas.faces, uv)
    before, after = (ffm.measure(points[atlas.vertices], atlas.faces, x).image_area for x in (atlas.uv, uv))
    assert after == pytest.approx(before * summary.scale**2) and after == pytest.approx(summary.occupancy)
    assert ffm.pack(atlas.faces, atlas.uv, rotate=False, resolution=128, padding=1).summary.status == "success"
    with pytest.raises(ffm.InvalidOption):
        ffm.pack(atlas.faces, atlas.uv, margin=0.7)
    with pytest.raises(ffm.StartNotFlipFree):
        ffm.pack(atlas.faces, atlas.uv * [-1, 1])


def test_pinned_charts():
    points, faces = meshes.sphere()
    atlas = ffm.unwrap(points, faces, max_distortion=1.01)
    assert len(atlas.summary.charts) > 1
    is_pinned = atlas.charts == 1
    # By flags of all faces of the chart, or by the number of one.
    for pinned in (is_pinned, [int(np.flatnonzero(is_pinned)[0])]):
        uv, summary = ffm.pack(atlas.faces, atlas.uv, pinned=pinned, margin=0.01)
        stays = np.unique(atlas.faces[is_pinned])
        assert summary.pinned_charts == 1 and summary.charts == len(atlas.summary.charts)
        assert (uv[stays] == atlas.uv[stays]).all() and (np.delete(uv, stays, 0) != np.delete(atlas.uv, stays, 0)).any()
        assert ffm.is_bijective(atlas.faces, uv)
    for wrong in ([len(faces)], [-1]):
        with pytest.raises(ffm.InvalidOption):
            ffm.pack(atlas.faces, atlas.uv, pinned=wrong)
    with pytest.raises(ValueError):
        ffm.pack(atlas.faces, atlas.uv, pinned=is_pinned[:-1])


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_pinned_faces(dtype):
    points, faces = meshes.sphere()
    atlas = ffm.unwrap(points, faces, max_distortion=1.01, dtype=dtype)
    is_pinned = atlas.charts == 1
    again = ffm.unwrap(points, faces, pinned=is_pinned, uv=atlas.corners, dtype=dtype)
    assert again.summary.pinned_faces == is_pinned.sum() and (again.charts[is_pinned] == -1).all() and (again.charts[~is_pinned] >= 0).all()
    assert (again.corners[is_pinned] == atlas.corners[is_pinned]).all()
    assert meshes.is_atlas_of(faces, again.vertices, again.faces) and ffm.is_bijective(again.faces, again.uv)
    assert (ffm.unwrap(points, faces, pinned=np.flatnonzero(is_pinned), uv=atlas.corners, dtype=dtype).uv == again.uv).all()
    with pytest.raises(TypeError):
        ffm.unwrap(points, faces, pinned=is_pinned)
    with pytest.raises(ValueError):
        ffm.unwrap(points, faces, pinned=is_pinned, uv=atlas.uv[:5])
    with pytest.raises(ffm.InvalidOption):
        ffm.unwrap(points, faces, pinned=is_pinned, uv=atlas.corners, pack=False)


@pytest.mark.parametrize("mesh", [meshes.sphere(), meshes.torus()], ids=["sphere", "torus"])
def test_cut_to_disk(mesh):
    points, faces = mesh
    cut = ffm.cut_to_disk(points, faces)
    assert cut.seams.ndim == 2 and cut.seams.shape[1] == 2 and cut.summary.status == "success"
    assert meshes.is_atlas_of(faces, cut.vertices, cut.faces)
    # A disk has the Euler characteristic 1.
    edges = np.sort(np.concatenate([cut.faces[:, [0, 1]], cut.faces[:, [1, 2]], cut.faces[:, [2, 0]]]), axis=1)
    assert len(cut.vertices) - len(np.unique(edges, axis=0)) + len(faces) == 1
    uv, summary = ffm.parameterize(points[cut.vertices], cut.faces)
    assert meshes.flips(cut.faces, uv) == 0
    again = ffm.cut_to_disk(points, faces, seams=cut.seams)
    assert np.array_equal(again.seams[: len(cut.seams)], cut.seams)


def test_options_of_cut_to_disk():
    points, faces = meshes.sphere()
    least = ffm.cut_to_disk(points, faces, branches="none")
    most = ffm.cut_to_disk(points, faces, branches="farthest-points", number_of_points=12)
    assert len(most.seams) > len(least.seams)
    with pytest.raises(ffm.InvalidOption):
        ffm.cut_to_disk(points, faces, branches="farthest-points", number_of_points=1)
    with pytest.raises(ffm.InvalidOption, match="no edge"):
        ffm.cut_to_disk(points, faces, seams=[[0, 2]])


def test_parameterize_with_seams():
    points, faces = meshes.sphere()
    cut = ffm.cut_to_disk(points, faces)
    vertices, seam_faces, uv, summary = ffm.parameterize_with_seams(points, faces, cut.seams)
    assert meshes.is_atlas_of(faces, vertices, seam_faces) and meshes.flips(seam_faces, uv) == 0
    assert summary.residual <= 1e-8
    # Each rotation is one by a multiple of 90 degrees.
    assert len(summary.transformations) > 0
    for a, b in summary.transformations:
        assert min(abs(a - x) + abs(b - y) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))) < 1e-6
    similar = ffm.parameterize_with_seams(points, faces, cut.seams, similar=True)
    assert similar.summary.residual <= 1e-8 and similar.summary.energy <= summary.energy * (1 + 1e-6)
    with pytest.raises(ffm.InvalidOption, match="no seam"):
        ffm.parameterize_with_seams(points, faces, [])
    with pytest.raises(ffm.InvalidOption, match="no edge"):
        ffm.parameterize_with_seams(points, faces, [[0, 2]])


def test_failures_carry_their_status():
    points, faces = meshes.sphere(1)
    sheet, sheet_faces = meshes.sheet(4)
    bent = sheet.copy()
    bent[7] = np.nan
    turned = sheet_faces.copy()
    turned[5] = turned[5, ::-1]
    flat = sheet.copy()
    flat[0] = flat[1]
    # Faces without area, and those that are there twice, are mapped.
    assert ffm.parameterize(flat, sheet_faces).summary.faces_without_area > 0
    assert ffm.parameterize(sheet, np.concatenate([sheet_faces, sheet_faces[:1]])).summary.faces == len(sheet_faces)
    for call, status, kind in (
        (lambda: ffm.parameterize(points, faces), "no_border", ffm.NoBorder),
        (lambda: ffm.unwrap(bent, sheet_faces), "non_finite_input", ffm.NonFiniteInput),
        (lambda: ffm.parameterize(bent, sheet_faces), "non_finite_input", ffm.NonFiniteInput),
        (lambda: ffm.parameterize(sheet, turned), "non_manifold", ffm.NonManifold),
        (lambda: ffm.unwrap(flat, sheet_faces, strict=True), "degenerate_rest_element", ffm.DegenerateRestElement),
        (lambda: ffm.unwrap(flat, [[0, 1, 1], [2, 3, 2]]), "degenerate_rest_element", ffm.DegenerateRestElement),
        (lambda: ffm.unwrap(sheet, np.zeros((0, 3), dtype=int)), "empty_mesh", ffm.EmptyMesh),
        (lambda: ffm.unwrap(sheet, []), "empty_mesh", ffm.EmptyMesh),
        (lambda: ffm.unwrap(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32)), "empty_mesh", ffm.EmptyMesh),
        (lambda: ffm.unwrap(sheet, [[0, 1, 25]]), "invalid_option", ffm.InvalidOption),
        (lambda: ffm.unwrap(sheet, [[0, 1, -1]]), "invalid_option", ffm.InvalidOption),
    ):
        with pytest.raises(kind) as error:
            call()
        assert error.value.status == status and error.value.message and isinstance(error.value, ffm.Error)
        assert str(error.value) == f"{status}: {error.value.message}"
        assert error.value.summary is None or error.value.summary.status == status
    assert issubclass(ffm.InvalidOption, ValueError) and issubclass(ffm.OutOfMemory, MemoryError)


def test_summaries():
    points, faces = meshes.sheet(4)
    result = ffm.parameterize(points, faces)
    summary = result.summary
    fields = summary.to_dict()
    assert json.loads(json.dumps(fields))["status"] == "success"
    assert fields["energy"] == summary.energy and fields["seconds"]["total"] == summary.seconds.total
    fields["seconds"]["total"] = -7
    assert summary.seconds.total >= 0 and summary.to_dict()["seconds"]["total"] >= 0
    assert "success" in repr(summary) and "energy" in str(summary)
    assert "<table>" in summary._repr_html_() and "energy" in summary._repr_html_()
    atlas = ffm.unwrap(points, faces)
    for html in (result._repr_html_(), atlas._repr_html_(), ffm.pack(atlas.faces, atlas.uv)._repr_html_()):
        assert html.startswith("<table>") and html.endswith("</svg>") and html.count("<path") == 2
    # The picture has all edges: each is one line.
    assert atlas._repr_html_().count("M") >= 56
