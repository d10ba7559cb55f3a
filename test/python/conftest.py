# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

import os
import sys

import pytest

sys.path.insert(0, os.path.dirname(__file__))


@pytest.fixture
def program():
    """The program of the command line; tests that need it are skipped without."""
    path = os.environ.get("FLIP_FREE_MAPS_PROGRAM", "")
    if not os.path.exists(path):
        pytest.skip("the program flip_free_maps is not built")
    return path
