# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""The type hints speak of what there is."""

import ast
import inspect
import os
import subprocess
import sys

import flip_free_maps as ffm
import pytest

FOLDER = os.path.dirname(ffm.__file__)


def stub():
    with open(os.path.join(FOLDER, "__init__.pyi"), encoding="utf-8") as file:
        return ast.parse(file.read())


def names_of(arguments):
    ordinary = [a.arg for a in arguments.posonlyargs + arguments.args]
    more = [a.arg for a in (arguments.vararg, arguments.kwarg) if a is not None]
    return ordinary, [a.arg for a in arguments.kwonlyargs], more


def parameters_of(function):
    kinds = inspect.Parameter
    parameters = inspect.signature(function).parameters.values()
    return tuple(
        [p.name for p in parameters if p.kind in some]
        for some in ((kinds.POSITIONAL_OR_KEYWORD,), (kinds.KEYWORD_ONLY,), (kinds.VAR_POSITIONAL, kinds.VAR_KEYWORD))
    )


def test_same_names():
    declared = {node.name for node in stub().body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert {name for name in declared if not name.startswith("_")} == set(ffm.__all__)


def test_same_parameters():
    for node in stub().body:
        if isinstance(node, ast.FunctionDef):
            assert names_of(node.args) == parameters_of(getattr(ffm, node.name)), node.name
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            thing = getattr(ffm, node.name)
            for member in node.body:
                if not isinstance(member, ast.FunctionDef) or member.name == "__getattr__":
                    continue
                found = inspect.getattr_static(thing, member.name)
                is_property = any(isinstance(d, ast.Name) and d.id == "property" for d in member.decorator_list)
                assert isinstance(found, property) == is_property, (node.name, member.name)
                if not is_property:
                    assert names_of(member.args) == parameters_of(getattr(thing, member.name)), (node.name, member.name)


def test_same_attributes():
    for name in ("ChartOptions", "PackOptions"):
        node = next(n for n in stub().body if isinstance(n, ast.ClassDef) and n.name == name)
        declared = {member.target.id for member in node.body if isinstance(member, ast.AnnAssign)}
        assert declared == set(vars(getattr(ffm, name)()))


def test_marker():
    assert os.path.exists(os.path.join(FOLDER, "py.typed"))


def test_mypy():
    pytest.importorskip("mypy")
    subprocess.run([sys.executable, "-m", "mypy", "--strict", os.path.join(FOLDER, "__init__.pyi")], check=True)
