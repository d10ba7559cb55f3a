# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors
"""The functions of the module."""

import threading

import numpy as np

from . import _checks, _core
from ._results import Cut, Deformed, Map, Packing, SeamlessMap, Unwrapping, finished, watched

BRANCHES = ("none", "extremities", "curvature-peaks", "farthest-points")
_PACKING = ("margin", "resolution", "padding", "rotate")
_CUTTING = ("branches", "target_energy", "number_of_points", "max_rounds", "join_borders", "cut_disks", "feature_cost",
            "crease_preference")


def _cut_options(arguments):
    if arguments["branches"] is not None:
        _checks.choice("branches", arguments["branches"], BRANCHES)
    return _checks.chosen(arguments, *_CUTTING)


def unwrap(points, faces, *, max_distortion=None, seams=None, features=None, pack=None, margin=None, resolution=None,
           padding=None, rotate=None, branches=None, target_energy=None, number_of_points=None, max_rounds=None, join_borders=None,
           cut_disks=None, feature_cost=None, crease_preference=None, max_stretch=None, seam_angle=None, crease_angle=None,
           max_length=None, min_occupancy=None, strict=None, pinned=None, uv=None, tolerance=None, max_iterations=None, time_limit=None,
           dtype=np.float64, progress=None):
    """Makes a texture atlas of any mesh of polygons: cuts it open, flattens the pieces, packs them into the unit square.

    No polygon is flipped and no two polygons overlap, by exact predicates on the numbers that are returned.

    Parameters
    ----------
    points : (n, 3) array
        The points of the surface, in any unit of length.
    faces : (f, 3) array of integers
        Triangles, counterclockwise seen from outside; also polygons, convex or not, as an array (f, k), a list of polygons of
        any numbers of corners, or a pair of arrays (values, offsets), of which polygon i has values[offsets[i]:offsets[i + 1]].
        The surface may be closed or have holes, of any genus and any number of components. Points at exactly the same place
        are one as far as it matters which faces are neighbours. Where more than two faces have an edge, or faces of different
        windings, they are kept apart by seams; faces that occur twice have two images; faces without area have thin ones.
        `summary.parted_edges` counts such edges, `summary.faces_without_area` such faces.
    max_distortion : float, default 1.025
        Charts are cut until their mean symmetric Dirichlet energy is at most this; an isometry has 1. `math.inf`: only the
        topology asks for seams.
    seams, features : (s, 2) arrays of integers
        Edges, as pairs of points, that are cut; edges that seams prefer.
    pack : bool, default True
        Whether charts are packed; they lie side by side, in the units of the points, otherwise.
    margin : float, default 1/512
        Least distance between two charts, in parts of the square's side.
    resolution, padding : int, float
        Side of the texture in pixels and, in its place, the least distance in pixels (default 2).
    rotate : bool, default True
        Whether charts are turned to where they fit best, not by quarters only.
    branches : {"extremities", "none", "curvature-peaks", "farthest-points"}
        What seams reach beside what the topology asks for, with `number_of_points` and `target_energy` (default 1.2), see
        `cut_to_disk`.
    max_rounds, join_borders, cut_disks, feature_cost, crease_preference
        See `cut_to_disk`.
    max_stretch : float, default infinity
        At least 95 % of the area of each chart are stretched or compressed by at most this factor.
    seam_angle : float, default infinity
        Edges across which the surface turns by so many radians or more are seams.
    crease_angle : float, default 0.5
        Radians by which the surface turns across a crease.
    max_length : float, default 1.2
        Long charts beyond this, in sides of a square of the surface's area, are split.
    min_occupancy : float, default 0.65
        While less than this part of the square is covered, charts that leave much of it empty are split, if the seams are short.
    strict : bool, default False
        Whether surfaces are refused that are no triangle meshes whose faces have an area and are joined by their indices to a
        manifold.
    pinned : array
        Faces that keep the images they have, as numbers or as one flag each. All others are packed around them.
    uv : array
        With `pinned`: an image for each corner of all faces, as `Unwrapping.corners` has them. Only those of pinned ones are read.
    tolerance, max_iterations
        When the flattening of a chart ends, see `parameterize`.
    time_limit : float
        Seconds after which nothing is improved any more; the atlas is as valid as any other.
    dtype : numpy.float64 or numpy.float32
        The type of `uv`, in which the atlas is certified.
    progress : function
        Called now and then, by the thread that called `unwrap`, with an object that has the attributes `phase`, which is "cut",
        "flatten" or "pack", `charts_done`, `charts`, `faces_done`, `faces` and `seconds`. When it returns False, the rest is
        done as if the time were up; what it raises is raised here.

    Returns
    -------
    Unwrapping
        (vertices, faces, uv, charts, summary): faces are an array of the shape of the given one, or a pair (values, offsets) if
        they were given as such or as a list of polygons of different sizes.

    Raises
    ------
    Error
        `EmptyMesh`, `NonFiniteInput`, `DegenerateRestElement` if no face has corners at three different places,
        `InvalidOption` and others; `NotTriangular`, `NonManifold` and `DegenerateRestElement` if it is to be strict.
    """
    p = _checks.numbers(points, 3, "points")
    values, offsets, columns = _checks.polygons(faces)
    given = _checks.method(locals())
    given.update(_cut_options(locals()))
    given.update(_checks.chosen(locals(), "pack", *_PACKING, "max_distortion", "max_stretch", "seam_angle", "crease_angle",
                                 "max_length", "min_occupancy", "strict"))
    dtype = np.dtype(dtype)
    if dtype not in (np.float64, np.float32):
        raise TypeError(f"dtype must be float64 or float32, not {dtype}")
    flags = _checks.flags(pinned, len(offsets) - 1, "pinned")
    if flags.any() and uv is None:
        raise TypeError("pinned faces need uv, the images of all corners")
    images = np.zeros((0, 2)) if not flags.any() else _checks.numbers(np.asarray(uv).reshape(-1, 2), 2, "uv")
    if len(images) not in (0, len(values)):
        raise ValueError(f"uv must have an image for each of the {len(values)} corners, not {len(images)}")
    vertices, corners, uv, charts, account = _core.unwrap(p, values.reshape(-1, 1), offsets.reshape(-1, 1),
                                                          _checks.pairs(seams, "seams"), _checks.pairs(features, "features"),
                                                          flags, images, given, bool(dtype == np.float32), watched(progress))
    summary = finished(account)
    result = (corners, offsets.copy()) if columns is None else corners.reshape(-1, columns)
    return Unwrapping(vertices, result, uv, charts, summary)


