# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Meshes for the tests, and what is known of them."""

from fractions import Fraction

import numpy as np


def sheet(cells=12):
    """A bumpy sheet over the unit square: points and triangles."""
    x, y = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1)))
    z = 0.5 * np.exp(-((x - 0.35) ** 2 + (y - 0.4) ** 2) / 0.15**2) - 0.3 * np.exp(-((x - 0.7) ** 2 + (y - 0.65) ** 2) / 0.12**2)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    lower = np.stack([corner, corner + 1, corner + cells + 2], axis=1)
    upper = np.stack([corner, corner + cells + 2, corner + cells + 1], axis=1)
    return np.stack([x, y, z], axis=1), np.concatenate([lower, upper])


def quads(cells=12):
    """The sheet as quadrangles."""
    points, faces = sheet(cells)
    lower, upper = faces[:cells * cells], faces[cells * cells:]
    return points, np.column_stack([lower, upper[:, 2]])


def sphere(subdivisions=2):
    """An octahedron, subdivided."""
    points = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)]
    points = [np.array(p, dtype=float) for p in points]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(points[a] + points[b])
            return middles[key]

        for a, b, c in faces:
            d, e, f = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, d, f), (d, b, e), (f, e, c), (d, e, f)]
        faces = finer
    array = np.array(points)
    return array / np.linalg.norm(array, axis=1)[:, None], np.array(faces)


def torus(n=16, m=8):
    """A torus of 2 n m triangles."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    s, t = 2 * np.pi * i / n, 2 * np.pi * j / m
    points = np.stack([(2 + np.cos(t)) * np.cos(s), (2 + np.cos(t)) * np.sin(s), np.sin(t)], axis=1)

    def at(a, b):
        return (a % n) * m + b % m

    lower = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], axis=1)
    upper = np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], axis=1)
    return points, np.concatenate([lower, upper])


def bar(n=6, m=2):
    """A bar of n m m cubes, each of six tetrahedra."""
    shape = (n + 1, m + 1, m + 1)
    points = np.stack([a.ravel() for a in np.meshgrid(*(np.arange(s, dtype=float) for s in shape), indexing="ij")], axis=1)
    number = np.arange(len(points)).reshape(shape)
    cells = []
    for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
        steps = [np.zeros(3, dtype=int)]
        for axis in order:
            steps.append(steps[-1] + np.eye(3, dtype=int)[axis])
        corners = [number[s[0]:s[0] + n, s[1]:s[1] + m, s[2]:s[2] + m].ravel() for s in steps]
        is_odd = order in ((0, 2, 1), (2, 1, 0), (1, 0, 2))
        cells.append(np.stack([corners[0], corners[2], corners[1], corners[3]] if is_odd else corners, axis=1))
    return points, np.concatenate(cells)


def _determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** k * rows[0][k] * _determinant([row[:k] + row[k + 1:] for row in rows[1:]]) for k in range(len(rows)))


def flips(elements, x):
    """How many elements have an image that is not positively oriented, in exact arithmetic."""
    exact = [[Fraction(float(c)) for c in row] for row in x]
    count = 0
    for element in elements.tolist():
        origin = exact[element[0]]
        edges = [[a - b for a, b in zip(exact[v], origin)] for v in element[1:]]
        count += _determinant(edges) <= 0
    return count


def areas(x, values, offsets):
    """Twice the oriented areas of planar polygons, in exact arithmetic."""
    exact = [[Fraction(float(c)) for c in row] for row in x]
    result = []
    for first, last in zip(offsets[:-1], offsets[1:]):
        corners = [exact[v] for v in values[first:last]]
        result.append(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1])))
    return result


def is_atlas_of(faces, vertices, atlas_faces):
    """Whether the polygons of an atlas are those of a mesh, corner by corner."""
    return np.array_equal(np.asarray(vertices)[atlas_faces], faces)
