# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Arrays of all kinds as arguments, and arrays as results."""

import math

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest


def layouts(array):
    """The same numbers in other types and layouts."""
    yield array.astype(array.dtype.newbyteorder())
    yield np.asfortranarray(array)
    wide = np.zeros((2 * len(array), array.shape[1] + 3), dtype=array.dtype)
    wide[::2, 2:-1] = array
    yield wide[::2, 2:-1]
    yield np.flip(np.flip(array).copy())
    read_only = array.copy()
    read_only.setflags(write=False)
    yield read_only
    yield array.tolist()


def calls():
    """A call of each function, with points or elements in its place."""
    points, faces = meshes.sheet(4)
    atlas = ffm.unwrap(points, faces)
    solid, tetrahedra = meshes.bar(2, 1)
    flat = points[:, :2]
    moved = flat * 1.25
    yield "unwrap", points, faces, lambda p, f: ffm.unwrap(p, f)[:4]
    yield "polygons", *meshes.quads(4), lambda p, f: ffm.unwrap(p, f)[:4]
    yield "parameterize", points, faces, lambda p, f: ffm.parameterize(p, f)[:1]
    yield "repair", points, faces, lambda p, f: ffm.repair(p, f, moved)[:1]
    yield "measure", points, faces, lambda p, f: [ffm.measure(p, f, flat).energy]
    yield "is_bijective", flat, faces, lambda p, f: [ffm.is_bijective(f, p)]
    yield "pack", atlas.uv, atlas.faces, lambda p, f: ffm.pack(f, p)[:1]
    yield "cut_to_disk", *meshes.sphere(1), lambda p, f: ffm.cut_to_disk(p, f)[:3]
    yield "deform", flat, faces, lambda p, f: ffm.deform(p, f, [0, 24], [[0, 0], [1.5, 1]])[:1]
    yield "solid", solid, tetrahedra, lambda p, f: ffm.deform(p, f, [0, 11], [[0, 0, 0], [2, 1, 1.25]])[:1]
    yield "map_volume", solid, tetrahedra, lambda p, f: ffm.map_volume(p, f, 1.25 * solid)[:1]
    yield "boundary_vertices", solid, tetrahedra, lambda p, f: [ffm.boundary_vertices(f)]
    yield "parametrize", points, faces, lambda p, f: ffm.parametrize(p, f)


@pytest.mark.parametrize("name, points, elements, call", list(calls()), ids=[entry[0] for entry in calls()])
def test_layouts(name, points, elements, call):
    expected = call(points, elements)
    for given in layouts(points):
        before = np.array(given)
        for result, array in zip(call(given, elements), expected):
            assert np.array_equal(result, array)
        assert np.array_equal(given, before)
    for given in layouts(elements):
        for result, array in zip(call(points, given), expected):
            assert np.array_equal(result, array)
    for dtype in (np.int32, np.uint8, np.uint32, np.uint64):
        for result, array in zip(call(points, elements.astype(dtype)), expected):
            assert np.array_equal(result, array)
    single = points.astype(np.float32)
    for result, array in zip(call(single, elements), call(single.astype(float), elements)):
        assert np.array_equal(result, array)


@pytest.mark.parametrize("name, points, elements, call", list(calls()), ids=[entry[0] for entry in calls()])
def test_results_are_owned(name, points, elements, call):
    for result in call(points, elements):
        if isinstance(result, np.ndarray):
            assert result.flags.writeable and result.flags.c_contiguous
            assert not np.shares_memory(result, points) and not np.shares_memory(result, elements)


def test_integers_are_points_too():
    points, faces = meshes.sheet(4)
    whole = (np.round(100 * points)).astype(np.int16)
    assert np.array_equal(ffm.parameterize(whole, faces).uv, ffm.parameterize(whole.astype(float), faces).uv)


def test_wrong_shapes_and_types():
    points, faces = meshes.sheet(4)
    for bad in (points[:, :2], points.ravel(), points[None], 3.0, np.zeros((3, 4))):
        with pytest.raises(ValueError, match="points must have the shape"):
            ffm.unwrap(bad, faces)
    for bad in (points.astype(complex), points.astype(str), points.astype(bool), points.astype(object)):
        with pytest.raises(TypeError, match="points must be numbers"):
            ffm.unwrap(bad, faces)
    for bad in (faces.ravel(), faces[:, :2], faces[None], 3):
        with pytest.raises(ValueError, match="faces must have the shape"):
            ffm.unwrap(points, bad)
    for bad in (faces.astype(float), faces.astype(bool), faces.astype(object)):
        with pytest.raises(TypeError, match="faces must be integers"):
            ffm.unwrap(points, bad)
    for bad in (2**63, 2**64 - 1):
        with pytest.raises(ffm.InvalidOption, match=str(bad)):
            ffm.unwrap(points, np.array([[0, 1, bad]], dtype=np.uint64))
    with pytest.raises(ffm.InvalidOption, match="25"):
        ffm.unwrap(points, faces + 1)
    with pytest.raises(TypeError):
        ffm.unwrap(points, faces, magin=0.1)
    with pytest.raises(TypeError, match="margin"):
        ffm.unwrap(points, faces, margin="wide")
    with pytest.raises(TypeError):
        ffm.parameterize(points, faces, progress=3)
    with pytest.raises(ValueError):
        ffm.unwrap(points, faces, margin=math.nan)


