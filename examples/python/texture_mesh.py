#!/usr/bin/env python3
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""From a mesh to a textured GLB file, as viewers and game engines read it.

usage: texture_mesh.py [MESH] RESULT.glb

MESH is what trimesh reads; without it, or without trimesh, a knot is generated.
"""

import argparse
import json
import struct
import zlib

import flip_free_maps as ffm
import numpy as np


def knot(n=240, m=16):
    """A trefoil knot: a closed tube of 2 n m triangles."""
    t = 2 * np.pi * np.arange(n) / n
    curve = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1)
    tangent = np.roll(curve, -1, axis=0) - np.roll(curve, 1, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    normal = np.cross(tangent, curve - [0, 0, 10])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    binormal = np.cross(tangent, normal)
    angle = (2 * np.pi * np.arange(m) / m)[None, :, None]
    points = curve[:, None] + 0.4 * (np.cos(angle) * normal[:, None] + np.sin(angle) * binormal[:, None])
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a, b, c, d = (((i + k) % n) * m + (j + l) % m for k, l in ((0, 0), (0, 1), (1, 1), (1, 0)))
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def checkerboard(size=512, cells=32):
    """A PNG file."""
    x, y = np.meshgrid(np.arange(size), np.arange(size))
    is_dark = ((x * cells // size) + (y * cells // size)) % 2 == 0
    pixels = np.where(is_dark[..., None], np.uint8([70, 100, 160]), np.uint8([240, 235, 220])).astype(np.uint8)
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def write_glb(path, points, faces, uv, png):
    """Writes a mesh whose vertices have a point and a texture coordinate each, with its texture."""
    # The first row of a texture is at v = 0 there.
    arrays = [np.float32(points), np.float32(np.stack([uv[:, 0], 1 - uv[:, 1]], axis=1)), np.uint32(faces).ravel()]
    blobs = [array.tobytes() for array in arrays] + [png]
    views, data = [], b""
    for blob in blobs:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(blob)})
        data += blob + b"\0" * (-len(blob) % 4)
    types = (("VEC3", 5126), ("VEC2", 5126), ("SCALAR", 5125))
    accessors = [
        {"bufferView": k, "componentType": number, "count": len(array), "type": kind}
        for k, ((kind, number), array) in enumerate(zip(types, arrays))
    ]
    accessors[0]["min"], accessors[0]["max"] = arrays[0].min(axis=0).tolist(), arrays[0].max(axis=0).tolist()
    scene = {
        "asset": {"version": "2.0", "generator": "flip_free_maps"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(data), b"BIN\0") + data)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="?")
    parser.add_argument("result")
    parser.add_argument("--resolution", type=int, default=1024, help="pixels of the texture's side, for the distance of charts")
    arguments = parser.parse_args()
    if arguments.mesh is None:
        points, faces = knot()
    else:
        import trimesh

        mesh = trimesh.load(arguments.mesh, force="mesh")
        points, faces = mesh.vertices, mesh.faces

    atlas = ffm.unwrap(points, faces, resolution=arguments.resolution, padding=4, dtype=np.float32)
    print(atlas.summary)
    write_glb(arguments.result, points[atlas.vertices], atlas.faces, atlas.uv, checkerboard())


if __name__ == "__main__":
    main()
