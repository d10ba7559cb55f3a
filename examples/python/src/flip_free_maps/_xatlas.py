# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors
"""The interface of xatlas-python, by the methods of this package."""

import math
import warnings

import numpy as np

from . import _core
from ._errors import InvalidOption
from ._functions import unwrap
from ._results import finished


def _positions(array, columns, name, rows=None):
    """Numbers of shape (n, columns), with the messages that users of xatlas know."""
    array = np.asarray(array)
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{name} array expected to be Nx{columns}.")
    if rows is not None and array.shape[0] != rows:
        raise ValueError(f"{name} has invalid number of elements in the first dimension (expected {rows}, got {array.shape[0]})")
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} array expected to be of numbers, not of {array.dtype}.")
    return np.ascontiguousarray(array, dtype=np.float64)


def _triangles(indices, number_of_vertices):
    array = np.asarray(indices)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError("Index array expected to be Nx3.")
    if array.dtype.kind == "f" and array.size > 0 and np.isfinite(array).all() and (array == np.floor(array)).all():
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"Index array expected to be of integers, not of {array.dtype}.")
    if array.size > 0 and (int(array.min()) < 0 or int(array.max()) >= number_of_vertices):
        raise InvalidOption(f"an index is out of range: there are {number_of_vertices} vertices")
    return np.ascontiguousarray(array, dtype=np.int64)


class _Options:
    """Attributes with defaults; others cannot be set, so that a wrong spelling is found."""

    _defaults = {}

    def __init__(self):
        self.__dict__.update(self._defaults)

    def __setattr__(self, name, value):
        if name not in self._defaults:
            raise AttributeError(f"{type(self).__name__} has no attribute {name!r}")
        object.__setattr__(self, name, value)

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self.__dict__.items())})"

    def _refuse(self, *names):
        """Raises if something is asked for that cannot be had."""
        for name in names:
            if getattr(self, name) != self._defaults[name]:
                raise InvalidOption(f"{type(self).__name__}.{name} = {getattr(self, name)!r} cannot be had")

    def _ignore(self, *names):
        """Warns if something is asked for that makes no difference."""
        for name in names:
            if getattr(self, name) != self._defaults[name]:
                warnings.warn(f"{type(self).__name__}.{name} has no effect", stacklevel=4)


class ChartOptions(_Options):
    """How the surface is split into charts.

    max_distortion : float, 1.025
        Not one of xatlas: charts are cut until their mean symmetric Dirichlet energy is at most this; an isometry has 1.
    fix_winding : bool
        Triangles are counterclockwise in any case.
    use_input_mesh_uvs, max_chart_area, max_boundary_length
        Other values than False and 0 raise an exception: charts are not limited in these ways.
    normal_deviation_weight, roundness_weight, straightness_weight, normal_seam_weight, texture_seam_weight, max_cost,
    max_iterations
        Weights of a method to grow charts that is not used here: other values than the defaults give a warning. A
        `normal_seam_weight` above 1000, which asks xatlas for all seams of the normals, raises an exception.
    """

    _defaults = {
        "max_chart_area": 0.0,
        "max_boundary_length": 0.0,
        "normal_deviation_weight": 2.0,
        "roundness_weight": 0.01,
        "straightness_weight": 6.0,
        "normal_seam_weight": 4.0,
        "texture_seam_weight": 0.5,
        "max_cost": 2.0,
        "max_iterations": 1,
        "use_input_mesh_uvs": False,
        "fix_winding": False,
        "max_distortion": 1.025,
    }

    def _given(self):
        self._refuse("max_chart_area", "max_boundary_length", "use_input_mesh_uvs")
        if self.normal_seam_weight > 1000:
            self._refuse("normal_seam_weight")
        self._ignore("normal_deviation_weight", "roundness_weight", "straightness_weight", "normal_seam_weight",
                     "texture_seam_weight", "max_cost", "max_iterations")
        return {"max_distortion": float(self.max_distortion)}