def test_polygons_that_are_triangles():
    points, faces = meshes.sheet(4)
    expected = ffm.unwrap(points, faces)
    offsets = np.arange(0, 3 * len(faces) + 1, 3)
    for given in ((faces.ravel(), offsets), (faces.ravel().astype(np.uint32), offsets.astype(np.int32))):
        atlas = ffm.unwrap(points, given)
        assert np.array_equal(atlas.uv, expected.uv) and np.array_equal(atlas.faces[0].reshape(-1, 3), expected.faces)
        assert np.array_equal(atlas.faces[1], offsets) and not np.shares_memory(atlas.faces[1], given[1])
        assert ffm.is_bijective(atlas.faces, atlas.uv)
    for given in (faces.tolist(), [tuple(face) for face in faces.tolist()], tuple(map(tuple, faces.tolist())), list(faces)):
        atlas = ffm.unwrap(points, given)
        assert np.array_equal(atlas.uv, expected.uv) and np.array_equal(atlas.faces, expected.faces)
    # Two triangles in a tuple are no pair of values and offsets.
    assert ffm.unwrap(points, ([0, 1, 6], [0, 6, 5])).faces.shape == (2, 3)


def test_polygons_of_several_sizes():
    points, _ = meshes.sheet(4)
    mixed = [[0, 1, 6], [0, 6, 5], [1, 2, 7, 6], [2, 3, 9, 8, 7]]
    values, offsets = np.concatenate(mixed), np.array([0, 3, 6, 10, 15])
    expected = ffm.unwrap(points, (values, offsets))
    for given in (mixed, tuple(map(tuple, mixed)), [np.array(face, dtype=np.uint16) for face in mixed],
                  (values.astype(np.uint64), offsets.astype(np.uint8))):
        atlas = ffm.unwrap(points, given)
        assert np.array_equal(atlas.uv, expected.uv) and np.array_equal(atlas.charts, expected.charts)
        assert all(np.array_equal(a, b) and a.dtype == np.int64 for a, b in zip(atlas.faces, expected.faces))
        assert np.array_equal(atlas.vertices[atlas.faces[0]], values) and np.array_equal(atlas.faces[1], offsets)
        assert atlas.corners.shape == (15, 2)
    for bad, kind in (([[0, 1, 6], [0, 1.5, 6, 5]], TypeError), ([[0, 1, 6], ["a", "b"]], TypeError),
                      ([[0, 1, 6], [0, 6, 5, 25]], ffm.InvalidOption), ([[0, 1, 6], [0, 6, 5, -1]], ffm.InvalidOption)):
        with pytest.raises(kind):
            ffm.unwrap(points, bad)
    for bad in ([0, 3], [1, 3, 6, 10], [0, 6, 3, 15], []):
        with pytest.raises(ValueError, match="offsets"):
            ffm.unwrap(points, (values, np.array(bad, dtype=int)))


def test_other_polygons_are_refused():
    points, _ = meshes.sheet(4)
    mixed = [[0, 1, 6], [0, 6, 5], [1, 2, 7, 6]]
    flat = np.concatenate(mixed)
    for given in (mixed, (flat, np.array([0, 3, 6, 10]))):
        with pytest.raises(ffm.NotTriangular, match="face number 2 has 4 corners") as error:
            ffm.parameterize(points, given)
        assert error.value.status == "not_triangular"
    for given in (np.array([[0, 1, 6, 5]]), [[0, 1, 6, 5]], (np.array([0, 1, 6, 5]), np.array([0, 4]))):
        with pytest.raises(ffm.NotTriangular, match="face number 0 has 4 corners"):
            ffm.parameterize(points, given)
    for offsets in ([0, 3], [1, 3, 6, 10], [0, 6, 3, 10], []):
        with pytest.raises(ValueError, match="offsets"):
            ffm.parameterize(points, (flat, np.array(offsets, dtype=int)))


def test_not_a_number():
    points, faces = meshes.sheet(4)
    solid, tetrahedra = meshes.bar(2, 1)
    for value in (np.nan, np.inf):
        bad, flat, inside = points.copy(), points[:, :2].copy(), solid.copy()
        bad[7, 1] = flat[7, 1] = inside[3, 2] = value
        for call in (
            lambda: ffm.unwrap(bad, faces),
            lambda: ffm.parametrize(bad, faces),
            lambda: ffm.parameterize(bad, faces),
            lambda: ffm.repair(points, faces, flat),
            lambda: ffm.measure(bad, faces, points[:, :2]),
            lambda: ffm.measure(points, faces, flat),
            lambda: ffm.pack(faces, flat),
            lambda: ffm.cut_to_disk(bad, faces),
            lambda: ffm.parameterize_with_seams(bad, faces, [[0, 1]]),
            lambda: ffm.deform(flat, faces, [0], [[0, 0]]),
            lambda: ffm.deform(points[:, :2], faces, [0], [[0, value]]),
            lambda: ffm.Deformation(flat, faces, [0]),
            lambda: ffm.deform(inside, tetrahedra, [0], [[0, 0, 0]]),
            lambda: ffm.map_volume(inside, tetrahedra, solid),
        ):
            with pytest.raises(ffm.Error) as error:
                call()
            assert error.value.status in ("non_finite_input", "start_not_flip_free", "invalid_option"), error.value
        answer, message = ffm.is_bijective(faces, flat, explain=True)
        assert answer is False and message
        with pytest.raises(ffm.Error):
            ffm.map_volume(solid, tetrahedra, inside)


def test_docstrings():
    for name in ffm.__all__:
        thing = getattr(ffm, name)
        if callable(thing):
            assert thing.__doc__ and thing.__doc__.strip().endswith((".", ")", "]", "`", ":")), name
