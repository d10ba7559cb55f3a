# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal, NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

__version__: str

_Floats = NDArray[np.float64]
_Indices = NDArray[np.int64]
_Faces = ArrayLike | list[list[int]] | tuple[NDArray[Any], NDArray[Any]]
_Progress = Callable[[Progress], bool | None]

class Error(RuntimeError):
    status: str
    message: str
    summary: Summary | None
    def __init__(self, message: str, summary: Summary | None = ...) -> None: ...

class EmptyMesh(Error): ...
class NotTriangular(Error): ...
class NoBorder(Error): ...
class SeveralComponents(Error): ...
class NotADisk(Error): ...
class NonManifold(Error): ...
class DegenerateRestElement(Error): ...
class NonFiniteInput(Error): ...
class StartNotFlipFree(Error): ...
class UnreachableConstraints(Error): ...
class LinearSolverFailed(Error): ...
class LineSearchFailed(Error): ...
class ResultNotRepresentable(Error): ...
class InvalidOption(Error, ValueError): ...
class FileError(Error): ...
class OutOfMemory(Error, MemoryError): ...
class NotPlanar(Error): ...
class FlipsRemain(Error): ...
class NotBijective(Error): ...
class Interrupted(Error): ...

class Progress:
    iteration: int
    seconds: float
    energy: float
    gradient_norm: float
    characteristic_gradient_norm: float
    step: float
    factorizations: int
    flips: int
    primal_error: float
    dual_error: float
    phase: Literal["cut", "flatten", "pack"]
    charts_done: int
    charts: int
    faces_done: int
    faces: int

class Summary:
    status: str
    message: str
    def __init__(self, fields: dict[str, Any], shown: list[str] = ..., text: str = ...) -> None: ...
    def to_dict(self) -> dict[str, Any]: ...
    def __getattr__(self, name: str) -> Any: ...

class _LayoutFields(NamedTuple):
    uv: _Floats
    summary: Summary

class _Layout(_LayoutFields):
    faces: _Indices | None

class Map(_Layout): ...
class Packing(_Layout): ...

class Unwrapping(NamedTuple):
    vertices: _Indices
    faces: Any  # _Indices, or a pair (values, offsets) of them, as the faces were given
    uv: NDArray[Any]
    charts: _Indices
    summary: Summary
    @property
    def corners(self) -> NDArray[Any]: ...

class Cut(NamedTuple):
    seams: _Indices
    vertices: _Indices
    faces: _Indices
    summary: Summary

class SeamlessMap(NamedTuple):
    vertices: _Indices
    faces: _Indices
    uv: _Floats
    summary: Summary

class Deformed(NamedTuple):
    points: _Floats
    summary: Summary

