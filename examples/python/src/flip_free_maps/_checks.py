# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Arguments as arrays of the types that the compiled part takes; without a copy where they are that already."""

import operator

import numpy as np

from . import _core
from ._errors import InvalidOption, NotTriangular

NAMES = _core.names()
# The splitting scheme is what repair() and map_volume() use anyway.
NAMES["method"] = [name for name in NAMES["method"] if not name.startswith("splitting")]


def _shape(array):
    return "(" + ", ".join(map(str, array.shape)) + ("," if array.ndim == 1 else "") + ")"


def numbers(values, columns, name):
    """Floating-point numbers of shape (n, columns); `columns` may be a tuple of numbers that will do."""
    array = np.asarray(values)
    columns = (columns,) if isinstance(columns, int) else columns
    if array.ndim != 2 or array.shape[1] not in columns:
        wanted = " or ".join(f"(n, {c})" for c in columns)
        raise ValueError(f"{name} must have the shape {wanted}, not {_shape(array)}")
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must be numbers, not {array.dtype}")
    return np.ascontiguousarray(array, dtype=np.float64)


def _integers(array, name):
    if array.size == 0:
        return np.zeros(array.shape, dtype=np.int64)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, not {array.dtype}")
    if array.dtype == np.uint64 and int(array.max()) > np.iinfo(np.int64).max:
        raise InvalidOption(f"{name} has the index {array.max()}, which is out of range")
    return np.ascontiguousarray(array, dtype=np.int64)


def indices(values, columns, name):
    """Indices of shape (n, columns)."""
    array = np.asarray(values)
    if array.shape == (0,):
        array = array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} must have the shape (n, {columns}), not {_shape(array)}")
    return _integers(array, name)


def _polygons(faces, name, wanted):
    """(values, offsets, columns), where columns is the number of corners of each polygon of an array, and None otherwise."""
    if isinstance(faces, tuple) and len(faces) == 2 and all(isinstance(a, np.ndarray) and a.ndim == 1 for a in faces):
        values, offsets = (_integers(a, name) for a in faces)
        if offsets.size == 0 or offsets[0] != 0 or offsets[-1] != values.size or (np.diff(offsets) < 0).any():
            raise ValueError(f"the offsets of {name} must ascend from 0 to the number of values")
        return values, offsets, None
    if not isinstance(faces, np.ndarray) and hasattr(faces, "__len__") and len(faces) > 0:
        try:
            sizes = [len(face) for face in faces]
        except TypeError:
            sizes = [0]
        if min(sizes) != max(sizes):
            values = _integers(np.array([v for face in faces for v in face]), name)
            if values.ndim != 1:
                raise ValueError(f"the polygons of {name} must be sequences of indices")
            return values, np.cumsum([0, *sizes], dtype=np.int64), None
    array = np.asarray(faces)
    if array.shape == (0,):
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] < 3:
        raise ValueError(f"{name} must have the shape {wanted}, not {_shape(array)}")
    array = _integers(array, name)
    return array.reshape(-1), np.arange(len(array) + 1) * array.shape[1], array.shape[1]


def polygons(faces, name="faces"):
    """Polygons from an array of shape (n, k), a list of polygons of any numbers of corners, or a pair (values, offsets) of
    arrays, in which polygon i has the corners values[offsets[i]:offsets[i + 1]].

    Returns the pair, and k, which is None if they are not given as an array, or as what numpy makes one of."""
    return _polygons(faces, name, "(n, k), k at least 3")


def triangles(faces, name="faces"):
    """Triangles from what `polygons` takes."""
    values, offsets, _ = _polygons(faces, name, "(n, 3)")
    sizes = np.diff(offsets)
    if (sizes != 3).any():
        face = int(np.flatnonzero(sizes != 3)[0])
        raise NotTriangular(f"face number {face} has {int(sizes[face])} corners; triangulate the mesh first")
    return values.reshape(-1, 3)


def pairs(values, name):
    """Pairs of indices; none for None."""
    return np.zeros((0, 2), dtype=np.int64) if values is None else indices(values, 2, name)


def vertices(values, number_of_points, name):
    """Numbers of vertices, or a mask over all of them, of shape (k, 1)."""
    array = np.asarray(values)
    if array.ndim != 1:
        raise ValueError(f"{name} must have the shape (k,), not {_shape(array)}")
    if array.dtype == bool:
        if array.size != number_of_points:
            raise ValueError(f"{name} is a mask of {array.size} vertices, but there are {number_of_points} points")
        array = np.flatnonzero(array)
    array = _integers(array, name)
    outside = (array < 0) | (array >= number_of_points)
    if outside.any():
        raise InvalidOption(f"{name} has the vertex {array[outside][0]}, but there are {number_of_points} points")
    return array.reshape(-1, 1)


def choice(argument, value, names=None):
    """One of the names that there are."""
    names = NAMES[argument] if names is None else names
    if value not in names:
        raise InvalidOption(f"{argument} must be one of {', '.join(map(repr, names))}, not {value!r}")
    return value


def method(arguments):
    """The options of a method, out of the local variables of a function that are not None."""
    given = {}
    for argument in ("method", "energy", "preconditioner", "reference", "acceleration", "linear_solver", "criterion"):
        if arguments.get(argument) is not None:
            given[argument] = choice(argument, arguments[argument])
    for argument, least in (("tolerance", 0.0), ("energy_parameter", None), ("time_limit", None)):
        value = arguments.get(argument)
        if value is None:
            continue
        value = float(value)
        if not (value > 0 if least is None else value >= least):
            raise InvalidOption(f"{argument} must be " + ("positive" if least is None else "at least 0") + f", not {value}")
        given[argument] = value
    if arguments.get("max_iterations") is not None:
        given["max_iterations"] = min(operator.index(arguments["max_iterations"]), 2**31 - 1)
    return given


def flags(values, size, name):
    """Flags of shape (size, 1), as integers, of an array of flags or of the numbers of those that are set."""
    result = np.zeros((size, 1), dtype=np.int64)
    if values is None:
        return result
    array = np.asarray(values)
    if array.ndim != 1 or (array.dtype == bool and len(array) != size):
        raise ValueError(f"{name} must be numbers of faces, or flags of the shape ({size},), not {_shape(array)}")
    if array.dtype != bool:
        array = _integers(array, name)
        if array.size > 0 and (array.min() < 0 or array.max() >= size):
            raise InvalidOption(f"{name} must be numbers of the {size} faces, from 0")
    result[array] = 1
    return result


def chosen(arguments, *names):
    """Those of the named local variables of a function that are not None."""
    return {name: arguments[name] for name in names if arguments[name] is not None}
