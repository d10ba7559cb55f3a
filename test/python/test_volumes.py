# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Deformations of planar shapes and solids."""

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest


def bent(points):
    """The two ends of a bar, and where they go."""
    ends = np.flatnonzero((points[:, 0] == points[:, 0].min()) | (points[:, 0] == points[:, 0].max()))
    targets = points[ends].copy()
    right = targets[:, 0] == targets[:, 0].max()
    centre = targets[right].mean(axis=0)
    turn = np.eye(points.shape[1])
    turn[:2, :2] = [[0, -1], [1, 0]]
    targets[right] = (targets[right] - centre) @ turn.T + centre + [-1, 2, 0][: points.shape[1]]
    return ends, targets


def test_planar():
    points, faces = meshes.sheet(6)
    points = points[:, :2] * [4, 1]
    handles, targets = bent(points)
    result, summary = ffm.deform(points, faces, handles, targets)
    assert result.shape == points.shape and meshes.flips(faces, result) == 0
    assert np.array_equal(result[handles], targets) and summary.flips == 0
    # The same in a plane of space, of which the third coordinate is kept.
    in_space = np.concatenate([points, np.full((len(points), 1), 5.0)], axis=1)
    assert np.array_equal(ffm.deform(in_space, faces, handles, targets).points, np.concatenate([result, in_space[:, 2:]], axis=1))
    mask = np.zeros(len(points), dtype=bool)
    mask[handles] = True
    assert np.array_equal(ffm.deform(points, faces, mask, targets).points, result)
    again, summary = ffm.deform(points, faces, handles, targets, start=result)
    assert np.abs(again - result).max() < 1e-3 and summary.iterations <= 3
    for method in ("slim", "akvf", "projected-newton"):
        other, summary = ffm.deform(points, faces, handles, targets, method=method)
        assert meshes.flips(faces, other) == 0 and np.array_equal(other[handles], targets)


def test_bad_planar_input():
    points, faces = meshes.sheet(4)
    with pytest.raises(ffm.NotPlanar):
        ffm.deform(points, faces, [0], [[0, 0]])
    flat = points[:, :2]
    with pytest.raises(ValueError):
        ffm.deform(flat, faces, [0, 1], [[0, 0]])
    with pytest.raises(ValueError):
        ffm.deform(flat, faces, [0], [[0, 0, 0]])
    with pytest.raises(ffm.InvalidOption):
        ffm.deform(flat, faces, [25], [[0, 0]])
    with pytest.raises(ffm.InvalidOption):
        ffm.deform(flat, faces, [0, 0], [[0, 0], [1, 1]])
    with pytest.raises(ffm.InvalidOption, match="solids"):
        ffm.deform(flat, faces, [0], [[0, 0]], soft_weight=1)
    with pytest.raises(ffm.NotTriangular):
        ffm.deform(flat, [[0, 1, 6, 5, 2]], [0], [[0, 0]])


def test_solid():
    points, tetrahedra = meshes.bar()
    handles, targets = bent(points)
    result, summary = ffm.deform(points, tetrahedra, handles, targets)
    assert result.shape == points.shape and meshes.flips(tetrahedra, result) == 0
    assert np.array_equal(result[handles], targets)
    assert summary.dimension == 3 and summary.tetrahedra == len(tetrahedra)
    assert np.array_equal(ffm.deform_volume(points, tetrahedra, handles, targets).points, result)
    again, summary = ffm.deform(points, tetrahedra, handles, targets, start=result)
    assert summary.iterations <= 3 and np.abs(again - result).max() < 1e-2
    far = []
    for weight in (0.1, 10):
        pulled, _ = ffm.deform(points, tetrahedra, handles, targets, soft_weight=weight)
        far.append(np.abs(pulled[handles] - targets).max())
    assert far[0] > far[1] > 0
    # Points of no tetrahedron stay, whatever they are.
    more = np.concatenate([[[np.nan, 1, 2]], points])
    moved = ffm.deform(more, tetrahedra + 1, handles + 1, targets).points
    assert np.isnan(moved[0, 0]) and moved[0, 1] == 1 and meshes.flips(tetrahedra + 1, np.nan_to_num(moved)) == 0
    with pytest.raises(ffm.InvalidOption):
        ffm.deform(more, tetrahedra + 1, [0], [[0, 0, 0]])
    with pytest.raises(ffm.InvalidOption, match="plane"):
        ffm.deform(points, tetrahedra, handles, targets, method="cm")