def parameterize(points, faces, *, method="default", energy="symmetric-dirichlet", energy_parameter=None, preconditioner=None,
                 reference=None, acceleration=None, linear_solver=None, start="auto", border="circle", weights=None, fixed=None,
                 fix_border=False, soft=None, bijective=False, criterion=None, tolerance=None, max_iterations=None,
                 time_limit=None, progress=None):
    """Flattens a surface patch, a disk that may have holes, with as little distortion as possible and no flipped triangle.

    Parameters
    ----------
    points : (n, 3) array
        The points of the surface.
    faces : (f, 3) array of integers
        Triangles, in any of the forms that `unwrap` takes. Of several components, that of the longest border is flattened.
    method : str
        "default", or a method of the literature: "slim", "cm", "akvf", "pp", "aqp", "newton", ...; "slim+" and so on
        with this package's line search
    energy : str
        What is minimised: "symmetric-dirichlet", "arap", "conformal", "amips", ...; `energy_parameter` is the factor of
        exponential ones.
    preconditioner, reference, acceleration, linear_solver : str
        Parts that differ from those of the method, by the names that the program `flip_free_maps` has for them.
    start : "auto", "tutte", "multilevel" or (n, 2) array
        How the start is made, or the map to begin with, without flips, in the units of the points.
    border : "circle", "square", "triangle", "octagon" or (m, 2) array
        The shape of the start's border; an array is a convex polygon, counterclockwise.
    weights : "uniform", "mean-value" or "cotangent"
        Weights of the start.
    fixed : (k,) array of integers, or (n,) array of bool
        Vertices that keep their places in the start.
    fix_border : bool
        Whether all vertices on borders do.
    soft : tuple (vertices, places, weights)
        Vertices (k,) that are pulled to places (k, 2), with a weight, or weights (k,): each adds weight |u - place|^2 to the
        mean energy, with lengths in units of the square root of the surface's area.
    bijective : bool
        Whether the image must not overlap itself.
    criterion : "characteristic", "gradient" or "energy"
        The rule that `tolerance` is for: the characteristic norm of the gradient (1e-5 by default), its norm, or the
        relative change of the energy.
    max_iterations : int, default 5000
    time_limit : float
        Seconds; the map found by then is valid.
    progress : function
        Called before the first and after each iteration with an object that has the attributes `iteration`, `seconds`,
        `energy`, `gradient_norm`, `characteristic_gradient_norm`, `step`, `factorizations` and `flips`. When it returns
        False, the run ends with the map that there is; what it raises is raised here.

    Returns
    -------
    Map
        (uv, summary): uv is an (n, 2) array, in the units of the points.
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.triangles(faces)
    given = _checks.method(locals())
    if isinstance(start, str):
        given["start"] = _checks.choice("start", start, ("auto", "tutte", "multilevel"))
    else:
        given["given_start"] = _as_long_as(_checks.numbers(start, 2, "start"), p, "start")
    if isinstance(border, str):
        given["border"] = _checks.choice("border", border)
    else:
        given["polygon"] = _checks.numbers(border, 2, "border")
    if weights is not None:
        given["weights"] = _checks.choice("weights", weights)
    if fixed is not None:
        given["fixed"] = _checks.vertices(fixed, len(p), "fixed")
    if soft is not None:
        given.update(_soft_positions(soft, len(p)))
    given["fix_border"] = bool(fix_border)
    given["bijective"] = bool(bijective)
    uv, account = _core.parameterize(p, t, given, watched(progress))
    return Map.of(uv, t, finished(account))


def _as_long_as(array, points, name):
    if len(array) != len(points):
        raise ValueError(f"{name} has {len(array)} rows, but there are {len(points)} points")
    return array


def _soft_positions(soft, number_of_points):
    if not isinstance(soft, tuple) or len(soft) != 3:
        raise TypeError("soft must be a tuple (vertices, places, weights)")
    vertices = _checks.vertices(soft[0], number_of_points, "the vertices of soft")
    places = _checks.numbers(soft[1], 2, "the places of soft")
    weights = np.asarray(soft[2], dtype=np.float64)
    if len(places) != len(vertices) or weights.shape not in ((), (len(vertices),)):
        raise ValueError("soft must have as many places and weights as vertices")
    column = np.broadcast_to(weights, (len(vertices),)).reshape(-1, 1)
    wrong = ~(np.isfinite(places).all(axis=1) & np.isfinite(column[:, 0]) & (column[:, 0] >= 0))
    if wrong.any():
        number = int(np.flatnonzero(wrong)[0])
        raise _checks.InvalidOption(f"soft position number {number}, of vertex {vertices[number, 0]}, is not finite, or its weight is "
                                    "negative or not finite")
    return {"soft_vertices": vertices, "soft_places": np.concatenate([places, column], axis=1)}


def repair(points, faces, uv, *, polish=True, fix_border=False, criterion=None, tolerance=None, max_iterations=None,
           time_limit=None, progress=None):
    """Removes the flipped triangles of a map of a surface patch, and then minimises its distortion.

    Parameters
    ----------
    points, faces
        The surface, as for `parameterize`.
    uv : (n, 2) array
        The map, with any number of flips.
    polish : bool
        Whether the distortion is minimised; some triangles are almost collapsed otherwise.
    fix_border : bool
        Whether vertices on borders keep their places.
    criterion, tolerance, max_iterations, time_limit, progress
        As for `parameterize`; the reports of the first phase also have `primal_error` and `dual_error`.

    Returns
    -------
    Map
        (uv, summary)
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.triangles(faces)
    given = _checks.method(locals())
    given["polish"] = bool(polish)
    given["fix_border"] = bool(fix_border)
    result, account = _core.repair(p, t, _checks.numbers(uv, 2, "uv"), given, watched(progress))
    return Map.of(result, t, finished(account))


