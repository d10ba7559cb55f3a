# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Energies and terms that are functions of Python."""

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest


def symmetric_dirichlet(s, derivatives):
    d = s.shape[1]
    value = (s**2 + s**-2.0).sum(axis=1) / (2 * d)
    if not derivatives:
        return value
    hessian = np.zeros((len(s), d, d))
    hessian[:, range(d), range(d)] = (1 + 3 * s**-4.0) / d
    return value, (s - s**-3.0) / d, hessian


def shapes():
    points, faces = meshes.sheet(6)
    yield points[:, :2] * 1.5, faces, points
    points, tetrahedra = meshes.bar(4, 2)
    yield points * [1.5, 1, 0.75], tetrahedra, points


def pull(target, weight=3.0):
    """The squared distance of vertex 0 from a place."""

    def term(x, derivatives):
        value = weight * ((x[0] - target) ** 2).sum()
        if not derivatives:
            return value
        gradient = np.zeros_like(x)
        gradient[0] = 2 * weight * (x[0] - target)
        return value, gradient, ([0], [0], 2 * weight * np.eye(x.shape[1])[None])

    return term


@pytest.mark.parametrize("start, elements, rest", list(shapes()), ids=["triangles", "tetrahedra"])
def test_energy(start, elements, rest):
    expected = ffm.minimize(start, elements, rest, tolerance=1e-8)
    result, summary = ffm.minimize(start, elements, rest, energy=symmetric_dirichlet, tolerance=1e-8)
    assert summary.status == "success" and summary.energy == pytest.approx(expected.summary.energy, rel=1e-9)
    assert meshes.flips(elements, result) == 0
    reports = []
    again, _ = ffm.minimize(start, elements, rest, energy=symmetric_dirichlet, tolerance=1e-8, progress=reports.append)
    assert np.array_equal(again, result) and len(reports) == summary.iterations + 1


@pytest.mark.parametrize("energy", ["symmetric-dirichlet", symmetric_dirichlet], ids=["named", "function"])
@pytest.mark.parametrize("start, elements, rest", list(shapes()), ids=["triangles", "tetrahedra"])
def test_term(start, elements, rest, energy):
    target = start[0] - 1
    fixed = [len(start) - 1, len(start) - 2, len(start) - 4]
    result, summary = ffm.minimize(start, elements, rest, energy=energy, term=pull(target), fixed=fixed, tolerance=1e-8)
    free, _ = ffm.minimize(start, elements, rest, energy=energy, fixed=fixed, tolerance=1e-8)
    assert np.array_equal(result[fixed], start[fixed]) and meshes.flips(elements, result) == 0
    assert np.linalg.norm(result[0] - target) < np.linalg.norm(free[0] - target)
    assert summary.energy_of_terms > 0
    # Without its Hessian a term that is not too stiff leads to the same energy.
    weak = pull(target, 0.05)
    _, expected = ffm.minimize(start, elements, rest, energy=energy, fixed=fixed, term=weak, tolerance=1e-6)
    _, summary = ffm.minimize(start, elements, rest, energy=energy, fixed=fixed, tolerance=1e-6,
                              term=lambda x, d: (*weak(x, True)[:2], None) if d else weak(x, False))
    assert summary.energy == pytest.approx(expected.energy, rel=1e-6)


def test_stencils():
    start, faces, rest = next(shapes())

    def spring(x, derivatives):
        """Draws two corners together."""
        a = x[0] - x[48]
        if not derivatives:
            return 10 * (a @ a)
        gradient = np.zeros_like(x)
        gradient[0], gradient[48] = 20 * a, -20 * a
        unit = 20 * np.eye(2)
        return 10 * (a @ a), gradient, ([0, 48, 0], [0, 48, 48], np.stack([unit, unit, -unit]))

    result, summary = ffm.minimize(start, faces, rest, term=spring, stencils=[[0, 48]])
    assert summary.status == "success"
    assert np.linalg.norm(result[0] - result[48]) < np.linalg.norm(start[0] - start[48])
    with pytest.raises(ffm.InvalidOption, match="stencils"):
        ffm.minimize(start, faces, rest, term=spring)


def test_points_of_no_element_stay():
    start, faces, rest = next(shapes())
    more, more_rest = np.concatenate([[[7, 8]], start]), np.concatenate([[[0, 0, 0]], rest])
    result, summary = ffm.minimize(more, faces + 1, more_rest, energy=symmetric_dirichlet, tolerance=1e-8)
    assert np.array_equal(result[0], [7, 8]) and meshes.flips(faces, result[1:]) == 0
    _, expected = ffm.minimize(start, faces, rest, energy=symmetric_dirichlet, tolerance=1e-8)
    assert summary.energy == pytest.approx(expected.energy, rel=1e-9)


def test_what_goes_wrong():
    start, faces, rest = next(shapes())
    calls = []

    def broken(s, derivatives):
        calls.append(len(s))
        raise KeyError("broken")

    for arguments in ({"energy": broken}, {"term": broken}):
        calls.clear()
        with pytest.raises(KeyError, match="broken"):
            ffm.minimize(start, faces, rest, **arguments)
        assert len(calls) == 1
    with pytest.raises(ValueError, match="shape"):
        ffm.minimize(start, faces, rest, energy=lambda s, d: (s, s, s) if d else s)
    with pytest.raises(ValueError, match="tuple"):
        ffm.minimize(start, faces, rest, energy=lambda s, d: s[:, 0])
    with pytest.raises(TypeError):
        ffm.minimize(start, faces, rest, term=lambda x, d: None)
    with pytest.raises(TypeError):
        ffm.minimize(start, faces, rest, term=3)
    # The start is not flipped: a function is no number there.
    for nothing in (np.nan, np.inf):
        with pytest.raises(ffm.NonFiniteInput, match="the term"):
            ffm.minimize(start, faces, rest, term=lambda x, d, value=nothing: (value, x, None) if d else value)
        with pytest.raises(ffm.NonFiniteInput, match="the energy"):
            ffm.minimize(start, faces, rest, energy=lambda s, d, value=nothing: (s[:, 0], s, s[:, :, None] * s[:, None]) if d else
                         s[:, 0] * value)
    with pytest.raises(ffm.InvalidOption, match="method"):
        ffm.minimize(start, faces, rest, energy=symmetric_dirichlet, method="slim")
    with pytest.raises(ffm.StartNotFlipFree):
        ffm.minimize(start * [-1, 1], faces, rest)
    with pytest.raises(ffm.DegenerateRestElement, match="element number 0"):
        ffm.minimize(start, faces, rest * 0)
    with pytest.raises(ffm.InvalidOption, match="49"):
        ffm.minimize(start, faces + 1, rest)
    with pytest.raises(ffm.EmptyMesh):
        ffm.minimize(start, np.zeros((0, 3), dtype=int), rest)
    with pytest.raises(ValueError):
        ffm.minimize(start, faces, rest[:-1])
