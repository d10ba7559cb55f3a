# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""glTF in and out of the program, on files that are made here and compared by a reader of their own.

usage: test_gltf.py PROGRAM [validator]

With `validator`, npm's gltf-validator judges what the program writes; the exit code is 77 where it is not installed. NODE_PATH says
where it is, or it is among npm's global packages.
"""

import base64
import copy
import itertools
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "flip_free_maps"
SIZES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class File:
    """A glTF document and the content of its buffers."""

    def __init__(self, document=None, buffers=None, chunks=b""):
        self.json = document or {"asset": {"version": "2.0"}}
        self.buffers = buffers or [b""]
        self.chunks = chunks

    def view(self, data, **members):
        self.buffers[0] += b"\0" * (-len(self.buffers[0]) % 4)
        views = self.json.setdefault("bufferViews", [])
        views.append({"buffer": 0, "byteOffset": len(self.buffers[0]), "byteLength": len(data), **members})
        self.buffers[0] += data
        return len(views) - 1

    def accessor(self, component, kind, values, **members):
        values = [v if isinstance(v, (tuple, list)) else (v,) for v in values]
        data = b"".join(struct.pack("<%d%s" % (len(v), FORMATS[component]), *v) for v in values)
        return self.add(component, kind, len(values), bufferView=self.view(data), **members)

    def add(self, component, kind, count, **members):
        accessors = self.json.setdefault("accessors", [])
        accessors.append({"componentType": component, "count": count, "type": kind, **members})
        return len(accessors) - 1

    def write(self, path):
        document = copy.deepcopy(self.json)
        if path.endswith(".glb"):
            document["buffers"] = [{"byteLength": len(self.buffers[0])}]
            text = json.dumps(document).encode()
            text += b" " * (-len(text) % 4)
            data = self.buffers[0] + b"\0" * (-len(self.buffers[0]) % 4)
            body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data + self.chunks
            content = struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body
        else:
            name = os.path.splitext(os.path.basename(path))[0] + " data.bin"
            document["buffers"] = [{"byteLength": len(self.buffers[0]), "uri": name.replace(" ", "%20")}]
            with open(os.path.join(os.path.dirname(path), name), "wb") as out:
                out.write(self.buffers[0])
            content = json.dumps(document).encode()
        with open(path, "wb") as out:
            out.write(content)

    @staticmethod
    def read(path):
        with open(path, "rb") as stream:
            content = stream.read()
        chunk, chunks = b"", b""
        if path.endswith(".glb"):
            magic, version, length = struct.unpack("<III", content[:12])
            assert (magic, version, length) == (0x46546C67, 2, len(content))
            begin = 12
            while begin < length:
                size, kind = struct.unpack("<II", content[begin : begin + 8])
                assert size % 4 == 0
                data = content[begin + 8 : begin + 8 + size]
                if kind == 0x4E4F534A:
                    document = json.loads(data)
                elif kind == 0x004E4942:
                    chunk = data
                else:
                    chunks += content[begin : begin + 8] + data
                begin += 8 + size
        else:
            document = json.loads(content)
        buffers = []
        for buffer in document.get("buffers", []):
            uri = buffer.get("uri")
            if uri is None:
                buffers.append(chunk)
            elif uri.startswith("data:"):
                buffers.append(base64.b64decode(uri[uri.index(",") + 1 :], validate=True))
            else:
                with open(os.path.join(os.path.dirname(path), uri.replace("%20", " ")), "rb") as stream:
                    buffers.append(stream.read())
            assert buffer["byteLength"] <= len(buffers[-1]) <= buffer["byteLength"] + 3
        return File(document, buffers, chunks)

    def elements(self, number):
        """The bytes of each element of an accessor."""
        accessor = self.json["accessors"][number]
        size = SIZES[accessor["componentType"]] * PARTS[accessor["type"]]

        def read(user, size, count):
            view = self.json["bufferViews"][user["bufferView"]]
            stride = view.get("byteStride", size)
            begin = view.get("byteOffset", 0) + user.get("byteOffset", 0)
            assert begin % 4 == 0 or "target" not in view
            assert user.get("byteOffset", 0) + (count - 1) * stride + size <= view["byteLength"]
            return [self.buffers[view["buffer"]][begin + i * stride : begin + i * stride + size] for i in range(count)]

        if "bufferView" in accessor:
            result = read(accessor, size, accessor["count"])
        else:
            result = [b"\0" * size] * accessor["count"]
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            kind = sparse["indices"]["componentType"]
            indices = [struct.unpack("<" + FORMATS[kind], b)[0] for b in read(sparse["indices"], SIZES[kind], sparse["count"])]
            assert indices == sorted(set(indices))
            for i, value in zip(indices, read(sparse["values"], size, sparse["count"])):
                result[i] = value
        assert all(len(value) == size for value in result)
        return result

    def values(self, number):
        accessor = self.json["accessors"][number]
        form = "<%d%s" % (PARTS[accessor["type"]], FORMATS[accessor["componentType"]])
        return [struct.unpack(form, element) for element in self.elements(number)]

    def triangles(self, primitive):
        """The vertices of its corners."""
        count = self.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
        indices = [v[0] for v in self.values(primitive["indices"])] if "indices" in primitive else list(range(count))
        mode = primitive.get("mode", 4)
        if mode == 4:
            return [tuple(indices[i : i + 3]) for i in range(0, len(indices), 3)]
        if mode == 5:
            return [(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]) for i in range(len(indices) - 2)]
        return [(indices[i + 1], indices[i + 2], indices[0]) for i in range(len(indices) - 2)] if mode == 6 else []

    def corners(self, primitive, left_out):
        """What each corner has: by semantics, and for each target, but not what is left out."""
        sets = [primitive["attributes"]] + primitive.get("targets", [])
        columns = {(n, name): self.elements(a) for n, s in enumerate(sets) for name, a in s.items() if name not in left_out}
        return [{key: column[v] for key, column in columns.items()} for triangle in self.triangles(primitive) for v in triangle]

    def primitives(self):
        return [p for mesh in self.json["meshes"] for p in mesh["primitives"]]

    def atlas(self, uv_set=0):
        """The images of all triangles, seen as they are in a picture whose axis goes up."""
        result = []
        for primitive in self.primitives():
            if primitive.get("mode", 4) < 4:
                continue
            st = self.values(primitive["attributes"]["TEXCOORD_%d" % uv_set])
            result += [[(Fraction(st[v][0]), 1 - Fraction(st[v][1])) for v in triangle] for triangle in self.triangles(primitive)]
        return result


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def overlap(p, q):
    """Whether two counterclockwise triangles share an inner point: unless a side of one parts them."""
    for one, other in ((p, q), (q, p)):
        for i in range(3):
            if all(cross(one[i], one[(i + 1) % 3], corner) <= 0 for corner in other):
                return False
    return True


CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def cube_indices(sides):
    return [v for a, b, c, d in sides for v in (a, b, c, a, c, d)]


def add_body(file):
    """A cube of shared vertices: interleaved data of all kinds, two primitives, two targets, one of them sparse."""
    stride = 12 + 12 + 4 + 4 + 16 + 4 + 16 + 4
    data = b""
    for i, p in enumerate(CUBE):
        n = [(c - 0.5) * 2 / 3**0.5 for c in p]
        data += struct.pack("<3f3f4B4B4f2H4ff", *[0.1 * c + i * 1e-3 for c in p], *n, 10 * i, 255 - i, 7, 255, i % 2, 1 - i % 2, 0, 0,
                            i / 7, 1 - i / 7, 0, 0, 9000 * i, 65535 - 9000 * i, 1, 0, 0, 1, 1 / (i + 1))
    view = file.view(data, byteStride=stride, target=34962)

    def attribute(offset, component, kind, **members):
        return file.add(component, kind, 8, bufferView=view, byteOffset=offset, **members)

    low, high = [min(c) for c in zip(*file_positions(data, stride))], [max(c) for c in zip(*file_positions(data, stride))]
    attributes = {
        "POSITION": attribute(0, 5126, "VEC3", min=low, max=high, extras={"kept": True}),
        "NORMAL": attribute(12, 5126, "VEC3"),
        "COLOR_0": attribute(24, 5121, "VEC4", normalized=True),
        "JOINTS_0": attribute(28, 5121, "VEC4"),
        "WEIGHTS_0": attribute(32, 5126, "VEC4"),
        "TEXCOORD_0": attribute(48, 5123, "VEC2", normalized=True),
        "TANGENT": attribute(52, 5126, "VEC4"),
        "_CUSTOM": attribute(68, 5126, "SCALAR"),
    }
    moves = [(0, 0, i / 3) for i in range(8)]
    box = dict(min=struct.unpack("<3f", struct.pack("<3f", 0, 0, 0)), max=struct.unpack("<3f", struct.pack("<3f", 0, 0, 7 / 3)))
    dense = {"POSITION": file.accessor(5126, "VEC3", moves, **box), "NORMAL": file.accessor(5126, "VEC3", moves)}
    indices = file.view(struct.pack("<2B", 1, 6))
    values = file.view(struct.pack("<6f", 1, 2, 3, 4, 5, 6))
    sparse = file.add(5126, "VEC3", 8, min=[0, 0, 0], max=[4, 5, 6],
                      sparse={"count": 2, "indices": {"bufferView": indices, "componentType": 5121}, "values": {"bufferView": values}})
    targets = [dense, {"POSITION": sparse}]
    primitives = []
    for material, sides in enumerate((SIDES[:2], SIDES[2:])):
        numbers = file.accessor(5121, "SCALAR", cube_indices(sides))
        primitives.append({"attributes": attributes, "targets": targets, "indices": numbers, "material": material})
    return {"name": "body", "weights": [0.25, 0.5], "primitives": primitives, "extras": {"targetNames": ["a", "b"]}}


def file_positions(data, stride):
    return [struct.unpack("<3f", data[i : i + 12]) for i in range(0, len(data), stride)]


def scene():
    """Three meshes, one of them twice, a skin, an animation, and things that nobody knows."""
    file = File(chunks=struct.pack("<II4s", 4, 0x58585858, b"abcd"))
    file.json.update({
        "extensionsUsed": ["KHR_mesh_quantization", "ACME_unknown"], "extensionsRequired": ["KHR_mesh_quantization"],
        "materials": [{"name": "red"}, {"name": "blue", "normalTexture": {"index": 0}}],
        "textures": [{"source": 0}], "images": [{"uri": "a%20picture.png"}],
        "extensions": {"ACME_unknown": {"z": 1.5, "a": [1, 2.25e-3, None]}}, "extras": {"b": 1, "a": "\u00e9"},
    })
    body = add_body(file)
    # A strip, its end moved by sparse elements.
    strip = [(x, y, 0.5 * (x > 2)) for x in range(5) for y in (1, 0)]
    indices, values = file.view(struct.pack("<H", 9)), file.view(struct.pack("<3f", 4, 0, 2))
    sparse = {"count": 1, "indices": {"bufferView": indices, "componentType": 5123}, "values": {"bufferView": values}}
    lid = {"name": "lid", "primitives": [{
        "attributes": {"POSITION": file.accessor(5126, "VEC3", strip, min=[0, 0, 0], max=[4, 1, 2], sparse=sparse)}, "mode": 5, "material": 0}]}
    # Quantized, with points beside the triangles, and a second primitive that goes round a fan.
    small = [tuple(30000 * c for c in p) for p in CUBE]
    data = b"".join(struct.pack("<3hxx", *p) for p in small)
    positions = file.add(5122, "VEC3", 8, bufferView=file.view(data, byteStride=8, target=34962), normalized=True, min=[0, 0, 0], max=[30000] * 3)
    shade = file.accessor(5126, "VEC2", [(i / 16, 0.5) for i in range(8)])
    fan = file.accessor(5126, "VEC3", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0)], min=[-1, 0, 0], max=[1, 1, 0])
    box = {"name": "box", "primitives": [
        {"attributes": {"POSITION": positions, "TEXCOORD_0": shade}, "indices": file.accessor(5123, "SCALAR", cube_indices(SIDES))},
        {"attributes": {"POSITION": positions}, "mode": 0}, {"attributes": {"POSITION": fan}, "mode": 6}]}
    times = file.accessor(5126, "SCALAR", [0, 1], min=[0], max=[1])
    file.json["meshes"] = [body, lid, box]
    file.json["nodes"] = [
        {"mesh": 0, "skin": 0, "name": "figure"}, {"children": [2], "translation": [1, 0, 0]}, {"rotation": [0, 0, 1, 0]},
        {"mesh": 1, "scale": [2, 2, 2], "name": "first"}, {"mesh": 1, "translation": [0, 0, 9], "scale": [1, -1, 1]}, {"mesh": 2}]
    file.json["scenes"] = [{"nodes": [0, 1, 3, 4, 5]}]
    file.json["scene"] = 0
    unit = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
    file.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": file.accessor(5126, "MAT4", [unit, unit])}]
    file.json["animations"] = [{
        "samplers": [{"input": times, "output": file.accessor(5126, "VEC3", [(1, 0, 0), (1, 2, 0)])},
                     {"input": times, "output": file.accessor(5126, "SCALAR", [0, 1, 1, 0])}],
        "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}, {"sampler": 1, "target": {"node": 0, "path": "weights"}}]}]
    return file


PICTURE = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


class Test(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        with open(self.path("a picture.png"), "wb") as out:
            out.write(PICTURE)

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_program(self, *arguments, code=0):
        result = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        self.assertEqual(result.returncode, code, (arguments, result.stderr.decode(errors="replace")))
        return (result.stdout + result.stderr).decode(errors="replace")

    def check_atlas(self, triangles, is_one=True):
        for triangle in triangles:
            self.assertGreater(cross(*triangle), 0)
            for s, t in triangle:
                self.assertTrue(0 <= s <= 1 and 0 <= t <= 1)
        if is_one:
            for p, q in itertools.combinations(triangles, 2):
                self.assertFalse(overlap(p, q), (p, q))

    def check_kept(self, before, after, uv_set, without=()):
        """All but a set of texture coordinates: of corners bit for bit, of the document its values."""
        left_out = {"TEXCOORD_%d" % uv_set, *without}
        for old, new in zip(before.primitives(), after.primitives()):
            self.assertEqual(before.corners(old, left_out), after.corners(new, left_out))
            self.assertEqual(before.triangles(old) == [], after.triangles(new) == [])
            same = lambda p: {k: v for k, v in p.items() if k not in ("attributes", "targets", "indices", "mode", "material")}
            self.assertEqual(same(old), same(new))
            if "material" in old:
                self.assertEqual(old["material"], new["material"])
        for key in before.json:
            if key in ("accessors", "bufferViews", "buffers", "meshes", "animations", "skins"):
                continue
            kept = after.json[key][: len(before.json[key])] if isinstance(before.json[key], list) else after.json[key]
            self.assertEqual(before.json[key], kept, key)
        for mesh, other in zip(before.json["meshes"], after.json["meshes"]):
            self.assertEqual({**mesh, "primitives": 0}, {**other, "primitives": 0})
        for old, new in zip(before.json["animations"], after.json["animations"]):
            self.assertEqual(old["channels"], new["channels"])
            for p, q in zip(old["samplers"], new["samplers"]):
                self.assertEqual([before.elements(p[k]) for k in ("input", "output")], [after.elements(q[k]) for k in ("input", "output")])
        bind = lambda file: file.elements(file.json["skins"][0]["inverseBindMatrices"])
        self.assertEqual(bind(before), bind(after))

    def check_doubled(self, before, after, uv_set):
        """A vertex is there once for each of its images, and the meshes say so in common."""
        groups = {}
        for old, new in zip(before.primitives(), after.primitives()):
            if before.triangles(old) == []:
                continue
            st = after.elements(new["attributes"]["TEXCOORD_%d" % uv_set])
            images = groups.setdefault(json.dumps(old["attributes"]), (old, new, {}))[2]
            for p, q in zip(before.triangles(old), after.triangles(new)):
                for v, w in zip(p, q):
                    images.setdefault(v, set()).add(st[w])
        for old, new, images in groups.values():
            count = lambda file, primitive: file.json["accessors"][primitive["attributes"]["POSITION"]]["count"]
            self.assertEqual(count(after, new), count(before, old) + sum(len(image) - 1 for image in images.values()))

    def test_everything_stays(self):
        before = scene()
        before.write(self.path("in.glb"))
        text = self.run_program("unwrap", "in.glb", "-o", "out.glb")
        self.assertIn("tangents are dropped", text)
        after = File.read(self.path("out.glb"))
        self.check_kept(before, after, 0, ["TANGENT"])
        self.check_doubled(before, after, 0)
        self.check_atlas(after.atlas())
        self.assertEqual(after.chunks, before.chunks)
        self.assertEqual(list(after.json["extensions"]["ACME_unknown"]), ["z", "a"])
        self.assertNotIn("TANGENT", after.primitives()[0]["attributes"])
        # What is sparse remains so.
        self.assertIn("sparse", after.json["accessors"][after.primitives()[0]["targets"][1]["POSITION"]])
        # The checkerboard is where no material was.
        self.assertEqual([p.get("material") for p in after.primitives()], [0, 1, 0, 2, None, 2])
        self.assertEqual(after.json["materials"][2]["name"], "checkerboard")
        self.assertIn("is bijective", self.run_program("measure", "out.glb"))
        # Twice the size in the scene, twice the size in the atlas.
        lid = File.read(self.path("out.glb")).json["meshes"][1]["primitives"][0]
        st, xyz = after.values(lid["attributes"]["TEXCOORD_0"]), after.values(lid["attributes"]["POSITION"])
        v, w = after.triangles(lid)[0][:2]
        length = lambda p, q: sum((a - b) ** 2 for a, b in zip(p, q)) ** 0.5
        lid_scale = length(st[v], st[w]) / length(xyz[v], xyz[w])
        fan = after.primitives()[5]
        st, xyz = after.values(fan["attributes"]["TEXCOORD_0"]), after.values(fan["attributes"]["POSITION"])
        v, w = after.triangles(fan)[0][:2]
        self.assertAlmostEqual(lid_scale / (length(st[v], st[w]) / length(xyz[v], xyz[w])), 2, places=2)

    def test_second_set(self):
        before = scene()
        before.write(self.path("in.glb"))
        text = self.run_program("unwrap", "in.glb", "-o", "out.glb", "--uv-set", "1", "--checker")
        self.assertNotIn("tangents", text)
        self.assertIn("where there was no TEXCOORD_0", text)
        after = File.read(self.path("out.glb"))
        for primitive in after.primitives():
            primitive.pop("material", None)
        for primitive in before.primitives():
            primitive.pop("material", None)
        for number in (2, 5): # which had none
            after.primitives()[number]["attributes"].pop("TEXCOORD_0")
        self.check_kept(before, after, 1)
        self.check_doubled(before, after, 1)
        self.check_atlas(after.atlas(1))
        material = File.read(self.path("out.glb")).primitives()[0]["material"]
        texture = after.json["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"]
        self.assertEqual(texture["texCoord"], 1)
        self.assertIn("no face has texture coordinates", self.run_program("measure", "in.glb", "--uv-set", "1", code=17))
        self.run_program("measure", "out.glb", "--uv-set", "1")

    def test_text_and_other_folders(self):
        before = scene()
        before.write(self.path("in.gltf"))
        os.mkdir(self.path("sub"))
        self.run_program("unwrap", "in.gltf", "-o", "sub/out.gltf")
        self.run_program("unwrap", "in.gltf", "-o", "sub/out.glb")
        self.run_program("unwrap", "in.gltf", "-o", "in.gltf")
        for name in ("sub/out.gltf", "sub/out.glb", "in.gltf"):
            after = File.read(self.path(name))
            if "sub" in name:
                self.assertEqual(after.json["images"][0]["uri"], "../a%20picture.png")
                after.json["images"][0]["uri"] = "a%20picture.png"
            self.check_kept(before, after, 0, ["TANGENT"])
            self.check_atlas(after.atlas())
        self.run_program("unwrap", "sub/out.glb", "-o", "back.gltf")
        after = File.read(self.path("back.gltf"))
        self.assertEqual(after.json["images"][0]["uri"], "a%20picture.png")
        self.check_kept(before, after, 0, ["TANGENT"])

    def test_files_do_not_grow(self):
        # Extensions that nobody knows might name what looks unused.
        before = scene()
        del before.json["extensions"]
        before.json["extensionsUsed"].pop()
        before.write(self.path("out.glb"))
        for name in ("out.glb", "out.gltf"):
            sizes = []
            for _ in range(3):
                self.run_program("unwrap", "out.glb" if name == "out.gltf" and not sizes else name, "-o", name)
                after = File.read(self.path(name))
                self.check_kept(before, after, 0, ["TANGENT"])
                self.check_atlas(after.atlas())
                sizes.append(sum(map(len, after.buffers)))
            self.assertLess(max(sizes), min(sizes) + 64)
            self.assertNotIn("TANGENT", json.dumps(after.json))
        used = {v for p in after.primitives() for s in [p["attributes"], *p.get("targets", [])] for v in s.values()}
        used |= {p["indices"] for p in after.primitives() if "indices" in p}
        self.assertEqual(len(after.json["accessors"]), len(used) + 4) # of the skin and the animation

    def test_atlases_per_object(self):
        before = scene()
        before.write(self.path("in.glb"))
        self.run_program("unwrap", "in.glb", "-o", "out.glb", "--atlas-per-object")
        after = File.read(self.path("out.glb"))
        self.check_kept(before, after, 0, ["TANGENT"])
        triangles = after.atlas()
        for begin, end in ((0, 12), (12, 20), (20, 35)):
            self.check_atlas(triangles[begin:end])
            self.assertGreater(max(p[0] - q[0] for t in triangles[begin:end] for p in t for u in triangles[begin:end] for q in u), 0.6)

    def test_islands_that_are_there(self):
        before = scene()
        before.write(self.path("in.glb"))
        self.run_program("unwrap", "in.glb", "-o", "one.glb")
        one = File.read(self.path("one.glb"))
        self.run_program("pack", "one.glb", "-o", "two.glb", "--margin", "0.02")
        self.run_program("unwrap", "one.glb", "-o", "three.glb", "--keep-seams")
        for name in ("two.glb", "three.glb"):
            after = File.read(self.path(name))
            self.check_kept(one, after, 0)
            self.check_atlas(after.atlas())
        # The first face's island stays, in the numbers of the file, and directly or by way of an OBJ.
        with open(self.path("pins.txt"), "w") as pins:
            pins.write("0\n")
        for way in ([("one.glb", "pinned.glb")], [("one.glb", "pinned.obj"), ("pinned.obj", "pinned.glb")]):
            for source, target in way:
                self.run_program("unwrap", source, "-o", target, "--pinned", "pins.txt", "--json", "pinned.json")
            after = File.read(self.path("pinned.glb")).atlas()
            self.check_atlas(after)
            with open(self.path("pinned.json")) as stream:
                pinned = json.load(stream)["pinned_faces"]
            self.assertTrue(0 < pinned < len(after))
            self.assertEqual(sum(sorted(t) == sorted(u) for t, u in zip(after, one.atlas())), pinned)
        # Nothing is flipped: not a bit changes.
        self.run_program("repair", "one.glb", "-o", "four.glb")
        self.assertEqual(File.read(self.path("four.glb")).atlas(), one.atlas())
        # A triangle turned over.
        flipped = File(one.json, one.buffers, one.chunks)
        lid = flipped.primitives()[2]
        accessor = flipped.json["accessors"][lid["attributes"]["TEXCOORD_0"]]
        begin = flipped.json["bufferViews"][accessor["bufferView"]]["byteOffset"] + accessor.get("byteOffset", 0)
        vertex = flipped.triangles(lid)[0][2]
        a, b, c = (flipped.values(lid["attributes"]["TEXCOORD_0"])[v] for v in flipped.triangles(lid)[0])
        begin += 8 * vertex
        moved = struct.pack("<2f", *[3 * (a[i] + b[i]) / 2 - 2 * c[i] for i in range(2)])
        flipped.buffers[0] = flipped.buffers[0][:begin] + moved + flipped.buffers[0][begin + 8 :]
        flipped.write(self.path("flipped.glb"))
        self.run_program("measure", "flipped.glb", code=11)
        self.run_program("repair", "flipped.glb", "-o", "repaired.glb")
        self.run_program("measure", "repaired.glb")

    def test_other_formats(self):
        with open(self.path("in.obj"), "w") as out:
            out.write("o left one\n" + "".join("v %g %g %g\n" % p for p in CUBE) + "".join("f %d %d %d %d\n" % tuple(v + 1 for v in s) for s in SIDES))
            out.write("o right\nv 5 0 0\nv 6 0 0\nv 6 1 1\nf 9 10 11\n")
        self.run_program("unwrap", "in.obj", "-o", "out.glb")
        after = File.read(self.path("out.glb"))
        self.assertEqual([mesh["name"] for mesh in after.json["meshes"]], ["left one", "right"])
        self.check_atlas(after.atlas())
        self.assertEqual(len(after.atlas()), 13)
        self.run_program("unwrap", "in.obj", "-o", "apart.obj", "--atlas-per-object")
        self.run_program("measure", "apart.obj")
        scene().write(self.path("in.glb"))
        self.run_program("unwrap", "in.glb", "-o", "out.obj")
        with open(self.path("out.obj")) as stream:
            lines = [line.split() for line in stream]
        # The strip is there twice, once mirrored: its faces still look the same way.
        self.assertEqual([line[1] for line in lines if line[0] == "o"], ["figure", "first", "lid", "box"])
        self.assertEqual(sum(line[0] == "f" for line in lines), 12 + 8 + 8 + 15)
        points = [tuple(float(x) for x in line[1:4]) for line in lines if line[0] == "v"]
        faces = [[points[int(corner.split("/")[0]) - 1] for corner in line[1:]] for line in lines if line[0] == "f"]
        self.assertIn((8, 0, 4), faces[19] + faces[18])
        normal = lambda face: cross(*[p[:2] for p in face])
        self.assertGreater(normal(faces[12]) * normal(faces[20]), 0)
        self.run_program("unwrap", "in.glb", "--repair", "-o", "repaired.glb", code=16)

    def test_refused(self):
        def variant(change):
            file = scene()
            change(file.json)
            return file

        def position(json_, **members):
            json_["accessors"][json_["meshes"][0]["primitives"][0]["attributes"]["POSITION"]].update(members)

        body = scene()
        body.buffers[0] = struct.pack("<f", float("nan")) + body.buffers[0][4:]
        many = scene()
        positions = many.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"]
        indices = many.accessor(5121, "SCALAR", [0] * 3000)
        many.json["meshes"] = [{"primitives": [{"attributes": {"POSITION": positions}, "indices": indices}] * 1000}] * 3
        primitive = lambda json_: json_["meshes"][0]["primitives"][1]
        draco = {"extensions": {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}}}
        meshopt = {"extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteLength": 1, "byteStride": 1, "count": 1, "mode": "TRIANGLES"}}}
        cases = [
            (body, "primitive number 0 of mesh number 0 (from 0): the position of vertex 0"),
            (variant(lambda j: primitive(j).update(draco)), "primitive number 1 of mesh number 0 (from 0) is compressed by KHR_draco"),
            (variant(lambda j: j["bufferViews"][0].update(meshopt)), "compressed by EXT_meshopt_compression"),
            (variant(lambda j: position(j, count=9)), "leaves its buffer view"),
            (variant(lambda j: position(j, count=2**50)), "leaves its buffer view"),
            (variant(lambda j: position(j, bufferView=99)), "number 99 (from 0) of the bufferViews"),
            (variant(lambda j: position(j, count=-1)), "no natural number"),
            (variant(lambda j: position(j, type="VEC2")), "no vectors with three numbers"),
            (variant(lambda j: primitive(j).update(indices=0)), "indices that are no natural numbers"),
            (variant(lambda j: primitive(j).update(mode=7)), "unknown mode"),
            (variant(lambda j: j["nodes"][2].update(children=[1])), "their own descendants"),
            (variant(lambda j: j["nodes"][5].update(mesh=7)), "number 7 (from 0) of the meshes"),
            (variant(lambda j: j["asset"].update(version="1.0")), "version '1.0'"),
            (many, "so often"),
        ]
        for number, (file, words) in enumerate(cases):
            file.write(self.path("bad.glb"))
            text = self.run_program("unwrap", "bad.glb", "-o", "never.glb", code=10 if file is body else 17)
            self.assertIn(words, text, number)
            self.assertFalse(os.path.exists(self.path("never.glb")), number)
        contents = [
            (b"glTF", "bytes"), (struct.pack("<III", 0x46546C67, 1, 12), "version 1"), (struct.pack("<III", 0x46546C67, 2, 12), "no chunk"),
            (struct.pack("<IIIII", 0x46546C67, 2, 20, 99, 0x4E4F534A), "claims 99 bytes"), (b"[" * 100000, "nested"), (b"{]", "parse error"),
            (b'{"asset": {"version": "2.0"}}', "no faces"), (b"{" + b'"a":0,' * 20000 + b'"b":0}', "keys"), (b'"' * 99, "parse error"),
            (b'{"asset": {"version": "2.0"}, "buffers": 3}', "no array"), (b"", "")]
        for content, words in contents:
            with open(self.path("bad.gltf"), "wb") as out:
                out.write(content)
            result = subprocess.run([PROGRAM, "unwrap", "bad.gltf"], stderr=subprocess.PIPE, cwd=self.folder)
            self.assertGreater(result.returncode, 2)
            self.assertIn(words, result.stderr.decode())
        self.run_program("unwrap", "bad.gltf", "-o", "x.ply", "--checker", code=2)
        self.run_program("unwrap", "bad.obj", "-o", "x.obj", "--uv-set", "1", code=2)


JUDGE = """
const fs = require('fs'), path = require('path');
const validator = require('gltf-validator');
(async () => {
  for (const file of process.argv.slice(1)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
      uri: file, maxIssues: 0,
      externalResourceFunction: uri => fs.promises.readFile(path.join(path.dirname(file), decodeURIComponent(uri))).then(b => new Uint8Array(b)),
    });
    console.log(JSON.stringify({file, errors: report.issues.messages.filter(m => m.severity === 0)}));
  }
})().catch(error => { console.error(error); process.exit(1); });
"""


def judged(environment, *files):
    result = subprocess.run(["node", "-e", JUDGE, *files], stdout=subprocess.PIPE, check=True, env=environment)
    return [json.loads(line)["errors"] for line in result.stdout.decode().splitlines()]


class Validator(Test):
    """The same files, judged by others: errors that the input has not are the program's."""

    def runTest(self):
        scene().write(self.path("in.glb"))
        with open(self.path("in.obj"), "w") as out:
            out.write("".join("v %g %g %g\n" % p for p in CUBE) + "".join("f %d %d %d %d\n" % tuple(v + 1 for v in s) for s in SIDES))
        calls = [("in.glb", "a.glb"), ("in.glb", "b.glb", "--uv-set", "1", "--checker"), ("in.glb", "c.gltf", "--atlas-per-object"),
                 ("in.obj", "d.glb"), ("in.obj", "e.gltf", "--no-pack", "--uv-set", "2"), ("c.gltf", "f.glb")]
        for call in calls:
            self.run_program("unwrap", call[0], "-o", *call[1:])
        files = [self.path(name) for name in ("in.glb", *[call[1] for call in calls])]
        for file, errors in zip(files, judged(ENVIRONMENT, *files)):
            self.assertEqual(errors, [], file)


def find_validator():
    environment = dict(os.environ)
    if shutil.which("node") is None:
        return None
    if shutil.which("npm") is not None and "NODE_PATH" not in environment:
        environment["NODE_PATH"] = subprocess.run(["npm", "root", "-g"], stdout=subprocess.PIPE).stdout.decode().strip()
    found = subprocess.run(["node", "-e", "require('gltf-validator')"], stderr=subprocess.DEVNULL, env=environment).returncode == 0
    return environment if found else None


if __name__ == "__main__":
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Test)
    if sys.argv[2:] == ["validator"]:
        ENVIRONMENT = find_validator()
        if ENVIRONMENT is None:
            print("Skipped: node, or npm's package gltf-validator, is not installed.")
            sys.exit(77)
        suite = unittest.TestSuite([Validator()])
    sys.exit(not unittest.TextTestRunner().run(suite).wasSuccessful())