def measure(points, faces, uv):
    """Measures a map of a surface: flips, distortions of angles, areas and lengths.

    Parameters
    ----------
    points : (n, 3) array
    faces : (f, 3) array of integers
    uv : (n, 2) array
        The map. Of an atlas: `measure(points[a.vertices], a.faces, a.uv)`.

    Returns
    -------
    Summary
        With the attributes `faces`, `flips`, `rest_area`, `image_area`, `energy` (mean symmetric Dirichlet energy, 1 for an
        isometry, infinite with flips), `energy_of_similarity` (the same after the best scaling), `max_energy`,
        `mean_angle_distortion`, `mean_area_distortion`, `min_singular_value` and `max_singular_value`.
    """
    return finished(_core.measure(_checks.numbers(points, 3, "points"), _checks.triangles(faces), _checks.numbers(uv, 2, "uv")))


def is_bijective(faces, uv, *, explain=False):
    """Whether no triangle is flipped or collapsed and no part of the image covers or touches another, by exact predicates.

    Parameters
    ----------
    faces : (f, 3) array of integers
        Triangles, as indices into `uv`.
    uv : (n, 2) array
    explain : bool
        Whether the answer comes with a sentence that says why not: (answer, sentence).
    """
    answer, message = _core.is_bijective(_checks.triangles(faces), _checks.numbers(uv, 2, "uv"))
    return (answer, message) if explain else answer


