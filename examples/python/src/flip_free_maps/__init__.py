# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors
"""Maps of triangle and tetrahedral meshes with low distortion, in which no element is flipped.

    import flip_free_maps as ffm

    vertices, faces, uv, charts, summary = ffm.unwrap(points, triangles)    # a texture atlas of any surface
    uv, summary = ffm.parameterize(points, triangles)                       # a disk, flattened
    moved, summary = ffm.deform(points, tetrahedra, handles, targets)       # a solid, bent

Arrays may have any numeric type and layout and are never written to; results are new arrays. What goes wrong raises an `Error`
with the attributes `status`, `message` and `summary`. While the module computes, other threads run, Ctrl-C ends the function with
`KeyboardInterrupt`, and functions given as `progress` are told how far it is and end it by returning False.

`parametrize`, `Atlas`, `ChartOptions`, `PackOptions` and `export` have the interface of xatlas-python:
`import flip_free_maps as xatlas`.
"""

from . import _errors
from ._core import __version__
from ._errors import Error
from ._functions import (
    Deformation,
    boundary_vertices,
    cut_to_disk,
    deform,
    deform_volume,
    is_bijective,
    map_volume,
    measure,
    minimize,
    morph_volume,
    pack,
    parameterize,
    parameterize_with_seams,
    repair,
    unwrap,
)
from ._results import Cut, Deformed, Map, Packing, Progress, SeamlessMap, Summary, Unwrapping
from ._xatlas import Atlas, ChartOptions, PackOptions, export, parametrize

for _class in _errors.CLASSES.values():
    globals()[_class.__name__] = _class

__all__ = [name for name in dir() if not name.startswith("_")]