@pytest.mark.parametrize("dimension", [2, 3])
def test_session(dimension):
    points, elements = meshes.sheet(6) if dimension == 2 else meshes.bar()
    points = points[:, :dimension]
    handles, targets = bent(points)
    session = ffm.Deformation(points, elements, handles)
    assert np.array_equal(session.handles, handles) and np.allclose(session.points, points, rtol=0, atol=1e-12)
    for part in (0.25, 0.5, 1.0):
        places = (1 - part) * points[handles] + part * targets
        summary = session.move(places)
        assert summary.status == "success" and summary.dimension == dimension
        assert np.array_equal(session.points[handles], places) and meshes.flips(elements, session.points) == 0
    energy = ffm.deform(points, elements, handles, targets).summary.energy
    assert summary.energy == pytest.approx(energy, rel=1e-3)
    quick = session.move(points[handles], max_iterations=1)
    assert quick.status in ("iteration_limit", "success") and meshes.flips(elements, session.points) == 0
    # A limit holds for one move.
    assert session.move(points[handles], max_iterations=0).iterations == 0
    assert session.move(targets).status == "success"
    with pytest.raises(TypeError):
        session.move(targets, max_iterations=2.7)
    # What fails leaves the shape as it was.
    before = session.points
    with pytest.raises(ffm.Error):
        session.move(np.full_like(targets, np.nan))
    with pytest.raises(ValueError):
        session.move(targets[:-1])
    assert np.array_equal(before, session.points)

    def fail(report):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        session.move(targets, progress=fail)
    assert np.isfinite(session.points).all() and meshes.flips(elements, session.points) == 0
    session.points[:] = 7
    assert not (session.points == 7).all()
    with pytest.raises(ValueError):
        session.handles[0] = 1
    with pytest.raises(ffm.InvalidOption):
        ffm.Deformation(points, elements, [len(points)])
    started = ffm.Deformation(points, elements, handles, start=session.points, method="projected-newton", max_iterations=3)
    assert started.move(targets).preconditioner == "projected_newton"


def test_map_volume():
    points, tetrahedra = meshes.bar(4, 3)
    boundary = ffm.boundary_vertices(tetrahedra)
    inner = np.setdiff1d(np.arange(len(points)), boundary)
    assert np.array_equal(inner, np.flatnonzero(((points > 0) & (points < [4, 3, 3])).all(axis=1)))
    places = points[boundary] * [1, 1 + 0.2, 1] + np.sin(points[boundary][:, [2, 0, 1]]) * 0.2
    result, summary = ffm.map_volume(points, tetrahedra, places)
    assert np.array_equal(result[boundary], places) and meshes.flips(tetrahedra, result) == 0 and summary.flips == 0
    given = points.copy()
    given[inner] = 0
    result, summary = ffm.map_volume(points, tetrahedra, places, boundary=boundary, start=given, energy="symmetric-dirichlet")
    assert np.array_equal(result[boundary], places) and meshes.flips(tetrahedra, result) == 0
    rough = ffm.map_volume(points, tetrahedra, places, start=given, polish=False)
    assert meshes.flips(tetrahedra, rough.points) == 0
    with pytest.raises(ValueError):
        ffm.map_volume(points, tetrahedra, places[:-1])
    with pytest.raises(ffm.InvalidOption):
        ffm.map_volume(points, tetrahedra, places, energy="arap")


def test_morph_volume():
    points, tetrahedra = meshes.bar(4, 3)
    ends = np.flatnonzero((points[:, 0] == 0) | (points[:, 0] == 4))
    places = points[ends] * [1.5, 1, 1]
    slid, summary = ffm.morph_volume(points, tetrahedra, ends, places, slide=True, tolerance=1e-8)
    assert np.array_equal(slid[ends], places) and meshes.flips(tetrahedra, slid) == 0
    assert np.abs(slid - points * [1.5, 1, 1]).max() < 1e-5
    assert summary.quality.min_scaled_jacobian < summary.quality_before.min_scaled_jacobian
    # One end goes sideways, too: the others on the side y = 0 stay there if they slide.
    side = np.flatnonzero((points[:, 1] == 0) & (points[:, 0] > 0) & (points[:, 0] < 4))
    aside = places + np.outer(places[:, 0] > 4, [0, 0.5, 0])
    assert np.abs(ffm.morph_volume(points, tetrahedra, ends, aside, slide=True).points[side, 1]).max() < 1e-12
    free = ffm.morph_volume(points, tetrahedra, ends, aside).points
    assert np.array_equal(free[ends], aside) and np.abs(free[side, 1]).max() > 0.05
    # A second body that nobody moves.
    both = np.vstack([points, points + [10, 0, 0]])
    result = ffm.morph_volume(both, np.vstack([tetrahedra, tetrahedra + len(points)]), ends, places).points
    assert np.abs(result[len(points):] - both[len(points):]).max() < 1e-12
    for arguments in ({"energy": "arap"}, {"slide": True, "polish": False}):
        with pytest.raises(ffm.InvalidOption):
            ffm.morph_volume(points, tetrahedra, ends, places, **arguments)


def test_bad_solids():
    points, tetrahedra = meshes.bar(2, 1)
    flat = points * [1, 1, 0]
    for call, status in (
        (lambda: ffm.deform(flat, tetrahedra, [0], [[0, 0, 0]]), "degenerate_rest_element"),
        (lambda: ffm.deform(points, np.zeros((0, 4), dtype=int), [0], [[0, 0, 0]]), "empty_mesh"),
        (lambda: ffm.deform(points, tetrahedra + 1, [0], [[0, 0, 0]]), "invalid_option"),
        (lambda: ffm.Deformation(points, tetrahedra + 1, [0]), "invalid_option"),
        (lambda: ffm.map_volume(np.full_like(points, np.inf), tetrahedra, points), "non_finite_input"),
    ):
        with pytest.raises(ffm.Error) as error:
            call()
        assert error.value.status == status