def pack(faces, uv, *, pinned=None, margin=None, resolution=None, padding=None, rotate=None):
    """Moves the charts of an atlas into the unit square, apart from each other, all scaled alike.

    Parameters
    ----------
    faces : (f, 3) array of integers
        Triangles, as indices into `uv`. Charts are the parts that are connected.
    uv : (k, 2) array
        Images without flips.
    pinned : array
        Faces, as numbers or as one flag each: their charts stay where they are, flipped or not, and all others are packed around
        them.
    margin, resolution, padding, rotate
        As for `unwrap`.

    Returns
    -------
    Packing
        (uv, summary): the summary has `charts`, `scale`, the factor of lengths, and `occupancy`, the part of the square that
        is covered.
    """
    t = _checks.triangles(faces)
    flags = _checks.flags(pinned, len(t), "pinned")
    result, account = _core.pack(t, _checks.numbers(uv, 2, "uv"), flags, _checks.chosen(locals(), *_PACKING), False)
    return Packing.of(result, t, finished(account))


def cut_to_disk(points, faces, *, seams=None, branches=None, target_energy=None, number_of_points=None, max_rounds=None,
                join_borders=None, cut_disks=None, feature_cost=None, crease_preference=None):
    """Cuts a surface of any genus open, so that each piece is a disk: what `parameterize` needs.

    Parameters
    ----------
    points : (n, 3) array
    faces : (f, 3) array of integers
    seams : (s, 2) array of integers
        Edges, as pairs of points, that are cut in any case.
    branches : {"extremities", "none", "curvature-peaks", "farthest-points"}
        What seams reach beside what the topology asks for.
    target_energy : float, default 1.2
        "extremities": seams are added until a map of this mean symmetric Dirichlet energy is expected.
    number_of_points : int
        "farthest-points": how many; otherwise at most so many, with 0 for no limit.
    max_rounds : int, default 0
        "extremities": how many times distorted places are sought and reached, with 0 for no limit.
    join_borders : bool, default True
        Whether borders are joined, so that pieces have no holes.
    cut_disks : bool, default False
        Whether seams lead into pieces that are disks already, too.
    feature_cost, crease_preference : float
        What a seam costs on a feature, and how much it follows creases.

    Returns
    -------
    Cut
        (seams, vertices, faces, summary): `parameterize(points[cut.vertices], cut.faces)` flattens the (largest) piece.
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.triangles(faces)
    edges, account = _core.cut_to_disk(p, t, _checks.pairs(seams, "seams"), _cut_options(locals()))
    summary = finished(account)
    vertices, cut_faces, account = _core.cut_along(t, len(p), edges)
    finished(account)
    return Cut(edges, vertices, cut_faces, summary)


def parameterize_with_seams(points, faces, seams, *, similar=False, seam_tolerance=None, cone_curvature=None, criterion=None,
                            tolerance=None, max_iterations=None, time_limit=None, progress=None):
    """Flattens a surface that is cut along seams such that the two sides of each seam fit together.

    Parameters
    ----------
    points : (n, 3) array
    faces : (f, 3) array of integers
    seams : (s, 2) array of integers
        The edges to be cut, such that a disk, perhaps with holes, remains; `cut_to_disk` finds some.
    similar : bool
        False: sides are related by a rotation by a multiple of 90 degrees (a seamless map). True: by any rotation and scale.
    seam_tolerance : float, default 1e-8
        Largest error of an edge of a seam, over the length of the seam.
    cone_curvature : float, default 0.5
        Radians by which the angles around a vertex differ from a full turn where a seam ends.
    criterion, tolerance, max_iterations, time_limit, progress
        As for `parameterize`.

    Returns
    -------
    SeamlessMap
        (vertices, faces, uv, summary): the summary also has `residual` and `transformations`, for each seam the (a, b) of
        the matrix [[a, b], [-b, a]] that takes its left side to its right one.
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.triangles(faces)
    given = _checks.method(locals())
    given["similar"] = bool(similar)
    given.update(_checks.chosen(locals(), "seam_tolerance", "cone_curvature"))
    *arrays, account = _core.parameterize_with_seams(p, t, _checks.pairs(seams, "seams"), given, watched(progress))
    summary = finished(account)
    return SeamlessMap(*arrays, summary)