class PackOptions(_Options):
    """How charts are laid into the texture, which is a square.

    padding : int, 0
        Pixels between charts; `bilinear` (True) adds the two that bilinear filtering reads.
    resolution : int, 0
        Side of the texture in pixels; 0: 1024, or what `texels_per_unit` asks for.
    texels_per_unit : float, 0
        Pixels per unit of length of the positions, at least; 0: as many as the resolution allows. With a resolution, which
        would take several textures, it raises an exception.
    rotate_charts_to_axis : bool, True
        Whether charts are turned to where they fit best, not by quarters only.
    bruteForce : bool
        The packing is the same in any case.
    rotate_charts : bool, True
        False gives a warning: charts are turned by quarters.
    max_chart_size, blockAlign, create_image
        Other values than 0 and False raise an exception.
    """

    _defaults = {
        "max_chart_size": 0,
        "padding": 0,
        "texels_per_unit": 0.0,
        "resolution": 0,
        "bilinear": True,
        "blockAlign": False,
        "bruteForce": False,
        "create_image": False,
        "rotate_charts_to_axis": True,
        "rotate_charts": True,
    }

    def _given(self):
        self._refuse("max_chart_size", "blockAlign", "create_image")
        self._ignore("rotate_charts")
        if self.texels_per_unit > 0 and self.resolution > 0:
            raise InvalidOption("PackOptions.texels_per_unit with a resolution may take several textures, which cannot be had")
        # Charts that touch would overlap when they are rounded.
        distance = max(float(self.padding) + (2 if self.bilinear else 0), 1 / 64)
        return {"resolution": int(self.resolution) or 1024, "padding": distance, "rotate": bool(self.rotate_charts_to_axis)}


class Atlas:
    """Texture coordinates of several meshes in one texture.

    Vertices at exactly the same position are one: they may differ in their normals, for example, without a seam between them.
    Triangles may be without area, occur twice, differ in their windings, and meet at an edge in any number, see `unwrap`.
    """

    def __init__(self):
        self._meshes = []
        self._charts = False  # whether the meshes have texture coordinates, that is, are only packed
        self._results = None
        self._clear()

    def _clear(self):
        self._results = None
        self._width = self._number_of_charts = 0
        self._texels_per_unit = self._utilization = 0.0

    def add_mesh(self, positions, indices, normals=None, uvs=None):
        """Adds a mesh: positions (N, 3), indices (F, 3). Normals (N, 3) and uvs (N, 2) are not used."""
        p = _positions(positions, 3, "Position")
        t = np.asarray(indices)
        if t.ndim != 2 or t.shape[1] != 3:
            raise ValueError("Index array expected to be Nx3.")
        if normals is not None:
            _positions(normals, 3, "Normal", len(p))
        if uvs is not None:
            _positions(uvs, 2, "Texture coordinate", len(p))
        self._add(p, _triangles(t, len(p)), False)

    def add_uv_mesh(self, uvs, indices):
        """Adds a mesh whose charts, by texture coordinates (N, 2) and indices (F, 3), are only packed."""
        p = _positions(uvs, 2, "Texture coordinate")
        self._add(p, _triangles(indices, len(p)), True)

    def _add(self, positions, triangles, are_charts):
        if self._meshes and self._charts != are_charts:
            raise RuntimeError("an atlas is either of meshes or of meshes with texture coordinates")
        self._charts = are_charts
        self._meshes.append((positions, triangles))
        self._clear()

    def generate(self, chart_options=None, pack_options=None, verbose=False):
        """Makes charts and packs them, with `ChartOptions` and `PackOptions`."""
        given = (ChartOptions() if chart_options is None else chart_options)._given()
        pack_options = PackOptions() if pack_options is None else pack_options
        given.update(pack_options._given())
        self._clear()
        if not self._meshes:
            return
        first_points = np.cumsum([0] + [len(p) for p, _ in self._meshes])
        points = np.concatenate([p for p, _ in self._meshes])
        triangles = np.concatenate([t + first for (_, t), first in zip(self._meshes, first_points)])
        texels = float(pack_options.texels_per_unit)
        if self._charts:
            vertices, faces = np.arange(len(points)), triangles
            uv, scale = self._pack(faces, points, given, texels)
        else:
            # Single precision is for what is final.
            vertices, faces, uv, charts, summary = unwrap(points, triangles, **given, pack=texels == 0,
                                                          dtype=np.float32 if texels == 0 else np.float64)
            self._number_of_charts = len(summary.charts)
            scale, self._utilization, self._width = summary.scale, summary.occupancy, given["resolution"]
            if texels > 0:
                # Charts lie side by side: the same image is the same place. Faces that are in no chart have images of others.
                images, numbers = np.unique(uv, axis=0, return_inverse=True)
                numbers = numbers.reshape(-1)
                packed, scale = self._pack(numbers[faces[charts >= 0]], images, given, texels)
                uv = packed[numbers]
        self._texels_per_unit = scale * self._width
        self._results = self._split(vertices, faces, uv, first_points)
        if verbose:
            print(f"{self.chart_count} charts, {self.width} x {self.height} pixels, {100 * self.utilization:.1f} % used")

    def _pack(self, faces, images, given, texels):
        """Packs; the texture is as large as `texels` for each unit of length demand, if that is not 0."""
        for _ in range(8):
            chosen = {name: given[name] for name in ("resolution", "padding", "rotate")}
            uv, account = _core.pack(faces, images, np.zeros((len(faces), 1), np.int64), chosen, True)
            summary = finished(account)
            self._number_of_charts, self._utilization, self._width = summary.charts, summary.occupancy, given["resolution"]
            # Wider textures have narrower margins in parts of their side, so that this ends soon.
            wanted = math.ceil(texels / summary.scale)
            if texels == 0 or wanted == given["resolution"]:
                break
            given = {**given, "resolution": wanted}
        return uv, summary.scale

    def _split(self, vertices, faces, uv, first_points):
        results, first_face, first_vertex = [], 0, 0
        for (_, triangles), first_point in zip(self._meshes, first_points):
            part = faces[first_face:first_face + len(triangles)]
            last_vertex = int(part.max()) + 1 if part.size else first_vertex
            if self._charts:
                last_vertex = first_vertex + len(self._meshes[len(results)][0])
            results.append(((vertices[first_vertex:last_vertex] - first_point).astype(np.uint32),
                            (part - first_vertex).astype(np.uint32), uv[first_vertex:last_vertex].copy()))
            first_face += len(triangles)
            first_vertex = last_vertex
        return results

    def get_mesh(self, index):
        """(vmapping, indices, uvs) of the mesh with this number: uint32 (K,), the vertex of the mesh that each new vertex is a
        copy of; uint32 (F, 3), the triangles of new vertices; float32 (K, 2), their texture coordinates in the unit square."""
        if not 0 <= index < len(self._meshes):
            raise IndexError(f"Mesh index {index} out of bounds for atlas with {len(self._meshes)} meshes.")
        if self._results is None:
            raise RuntimeError("the atlas has not been generated yet")
        return tuple(array.copy() for array in self._results[index])

    def __getitem__(self, index):
        return self.get_mesh(index)

    def __len__(self):
        return len(self._meshes)

    @property
    def mesh_count(self):
        """Number of meshes."""
        return len(self._meshes)

    @property
    def atlas_count(self):
        """Number of textures: 1, or 0 before `generate`."""
        return 0 if self._results is None else 1

    @property
    def chart_count(self):
        """Number of charts."""
        return self._number_of_charts

    @property
    def width(self):
        """Width of the texture in pixels."""
        return self._width

    @property
    def height(self):
        """Height of the texture in pixels."""
        return self._width

    @property
    def texels_per_unit(self):
        """Pixels per unit of length."""
        return self._texels_per_unit

    @property
    def utilization(self):
        """The part of the texture that is covered, from 0 to 1."""
        return self._utilization

    @property
    def chart_image(self):
        """Raises: no image is drawn."""
        raise RuntimeError("The atlas does not have an image.")


