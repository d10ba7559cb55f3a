#!/usr/bin/env python3
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Bends a solid of tetrahedra: one end is held, the other goes around by a half turn, move by move.

usage: bend_solid.py [SOLID] RESULT

SOLID is what meshio reads, whose long axis is the first; without it a bar is generated. RESULT is a .mesh file, or, with meshio,
what that writes, .vtu for example.
"""

import argparse

import flip_free_maps as ffm
import numpy as np

AXES = ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))


def bar(n=24, m=4):
    """n m m cubes, each of six tetrahedra, one for each way along its edges."""
    points = np.stack(np.meshgrid(np.arange(n + 1.0), np.arange(m + 1.0), np.arange(m + 1.0), indexing="ij"), axis=-1)
    number = np.arange(points[..., 0].size).reshape(points.shape[:3])
    tetrahedra = []
    for k, axes in enumerate(AXES):
        steps = np.cumsum([[0, 0, 0]] + [np.eye(3, dtype=int)[axis] for axis in axes], axis=0)
        a, b, c, d = (number[x:x + n, y:y + m, z:z + m].ravel() for x, y, z in steps)
        tetrahedra.append(np.stack([a, b, c, d] if k < 3 else [a, c, b, d], axis=1))
    return points.reshape(-1, 3), np.concatenate(tetrahedra)


def half_turn(points, part):
    """Where the far end goes: along an arc, as a bent bar of this length would."""
    low, high = points.min(axis=0), points.max(axis=0)
    angle = part * np.pi
    radius = (high[0] - low[0]) / max(angle, 1e-9)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    centre = 0.5 * (low + high) * [0, 1, 1] + [high[0], 0, 0]
    end = 0.5 * (low + high) * [0, 1, 1] + [low[0] + radius * np.sin(angle), radius * (1 - np.cos(angle)), 0]
    return lambda p: (p - centre) @ turn.T + end


def write(path, points, tetrahedra):
    if path.endswith(".mesh"):
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(points)}\n")
            file.writelines("%.17g %.17g %.17g 0\n" % tuple(p) for p in points.tolist())
            file.write(f"Tetrahedra\n{len(tetrahedra)}\n")
            file.writelines("%d %d %d %d 0\n" % tuple(t) for t in (tetrahedra + 1).tolist())
            file.write("End\n")
    else:
        import meshio

        meshio.write_points_cells(path, points, [("tetra", tetrahedra)])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("solid", nargs="?")
    parser.add_argument("result")
    parser.add_argument("--cubes", type=int, default=24, help="length of the bar that is generated")
    arguments = parser.parse_args()
    if arguments.solid is None:
        points, tetrahedra = bar(arguments.cubes, max(1, arguments.cubes // 6))
    else:
        import meshio

        solid = meshio.read(arguments.solid)
        points, tetrahedra = solid.points, solid.cells_dict["tetra"]

    length = np.ptp(points[:, 0])
    held = points[:, 0] < points[:, 0].min() + 1e-6 * length
    led = points[:, 0] > points[:, 0].max() - 1e-6 * length
    handles = np.flatnonzero(held | led)
    session = ffm.Deformation(points, tetrahedra, handles)
    for part in np.linspace(0.125, 1, 8):
        targets = points[handles].copy()
        targets[led[handles]] = half_turn(points, part)(targets[led[handles]])
        summary = session.move(targets)
        print(f"{180 * part:5.1f} degrees: {summary.status}, energy {summary.energy:.4f}, {summary.iterations} iterations")
    write(arguments.result, session.points, tetrahedra)


if __name__ == "__main__":
    main()