def _elements(elements):
    array = np.asarray(elements)
    if array.ndim == 2 and array.shape[1] == 4:
        return _checks.indices(array, 4, "elements")
    return _checks.triangles(elements, "elements")


def _in_space(points):
    """Planar points in the plane z = 0."""
    return points if points.shape[1] == 3 else np.concatenate([points, np.zeros((len(points), 1))], axis=1)


def _handles(handles, points):
    return _checks.vertices(handles, len(points), "handles")


def _targets(targets, handles, dimension):
    array = _checks.numbers(targets, dimension, "targets")
    if len(array) != len(handles):
        raise ValueError(f"there are {len(handles)} handles, but {len(array)} targets")
    return array


def _planar_result(result, points):
    return result if points.shape[1] == 2 else np.concatenate([result, points[:, 2:]], axis=1)


def deform(points, elements, handles, targets, *, start=None, soft_weight=None, method=None, energy=None, energy_parameter=None,
           preconditioner=None, reference=None, acceleration=None, linear_solver=None, criterion=None, tolerance=None,
           max_iterations=None, time_limit=None, progress=None):
    """Deforms a planar shape or a solid: handles go where they are told, the rest follows with as little distortion as possible.

    No element flips. For handles that move again and again see `Deformation`.

    Parameters
    ----------
    points : (n, 2) or (n, 3) array
        The shape at rest. A planar one in space has the same third coordinate everywhere.
    elements : (f, 3) or (f, 4) array of integers
        Triangles, counterclockwise, or tetrahedra, all of the same orientation.
    handles : (k,) array of integers, or (n,) array of bool
        The vertices that are held.
    targets : (k, 2) array for triangles, (k, 3) array for tetrahedra
        Where they go; of a mask in the order of the points.
    start : array like `targets`, for all points
        The shape to begin with, without flips; by default the one at rest.
    soft_weight : float
        Solids: handles are pulled with this weight instead of being held.
    method, energy, ..., progress
        As for `parameterize`.

    Returns
    -------
    Deformed
        (points, summary): points has as many columns as those that were given.
    """
    t = _elements(elements)
    p = _checks.numbers(points, (2, 3) if t.shape[1] == 3 else 3, "points")
    given = _checks.method(locals())
    h = _handles(handles, p)
    dimension = t.shape[1] - 1
    places = _targets(targets, h, dimension)
    if start is not None:
        given["start"] = _as_long_as(_checks.numbers(start, dimension, "start"), p, "start")
    if dimension == 3:
        given.update(_checks.chosen(locals(), "soft_weight"))
        result, account = _core.deform_volume(p, t, h, places, given, watched(progress))
        return Deformed(result, finished(account))
    if soft_weight is not None:
        raise _checks.InvalidOption("soft_weight is for solids")
    result, account = _core.deform(_in_space(p), t, h, places, given, watched(progress))
    summary = finished(account)
    return Deformed(_planar_result(result, p), summary)


