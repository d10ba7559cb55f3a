#!/usr/bin/env python3
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Flattens a scan, a million triangles by default, and tells how far it is. Ctrl-C ends it, a time limit leaves a map.

usage: flatten_scan.py [--cells N] RESULT.obj

The map is looked at in polyscope with --show, if that is installed.
"""

import argparse
import flip_free_maps as ffm
import numpy as np


def scan(cells):
    """A relief with noise: 2 cells^2 triangles over the unit square."""
    x, y = np.meshgrid(np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1))
    waves = ((1, 0.1), (2, 0.4), (3, 0.7), (5, 0.2))
    z = sum(np.sin(2 * np.pi * (k * x + s)) * np.cos(2 * np.pi * (k * y - s)) / (12 * k) for k, s in waves)
    z += np.random.default_rng(1).normal(scale=0.1 / cells, size=z.shape)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    right, above = corner + 1, corner + cells + 1
    faces = np.concatenate([np.stack([corner, right, above + 1], axis=1), np.stack([corner, above + 1, above], axis=1)])
    return np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), faces


def tell(report):
    print(f"\riteration {report.iteration:4}   energy {report.energy:.6f}   {report.seconds:.1f} s", end="", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=707, help="the scan has twice the square of this many triangles")
    parser.add_argument("--time-limit", type=float, help="seconds; the map found by then is valid")
    parser.add_argument("--show", action="store_true")
    parser.add_argument("result")
    arguments = parser.parse_args()

    points, faces = scan(arguments.cells)
    print(f"{len(faces)} triangles")
    uv, summary = ffm.parameterize(points, faces, time_limit=arguments.time_limit, progress=tell)
    print(f"\n{summary}\n{ffm.measure(points, faces, uv)}")
    ffm.export(arguments.result, points, faces, uv)
    if arguments.show:
        import polyscope

        polyscope.init()
        mesh = polyscope.register_surface_mesh("scan", points, faces)
        mesh.add_parameterization_quantity("uv", uv, defined_on="vertices", enabled=True)
        polyscope.show()


if __name__ == "__main__":
    main()
