# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Long runs: threads, interruptions, progress, memory."""

import os
import resource
import signal
import subprocess
import sys
import threading
import time

import flip_free_maps as ffm
import meshes
import numpy as np
import pytest

LONG = """
import sys, threading, time
sys.path.insert(0, sys.argv[1])
import flip_free_maps as ffm, meshes, numpy as np
points, faces = meshes.sheet(int(sys.argv[2]))
solid, tetrahedra = meshes.bar(32, 12)
handles = np.flatnonzero((solid[:, 0] == 0) | (solid[:, 0] == 32))
targets = solid[handles] * [1, 1, 1] + (solid[handles][:, :1] > 0) * np.array([0, 30, 0])
endless = {"tolerance": 0, "criterion": "gradient", "max_iterations": 10**9}
calls = {
    "parameterize": lambda: ffm.parameterize(points, faces, method="aqp", **endless),
    "unwrap": lambda: [ffm.unwrap(points, faces, max_distortion=1 + 1e-9) for _ in range(10**6)],
    "deform": lambda: ffm.deform(solid, tetrahedra, handles, targets, method="sobolev", **endless),
}
print("ready", flush=True)
try:
    calls[sys.argv[3]]()
    print("ended")
except KeyboardInterrupt:
    # The process is as healthy as before.
    assert ffm.parameterize(*meshes.sheet(8)).summary.status == "success"
    print("interrupted")
"""


@pytest.mark.parametrize("name", ["parameterize", "unwrap", "deform"])
def test_ctrl_c(name):
    cells = "300" if name == "parameterize" else "60"
    command = [sys.executable, "-c", LONG, os.path.dirname(__file__), cells, name]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "ready\n"
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=120)
    finally:
        process.kill()
    assert out == "interrupted\n" and process.returncode == 0


def test_progress():
    points, faces = meshes.sheet()
    reports = []
    expected, _ = ffm.parameterize(points, faces)
    uv, summary = ffm.parameterize(points, faces, progress=reports.append)
    assert np.array_equal(uv, expected)
    assert [report.iteration for report in reports] == list(range(summary.iterations + 1))
    assert reports[-1].energy == pytest.approx(summary.energy) and all(report.flips == 0 for report in reports)
    energies = [report.energy for report in reports]
    assert energies == sorted(energies, reverse=True)

    reports = []
    atlas = ffm.unwrap(points, faces, progress=reports.append)
    assert np.array_equal(atlas.uv, ffm.unwrap(points, faces).uv)
    assert reports[-1].charts_done == len(atlas.summary.charts) and reports[-1].faces_done == reports[-1].faces == len(faces)
    assert all(a.faces_done <= b.faces_done and a.seconds <= b.seconds for a, b in zip(reports, reports[1:]))
    phases = [report.phase for report in reports]
    assert phases[0] == "cut" and phases[-1] == "pack" and phases == sorted(phases, key=["cut", "flatten", "pack"].index)
    # Also while several charts are flattened at the same time.
    parts = [meshes.torus(), meshes.sphere()]
    both = np.concatenate([parts[0][0], parts[1][0] + 9]), np.concatenate([parts[0][1], parts[1][1] + len(parts[0][0])])
    threads = set()
    ffm.unwrap(*both, progress=lambda report: threads.add(threading.get_ident()))
    assert threads == {threading.get_ident()}

    reports = []
    uv = points[:, :2].copy()
    uv[20] += 0.5
    ffm.repair(points, faces, uv, progress=reports.append)
    assert hasattr(reports[0], "primal_error") and reports[0].flips > 0 and reports[-1].flips == 0


def test_progress_stops():
    points, faces = meshes.sheet()
    uv, summary = ffm.parameterize(points, faces, method="aqp", progress=lambda report: report.iteration < 3)
    assert summary.status == "stopped_by_observer" and summary.iterations == 3 and meshes.flips(faces, uv) == 0
    atlas = ffm.unwrap(*meshes.torus(), progress=lambda report: False)
    assert atlas.summary.status == "stopped_by_observer" and meshes.flips(atlas.faces, atlas.uv) == 0
    assert ffm.is_bijective(atlas.faces, atlas.uv)
    assert ffm.parameterize(points, faces, progress=lambda report: np.bool_(True)).summary.status == "success"


def test_what_progress_raises_is_raised():
    points, faces = meshes.sheet()
    told = []

    def fail(report):
        told.append(report)
        raise LookupError("enough")

    for call in (
        lambda: ffm.parameterize(points, faces, progress=fail),
        lambda: ffm.unwrap(points, faces, progress=fail),
        lambda: ffm.repair(points, faces, points[:, :2], progress=fail),
        lambda: ffm.deform(points[:, :2], faces, [0, 5], [[0, 0], [1, 0.2]], progress=fail),
    ):
        told.clear()
        with pytest.raises(LookupError, match="enough"):
            call()
        assert len(told) == 1


def test_two_threads():
    inputs = [meshes.sheet(20), meshes.torus(24, 12)]
    expected = [ffm.unwrap(*mesh) for mesh in inputs]
    session = ffm.Deformation(inputs[0][0][:, :2], inputs[0][1], [0, 440])
    failures = []

    def work(number):
        try:
            for _ in range(5):
                atlas = ffm.unwrap(*inputs[number], progress=lambda report: True)
                assert np.array_equal(atlas.uv, expected[number].uv) and np.array_equal(atlas.faces, expected[number].faces)
                uv, _ = ffm.parameterize(*inputs[0])
                assert meshes.flips(inputs[0][1], uv) == 0
                session.move([[0, 0], [1, 1 + 0.1 * number]])
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=work, args=(number,)) for number in (0, 1)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
    assert session.points[440, 1] in (1, 1.1)


def test_other_threads_run():
    """Python goes on while the module computes."""
    points, faces = meshes.sheet(40)
    counted = []
    end = threading.Event()

    def count():
        while not end.is_set():
            counted.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.monotonic()
    ffm.parameterize(points, faces, method="aqp", tolerance=0, criterion="gradient", max_iterations=200)
    within = (begin, time.monotonic())
    end.set()
    thread.join()
    assert sum(within[0] < moment < within[1] for moment in counted) > 1


def test_no_leak():
    """Memory stops growing: what two thousand calls lose, or fifty of the slow one, would be seen, though the heap has room at first."""
    points, faces = meshes.sheet(3)
    solid, tetrahedra = meshes.bar(2, 1)
    bad = points.copy()
    bad[3] = np.nan

    def failing(call):
        with pytest.raises(ffm.Error):
            call()

    calls = [
        lambda: ffm.unwrap(points, faces, pack=False),
        lambda: ffm.parameterize(points, faces, progress=lambda report: True),
        lambda: ffm.deform(solid, tetrahedra, [0, 11], [[0, 0, 0], [2, 1, 1.25]]),
        lambda: ffm.Deformation(points[:, :2], faces, [0, 5]).move([[0, 0], [1, 0.4]]),
        lambda: failing(lambda: ffm.unwrap(bad, faces)),
        lambda: failing(lambda: ffm.parameterize(points, faces + 1)),
    ]

    def growth(call, number):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        for _ in range(number):
            call()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before

    for call, number in [(call, 2000) for call in calls] + [(lambda: ffm.parametrize(points, faces), 50)]:
        growth(call, number)  # until the heaps of all threads are filled
        assert any(growth(call, number) < 1024 for _ in range(2)), "KiB"