def deform_volume(points, tetrahedra, handles, targets, **options):
    """Deforms a solid of tetrahedra (f, 4); see `deform`, whose options it takes."""
    return deform(points, _checks.indices(tetrahedra, 4, "tetrahedra"), handles, targets, **options)


class Deformation:
    """A shape that is deformed again and again as its handles move: what an interactive program holds.

    Each move begins with the result of the last one, and with its factorization as long as that serves.

    Parameters
    ----------
    points, elements, handles, start
        As for `deform`.
    method, energy, ..., time_limit
        As for `parameterize`; the limits hold for each move.

    Functions of one object may be called from several threads; they take turns.
    """

    def __init__(self, points, elements, handles, *, start=None, method=None, energy=None, energy_parameter=None,
                 preconditioner=None, reference=None, acceleration=None, linear_solver=None, criterion=None, tolerance=None,
                 max_iterations=None, time_limit=None):
        t = _elements(elements)
        p = _checks.numbers(points, (2, 3) if t.shape[1] == 3 else 3, "points")
        given = _checks.method(locals())
        h = _handles(handles, p)
        self._dimension = t.shape[1] - 1
        self._rest = p
        self._given = dict(given)
        self._lock = threading.Lock()
        if start is not None:
            given["start"] = _as_long_as(_checks.numbers(start, self._dimension, "start"), p, "start")
        create = _core.planar_session if self._dimension == 2 else _core.solid_session
        self._session, account = create(_in_space(p), t, h, given)
        finished(account)
        self.handles = h.ravel().copy()
        """(k,) int64: the handles."""
        self.handles.setflags(write=False)

    def move(self, targets, *, criterion=None, tolerance=None, max_iterations=None, time_limit=None, progress=None):
        """Moves the handles to `targets` (k, 2) or (k, 3) and optimises the shape; returns the summary.

        An iteration limit of a few makes a move a quick one that leaves the rest to the next; limits are those of this move. The
        shape stays as it is when a move fails. What `progress` or Ctrl-C raise ends a move with the shape found so far, which has
        no flips.
        """
        given = {**self._given, **_checks.method(locals())}
        places = _targets(targets, self.handles, self._dimension)
        with self._lock:
            account = self._session.move(places, given, watched(progress))
        return finished(account)

    @property
    def points(self):
        """The current shape, a new array like the points that were given."""
        with self._lock:
            result = self._session.points()
        return result if self._dimension == 3 else _planar_result(result, self._rest)


