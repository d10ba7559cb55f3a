# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""What functions return."""

import copy
import html
import types
from typing import NamedTuple

import numpy as np

from ._errors import CLASSES


class Progress(types.SimpleNamespace):
    """What a `progress` function is told; see the functions that take one."""


class Summary:
    """The account of a run: attributes with the names that the program `flip_free_maps` writes to JSON.

    `status` is "success", or, for results that a limit or the caller ended, "iteration_limit", "time_limit" or
    "stopped_by_observer"; `message` says so in a sentence. Counts and energies that a run did not reach are -1.
    `print(summary)` shows the most important ones in a few lines.
    """

    def __init__(self, fields, shown=(), text=""):
        self._fields = fields
        self._shown = [name for name in shown if fields.get(name) not in (None, -1, "")]
        self._text = text
        for name, value in fields.items():
            setattr(self, name, _as_attribute(value))

    def to_dict(self):
        """All of it as a new dictionary of dictionaries, lists, numbers, strings and None."""
        return copy.deepcopy(self._fields)

    def __repr__(self):
        return self._text.rstrip() or f"Summary({self._fields!r})"

    def __eq__(self, other):
        return isinstance(other, Summary) and self._fields == other._fields

    def _repr_html_(self):
        rows = [("status", self._fields.get("status")), ("message", self._fields.get("message"))]
        rows += [(name, self._fields[name]) for name in self._shown]
        return "<table>" + "".join(_html_row(name, value) for name, value in rows if value not in (None, "")) + "</table>"


def _as_attribute(value):
    if isinstance(value, dict):
        return Summary(value)
    if isinstance(value, list):
        return [_as_attribute(entry) for entry in value]
    return value


def _html_text(value):
    if isinstance(value, dict):
        return ", ".join(f"{name} {_html_text(entry)}" for name, entry in value.items())
    if isinstance(value, float):
        return f"{value:.6g}"
    return html.escape(str(value))


def _html_row(name, value):
    return f"<tr><th style='text-align:left'>{html.escape(name.replace('_', ' '))}</th><td>{_html_text(value)}</td></tr>"


def finished(account):
    """The summary of a run, if that has a result; raises what it ended with otherwise."""
    summary = Summary(*account)
    failure = CLASSES.get(summary.status)
    if failure is not None:
        raise failure(summary.message, summary)
    return summary


def watched(progress):
    """A function for the compiled part that tells `progress`."""
    if progress is None:
        return None
    if not callable(progress):
        raise TypeError("progress must be a function")
    return lambda report: progress(Progress(**report))


def picture(uv, faces, size=400, most_faces=20000):
    """The layout as SVG: faces, if there are not too many of them to be told apart, and borders."""
    values, offsets = faces if isinstance(faces, tuple) else (faces.ravel(), np.arange(len(faces) + 1) * faces.shape[1])
    if values.size == 0:
        return ""
    low = uv[values].min(axis=0)
    extent = float(np.max(uv[values].max(axis=0) - low)) or 1.0
    places = (uv - low) * (size / extent)
    places[:, 1] = size - places[:, 1]
    following = np.arange(1, values.size + 1)
    first, last = offsets[:-1], offsets[1:]
    following[last[last > first] - 1] = first[last > first]
    edges = np.stack([values, values[following]], axis=1)
    edges.sort(axis=1)
    edges, counts = np.unique(edges, axis=0, return_counts=True)

    def lines(which, colour, width):
        ends = places[which].reshape(-1, 4)
        path = "".join("M%.1f %.1fL%.1f %.1f" % tuple(row) for row in ends.tolist())
        return f"<path d='{path}' fill='none' stroke='{colour}' stroke-width='{width}'/>"

    inner = lines(edges[counts > 1], "#94a3b8", 0.4) if len(offsets) - 1 <= most_faces else ""
    return (
        f"<svg xmlns='http://www.w3.org/2000/svg' width='{size}' height='{size}' viewBox='-4 -4 {size + 8} {size + 8}'>"
        + inner + lines(edges[counts == 1], "#1e3a8a", 1) + "</svg>"
    )


class _LayoutFields(NamedTuple):
    uv: np.ndarray
    """(n, 2) float64: the image of each vertex."""
    summary: Summary


class _Layout(_LayoutFields):
    """Images of vertices, which are shown with the faces that have them."""

    faces = None

    @classmethod
    def of(cls, uv, faces, summary):
        result = cls(uv, summary)
        result.faces = faces
        return result

    def _repr_html_(self):
        return self.summary._repr_html_() + ("" if self.faces is None else picture(self.uv, self.faces))


class Map(_Layout):
    """A map of the vertices of a surface into the plane, in the units of length of the points; points that are not in it have the
    image (0, 0)."""


class Packing(_Layout):
    """Charts in the unit square."""


class Unwrapping(NamedTuple):
    """A texture atlas: a mesh whose vertices have one point and one image each."""

    vertices: np.ndarray
    """(k,) int64: which point each vertex of the atlas has; `points[vertices]` are the points."""
    faces: np.ndarray
    """(f, 3) int64: the triangles, in the order of those that were given, as indices into `vertices` and `uv`; (f, k) for
    polygons in an array, and a pair (values, offsets) of int64 for others."""
    uv: np.ndarray
    """(k, 2): the images, in the unit square if charts are packed."""
    charts: np.ndarray
    """(f,) int64: the number of each face's chart; 0 is the largest, -1 stands for faces with corners at less than three places,
    whose images are those of these places."""
    summary: Summary

    @property
    def corners(self):
        """The images of the corners of the faces: (f, 3, 2) for triangles, (f, k, 2) for polygons in an array, and
        (sum of corners, 2) for a pair (values, offsets), in the order of the values."""
        return self.uv[self.faces[0] if isinstance(self.faces, tuple) else self.faces]

    def _repr_html_(self):
        return self.summary._repr_html_() + picture(self.uv, self.faces)


class Cut(NamedTuple):
    """A surface that is cut open."""

    seams: np.ndarray
    """(s, 2) int64: the edges that are cut, as pairs of points; those that were given come first."""
    vertices: np.ndarray
    """(k,) int64: which point each vertex of the cut surface has."""
    faces: np.ndarray
    """(f, 3) int64: the triangles as indices into `vertices`; `points[vertices]` and `faces` are the surface, cut open."""
    summary: Summary

    def _repr_html_(self):
        return self.summary._repr_html_()


class SeamlessMap(NamedTuple):
    """A map of a surface that is cut open, whose sides fit together along seams."""

    vertices: np.ndarray
    """(k,) int64: which point each vertex has."""
    faces: np.ndarray
    """(f, 3) int64: the triangles as indices into `vertices` and `uv`."""
    uv: np.ndarray
    """(k, 2) float64: the images, in the units of length of the points."""
    summary: Summary

    def _repr_html_(self):
        return self.summary._repr_html_() + picture(self.uv, self.faces)


class Deformed(NamedTuple):
    """A deformed shape."""

    points: np.ndarray
    """(n, 2) or (n, 3) float64: the places of the points; those that no element uses stay where they were."""
    summary: Summary

    def _repr_html_(self):
        return self.summary._repr_html_()