def parametrize(positions, indices, normals=None, uvs=None):
    """Makes texture coordinates for a mesh, with the interface of `xatlas.parametrize`.

    Parameters
    ----------
    positions : (N, 3) array
        The vertices.
    indices : (F, 3) array of integers
        The triangles.
    normals, uvs : (N, 3) and (N, 2) arrays
        Accepted, but not used.

    Returns
    -------
    vmapping : (K,) uint32
        The vertex of the mesh that each new vertex is a copy of: `positions[vmapping]`.
    indices : (F, 3) uint32
        The triangles, in the same order, of new vertices.
    uvs : (K, 2) float32
        Texture coordinates in the unit square. No triangle is flipped, and no two overlap, in these numbers.
    """
    atlas = Atlas()
    atlas.add_mesh(positions, indices, normals, uvs)
    atlas.generate()
    return atlas._results[0]


def export(path, positions, indices=None, uvs=None, normals=None):
    """Writes an OBJ file of vertices (N, 3), triangles (F, 3) of them, texture coordinates (N, 2) and normals (N, 3)."""
    p = _positions(positions, 3, "Position")
    blocks = [("v", p)]
    if normals is not None:
        blocks.append(("vn", _positions(normals, 3, "Normal", len(p))))
    if uvs is not None:
        blocks.append(("vt", _positions(uvs, 2, "Texture coordinates", len(p))))
    corner = "%d" + ("/%d" if uvs is not None else "/" if normals is not None else "") + ("/%d" if normals is not None else "")
    copies = corner.count("%")
    with open(path, "w", encoding="utf-8") as file:
        for word, block in blocks:
            line = word + " %.17g" * block.shape[1] + "\n"
            file.writelines(line % tuple(row) for row in block.tolist())
        if indices is not None:
            t = _triangles(indices, len(p)) + 1
            line = "f " + " ".join([corner] * 3) + "\n"
            file.writelines(line % tuple(row) for row in np.repeat(t, copies, axis=1).tolist())