def boundary_vertices(tetrahedra):
    """The vertices on the boundary of a solid, ascending: those of triangles of one tetrahedron only."""
    t = _checks.indices(tetrahedra, 4, "tetrahedra")
    triangles = np.sort(np.concatenate([t[:, [1, 2, 3]], t[:, [0, 2, 3]], t[:, [0, 1, 3]], t[:, [0, 1, 2]]]), axis=1)
    unique, counts = np.unique(triangles, axis=0, return_counts=True)
    return np.unique(unique[counts == 1])


def map_volume(points, tetrahedra, places, *, boundary=None, start=None, energy="symmetric-gradient", polish=True, criterion=None,
               tolerance=None, max_iterations=None, time_limit=None, progress=None):
    """Maps a solid into the image of its boundary: flips of the start are removed, then the distortion is minimised.

    Parameters
    ----------
    points : (n, 3) array
    tetrahedra : (f, 4) array of integers
    places : (k, 3) array
        Where the vertices on the boundary go.
    boundary : (k,) array of integers, or (n,) array of bool
        Which vertices these are; by default `boundary_vertices(tetrahedra)`.
    start : (n, 3) array
        Where the other vertices begin, flips or not; by default each at the mean of its neighbours.
    energy : "symmetric-gradient" or "symmetric-dirichlet"
    polish : bool
        Whether the distortion is minimised; some elements are almost collapsed otherwise.
    criterion, tolerance, max_iterations, time_limit, progress
        As for `repair`.

    Returns
    -------
    Deformed
        (points, summary)
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.indices(tetrahedra, 4, "tetrahedra")
    _checks.choice("energy", energy, ("symmetric-gradient", "symmetric-dirichlet"))
    given = _checks.method(locals())
    given["polish"] = bool(polish)
    held = _checks.vertices(boundary_vertices(t) if boundary is None else boundary, len(p), "boundary")
    if start is not None:
        given["start"] = _as_long_as(_checks.numbers(start, 3, "start"), p, "start")
    result, account = _core.map_volume(p, t, held, _targets(places, held, 3), given, watched(progress))
    return Deformed(result, finished(account))


def morph_volume(points, tetrahedra, vertices, places, *, slide=False, energy="symmetric-gradient", polish=True, criterion=None,
                 tolerance=None, max_iterations=None, time_limit=None, progress=None):
    """Moves some vertices of a solid, usually its boundary or a part of it, and lets the others follow without a flip.

    Parameters
    ----------
    points : (n, 3) array
    tetrahedra : (f, 4) array of integers
        Of one body, or of several: those of which no vertex is given stay at rest.
    vertices : (k,) array of integers, or (n,) array of bool
        Which vertices move.
    places : (k, 3) array
        Where they go.
    slide : bool
        Whether the rest of the boundary slides on its planes and along its straight creases. It is free otherwise.
    energy : "symmetric-gradient", "symmetric-dirichlet" or "exponential-symmetric-dirichlet"
        The last is for the sake of the worst tetrahedra.
    polish : bool
        Whether the distortion is minimised; some elements are almost collapsed otherwise. What slides is always polished.
    criterion, tolerance, max_iterations, time_limit, progress
        As for `repair`.

    Returns
    -------
    Deformed
        (points, summary); `summary.quality_before` and `summary.quality` have the scaled Jacobians.
    """
    p = _checks.numbers(points, 3, "points")
    t = _checks.indices(tetrahedra, 4, "tetrahedra")
    _checks.choice("energy", energy, ("symmetric-gradient", "symmetric-dirichlet", "exponential-symmetric-dirichlet"))
    if slide and not polish:
        raise _checks.InvalidOption("what slides is always polished")
    given = _checks.method(locals())
    given["polish"] = bool(polish)
    given["slide"] = bool(slide)
    moved = _checks.vertices(vertices, len(p), "vertices")
    result, account = _core.morph_volume(p, t, moved, _targets(places, moved, 3), given, watched(progress))
    return Deformed(result, finished(account))


def _three(result, name):
    if not isinstance(result, (tuple, list)) or len(result) != 3:
        raise ValueError(f"{name} with derivatives must return a tuple of its value, its gradient and its Hessian")
    return tuple(result)


def _energy_function(energy):
    """For the compiled part: what it returns has the form that is asked for."""
    return lambda s, derivatives: _three(energy(s, True), "energy") if derivatives else energy(s, False)


def _term_function(term):
    def function(x, derivatives):
        if not derivatives:
            return float(term(x, False))
        value, gradient, hessian = _three(term(x, True), "term")
        if hessian is not None:
            i, j, blocks = hessian
            i, j = (_checks.indices(np.reshape(k, (-1, 1)), 1, "the vertices of the term's Hessian").ravel() for k in (i, j))
            hessian = (i, j, blocks)
        return value, gradient, hessian

    return function


def minimize(points, elements, rest, *, energy="symmetric-dirichlet", term=None, stencils=None, fixed=None, method=None,
             energy_parameter=None, preconditioner=None, reference=None, acceleration=None, linear_solver=None, criterion=None,
             tolerance=None, max_iterations=None, time_limit=None, progress=None):
    """Minimises the mean energy of a map of triangles or tetrahedra, and a term, which may both be functions of Python.

    No element flips on the way.

    Parameters
    ----------
    points : (n, 2) array for triangles, (n, 3) array for tetrahedra
        The map to begin with, without flips: triangles are counterclockwise.
    elements : (f, 3) or (f, 4) array of integers
    rest : (n, 3) array, or (n, 2) array for triangles
        The shape at rest, against which distortion is measured.
    energy : str or function
        What is minimised: a name, as for `parameterize`, or a function `energy(s, derivatives)` of the signed singular values
        s (f, d), descending, of all elements. It returns the values (f,), and if `derivatives` is true a tuple of these, the
        first derivatives (f, d) and the second ones (f, d, d). Its mean, weighted by the measures of the elements at rest, is
        minimised, always by Newton's method with Hessians that are projected to the positive semidefinite ones, the method
        "projected-newton". It must be symmetric in its arguments; elements that are not positive count as infinite.
    term : function
        Added to the mean energy: `term(x, derivatives)` of all points x (n, d) returns a number, and if `derivatives` is true
        a tuple (value, gradient (n, d), Hessian), where the Hessian is None or a tuple of arrays (i, j, blocks): a positive
        semidefinite approximation, as blocks (k, d, d) of rows of the vertex i and columns of j. Blocks of j and i are implied.
    stencils : list of lists of vertices
        Vertices that blocks of the term couple; single vertices and vertices of one element need not be there.
    fixed : (k,) array of integers, or (n,) array of bool
        Vertices that stay where they are.
    method, energy_parameter, ..., progress
        As for `parameterize`; for energies that have a name.

    Returns
    -------
    Deformed
        (points, summary): `summary.energy` includes the term, `summary.energy_of_terms` what functions contribute.
    """
    t = _elements(elements)
    dimension = t.shape[1] - 1
    p = _checks.numbers(points, dimension, "points")
    r = _as_long_as(_checks.numbers(rest, (2, 3) if dimension == 2 else 3, "rest"), p, "rest")
    arguments = dict(locals())
    if callable(energy):
        for name in ("method", "energy_parameter", "preconditioner", "reference", "acceleration"):
            if arguments[name] is not None:
                raise _checks.InvalidOption(f"{name} is for energies that have a name")
        arguments["energy"] = None
    if term is not None and not callable(term):
        raise TypeError("term must be a function")
    given = _checks.method(arguments)
    if fixed is not None:
        given["fixed"] = _checks.vertices(fixed, len(p), "fixed")
    if stencils is not None:
        given["stencils"] = [_checks.vertices(stencil, len(p), "stencils").ravel().tolist() for stencil in stencils]
    functions = (_energy_function(energy) if callable(energy) else None, None if term is None else _term_function(term))
    result, account = _core.minimize(p, t, _in_space(r), *functions, given, watched(progress))
    return Deformed(result, finished(account))
