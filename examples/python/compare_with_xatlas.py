#!/usr/bin/env python3
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Compares parametrize() with that of xatlas on the same meshes: charts, invalid triangles, the part of the texture that is covered.

usage: compare_with_xatlas.py [MESH.obj ...]

Without meshes five are generated. Where xatlas cannot be imported there are the figures of this package only. A triangle is invalid
if it is flipped or has no area in the numbers that are returned, which is computed exactly; whether others overlap is told apart,
and how many charts are mirrored as a whole.
"""

import argparse
import time
from fractions import Fraction

import flatten_scan
import flip_free_maps as ffm
import numpy as np
import texture_mesh

try:
    import xatlas
except ImportError:
    xatlas = None


def turned(radius, height, n, is_closed=False):
    """The surface that a polyline makes which turns around: of a radius, or n of them, and a height for each of its points."""
    radius, height = (np.broadcast_to(np.reshape(a, (len(height), -1)), (len(height), n)) for a in (radius, height))
    angle = 2 * np.pi * np.arange(n) / n
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=-1).reshape(-1, 3)
    levels = len(height) - (0 if is_closed else 1)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(levels), np.arange(n), indexing="ij"))
    a, b, c, d = ((i + k) % len(height) * n + (j + m) % n for k, m in ((0, 0), (0, 1), (1, 1), (1, 0)))
    return points, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def ball(n=48):
    """A ball with bumps, and small holes at its poles."""
    t = np.linspace(0.02, np.pi - 0.02, n)
    points, faces = turned(np.sin(t), -np.cos(t), 2 * n)
    return points * (1 + 0.15 * np.sin(5 * points[:, :1]) * np.cos(6 * points[:, 1:2]) * np.sin(4 * points[:, 2:])), faces


def vase(n=96):
    """A thin vessel, inside and outside."""
    height = np.linspace(0, 3, 40)
    radius = 1 + 0.4 * np.sin(2 * height) + 0.1 * height
    inside = radius[::-1] - 0.08, np.maximum(height, 0.1)[::-1]
    return turned(np.concatenate([[0.02], radius, inside[0], [0.02]]), np.concatenate([[0], height, inside[1], [0.1]]), n)


def gear(teeth=24, parts=4):
    """A toothed wheel with a bore: flat sides and sharp edges."""
    outline = np.tile([1, 1, 1.2, 1.2], teeth)
    share = np.linspace(0, 1, parts + 1)[:, None]
    side = 0.3 + share * (outline - 0.3)
    return turned(np.concatenate([side, side[::-1]]), np.repeat([0, 0.4], parts + 1), len(outline), True)


def read_obj(path):
    points, faces = [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) for word in words[1:]]
                corners = [c - 1 if c > 0 else len(points) + c for c in corners]
                faces += [[corners[0], *pair] for pair in zip(corners[1:-1], corners[2:])]
    return np.array(points), np.array(faces)


def charts_of(faces):
    """The number of each face's chart, which are the parts that are connected by vertices."""
    label = np.arange(faces.max() + 1)
    while True:
        new = label.copy()
        np.minimum.at(new, faces.ravel(), np.repeat(label[faces].min(axis=1), 3))
        new = new[new]
        if (new == label).all():
            return np.unique(label[faces[:, 0]], return_inverse=True)[1]
        label = new


def orientation(triangle):
    """1 for a counterclockwise one, -1 for a clockwise one, 0 for one without area, exactly."""
    (ax, ay), (bx, by), (cx, cy) = ([Fraction(float(x)) for x in p] for p in triangle)
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    return (area > 0) - (area < 0)


def figures(points, faces, parametrize):
    begin = time.process_time()
    _, indices, uvs = parametrize(np.float32(points), np.uint32(faces))
    seconds = time.process_time() - begin
    indices, uvs = np.int64(indices), np.float64(uvs)
    corners = uvs[indices]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = 0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
    signs = np.sign(areas)
    # Rounding is far smaller.
    for t in np.flatnonzero(np.abs(areas) < 1e-14):
        signs[t] = orientation(corners[t])
    chart = charts_of(indices)
    is_mirrored = np.bincount(chart, signs) < 0
    upright = np.where(is_mirrored[chart], -signs, signs)
    turned_back = np.where(is_mirrored[chart][:, None], indices[:, ::-1], indices)
    overlaps = "no" if ffm.is_bijective(turned_back[upright > 0], uvs) else "yes"
    return (f"{len(is_mirrored):7}{(upright <= 0).sum():9}{overlaps:>10}{is_mirrored.sum():10}{100 * np.abs(areas).sum():9.1f} %"
            f"{seconds:9.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="*", metavar="MESH.obj")
    arguments = parser.parse_args()
    meshes = [(path, read_obj(path)) for path in arguments.meshes] or [
        ("knot", texture_mesh.knot()), ("relief", flatten_scan.scan(60)), ("ball", ball()), ("vase", vase()), ("gear", gear())]
    if xatlas is None:
        print("xatlas cannot be imported: no figures of it (pip install xatlas)")
    print(f"{'mesh':24}{'triangles':>10}   {'by':16}{'charts':>7}{'invalid':>9}{'overlaps':>10}{'mirrored':>10}{'covered':>11}{'CPU s':>9}")
    for name, (points, faces) in meshes:
        for by, parametrize in (("flip_free_maps", ffm.parametrize), ("xatlas", xatlas and xatlas.parametrize)):
            if parametrize is not None:
                print(f"{name[-24:]:24}{len(faces):10}   {by:16}{figures(points, faces, parametrize)}", flush=True)


if __name__ == "__main__":
    main()