def unwrap(
    points: ArrayLike,
    faces: _Faces,
    *,
    max_distortion: float | None = ...,
    seams: ArrayLike | None = ...,
    features: ArrayLike | None = ...,
    pack: bool | None = ...,
    margin: float | None = ...,
    resolution: int | None = ...,
    padding: float | None = ...,
    rotate: bool | None = ...,
    branches: str | None = ...,
    target_energy: float | None = ...,
    number_of_points: int | None = ...,
    max_rounds: int | None = ...,
    join_borders: bool | None = ...,
    cut_disks: bool | None = ...,
    feature_cost: float | None = ...,
    crease_preference: float | None = ...,
    max_stretch: float | None = ...,
    seam_angle: float | None = ...,
    crease_angle: float | None = ...,
    max_length: float | None = ...,
    min_occupancy: float | None = ...,
    strict: bool | None = ...,
    pinned: ArrayLike | None = ...,
    uv: ArrayLike | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    dtype: DTypeLike = ...,
    progress: _Progress | None = ...,
) -> Unwrapping: ...
def parameterize(
    points: ArrayLike,
    faces: _Faces,
    *,
    method: str = ...,
    energy: str = ...,
    energy_parameter: float | None = ...,
    preconditioner: str | None = ...,
    reference: str | None = ...,
    acceleration: str | None = ...,
    linear_solver: str | None = ...,
    start: str | ArrayLike = ...,
    border: str | ArrayLike = ...,
    weights: str | None = ...,
    fixed: ArrayLike | None = ...,
    fix_border: bool = ...,
    soft: tuple[ArrayLike, ArrayLike, ArrayLike] | None = ...,
    bijective: bool = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Map: ...
def repair(
    points: ArrayLike,
    faces: _Faces,
    uv: ArrayLike,
    *,
    polish: bool = ...,
    fix_border: bool = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Map: ...
def measure(points: ArrayLike, faces: _Faces, uv: ArrayLike) -> Summary: ...
@overload
def is_bijective(faces: _Faces, uv: ArrayLike, *, explain: Literal[False] = ...) -> bool: ...
@overload
def is_bijective(faces: _Faces, uv: ArrayLike, *, explain: Literal[True]) -> tuple[bool, str]: ...
def pack(
    faces: _Faces,
    uv: ArrayLike,
    *,
    pinned: ArrayLike | None = ...,
    margin: float | None = ...,
    resolution: int | None = ...,
    padding: float | None = ...,
    rotate: bool | None = ...,
) -> Packing: ...
def cut_to_disk(
    points: ArrayLike,
    faces: _Faces,
    *,
    seams: ArrayLike | None = ...,
    branches: str | None = ...,
    target_energy: float | None = ...,
    number_of_points: int | None = ...,
    max_rounds: int | None = ...,
    join_borders: bool | None = ...,
    cut_disks: bool | None = ...,
    feature_cost: float | None = ...,
    crease_preference: float | None = ...,
) -> Cut: ...
def parameterize_with_seams(
    points: ArrayLike,
    faces: _Faces,
    seams: ArrayLike,
    *,
    similar: bool = ...,
    seam_tolerance: float | None = ...,
    cone_curvature: float | None = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> SeamlessMap: ...
def deform(
    points: ArrayLike,
    elements: _Faces,
    handles: ArrayLike,
    targets: ArrayLike,
    *,
    start: ArrayLike | None = ...,
    soft_weight: float | None = ...,
    method: str | None = ...,
    energy: str | None = ...,
    energy_parameter: float | None = ...,
    preconditioner: str | None = ...,
    reference: str | None = ...,
    acceleration: str | None = ...,
    linear_solver: str | None = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Deformed: ...
def deform_volume(
    points: ArrayLike, tetrahedra: ArrayLike, handles: ArrayLike, targets: ArrayLike, **options: Any
) -> Deformed: ...

class Deformation:
    handles: _Indices
    def __init__(
        self,
        points: ArrayLike,
        elements: _Faces,
        handles: ArrayLike,
        *,
        start: ArrayLike | None = ...,
        method: str | None = ...,
        energy: str | None = ...,
        energy_parameter: float | None = ...,
        preconditioner: str | None = ...,
        reference: str | None = ...,
        acceleration: str | None = ...,
        linear_solver: str | None = ...,
        criterion: str | None = ...,
        tolerance: float | None = ...,
        max_iterations: int | None = ...,
        time_limit: float | None = ...,
    ) -> None: ...
    def move(
        self,
        targets: ArrayLike,
        *,
        criterion: str | None = ...,
        tolerance: float | None = ...,
        max_iterations: int | None = ...,
        time_limit: float | None = ...,
        progress: _Progress | None = ...,
    ) -> Summary: ...
    @property
    def points(self) -> _Floats: ...

def boundary_vertices(tetrahedra: ArrayLike) -> _Indices: ...
def map_volume(
    points: ArrayLike,
    tetrahedra: ArrayLike,
    places: ArrayLike,
    *,
    boundary: ArrayLike | None = ...,
    start: ArrayLike | None = ...,
    energy: str = ...,
    polish: bool = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Deformed: ...

def morph_volume(
    points: ArrayLike,
    tetrahedra: ArrayLike,
    vertices: ArrayLike,
    places: ArrayLike,
    *,
    slide: bool = ...,
    energy: str = ...,
    polish: bool = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Deformed: ...

def minimize(
    points: ArrayLike,
    elements: _Faces,
    rest: ArrayLike,
    *,
    energy: str | Callable[[_Floats, bool], Any] = ...,
    term: Callable[[_Floats, bool], Any] | None = ...,
    stencils: Sequence[ArrayLike] | None = ...,
    fixed: ArrayLike | None = ...,
    method: str | None = ...,
    energy_parameter: float | None = ...,
    preconditioner: str | None = ...,
    reference: str | None = ...,
    acceleration: str | None = ...,
    linear_solver: str | None = ...,
    criterion: str | None = ...,
    tolerance: float | None = ...,
    max_iterations: int | None = ...,
    time_limit: float | None = ...,
    progress: _Progress | None = ...,
) -> Deformed: ...

_Mesh = tuple[NDArray[np.uint32], NDArray[np.uint32], NDArray[np.float32]]

class ChartOptions:
    max_chart_area: float
    max_boundary_length: float
    normal_deviation_weight: float
    roundness_weight: float
    straightness_weight: float
    normal_seam_weight: float
    texture_seam_weight: float
    max_cost: float
    max_iterations: int
    use_input_mesh_uvs: bool
    fix_winding: bool
    max_distortion: float
    def __init__(self) -> None: ...

class PackOptions:
    max_chart_size: int
    padding: int
    texels_per_unit: float
    resolution: int
    bilinear: bool
    blockAlign: bool
    bruteForce: bool
    create_image: bool
    rotate_charts_to_axis: bool
    rotate_charts: bool
    def __init__(self) -> None: ...

class Atlas:
    def __init__(self) -> None: ...
    def add_mesh(
        self, positions: ArrayLike, indices: ArrayLike, normals: ArrayLike | None = ..., uvs: ArrayLike | None = ...
    ) -> None: ...
    def add_uv_mesh(self, uvs: ArrayLike, indices: ArrayLike) -> None: ...
    def generate(
        self, chart_options: ChartOptions | None = ..., pack_options: PackOptions | None = ..., verbose: bool = ...
    ) -> None: ...
    def get_mesh(self, index: int) -> _Mesh: ...
    def __getitem__(self, index: int) -> _Mesh: ...
    def __len__(self) -> int: ...
    @property
    def mesh_count(self) -> int: ...
    @property
    def atlas_count(self) -> int: ...
    @property
    def chart_count(self) -> int: ...
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def texels_per_unit(self) -> float: ...
    @property
    def utilization(self) -> float: ...
    @property
    def chart_image(self) -> NDArray[np.uint8]: ...

def parametrize(
    positions: ArrayLike, indices: ArrayLike, normals: ArrayLike | None = ..., uvs: ArrayLike | None = ...
) -> _Mesh: ...
def export(
    path: str | PathLike[str],
    positions: ArrayLike,
    indices: ArrayLike | None = ...,
    uvs: ArrayLike | None = ...,
    normals: ArrayLike | None = ...,
) -> None: ...
