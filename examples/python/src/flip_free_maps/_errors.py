# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Exceptions, a class for each status that leaves no map."""

from . import _core


class Error(RuntimeError):
    """What a function raises when it has no result.

    `status` is the name of the status, such as "not_a_disk", `message` a sentence that says why, in the numbers of the
    caller's arrays, and `summary` the account of the run, or None if there was no run.
    """

    status = "failure"

    def __init__(self, message, summary=None):
        super().__init__(message)
        self.message = message
        self.summary = summary

    def __str__(self):
        return f"{self.status}: {self.message}"


def _class_of(status):
    name = "".join(word.capitalize() for word in status.split("_"))
    more = {"invalid_option": (ValueError,), "out_of_memory": (MemoryError,)}.get(status, ())
    return type(name, (Error, *more), {"status": status, "__module__": "flip_free_maps", "__doc__": f"The status `{status}`."})


CLASSES = {status: _class_of(status) for status in _core.failures()}
InvalidOption = CLASSES["invalid_option"]
NotTriangular = CLASSES["not_triangular"]
