# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Makes the pictures of the manual, doc/fig, with the program: layouts, surfaces with a checkerboard, solids and curves.

The meshes are CGAL's own, as Debian's libcgal-demo has them, and some that are generated here; curves are drawn by matplotlib.

usage: make_figures.py PROGRAM [NAME...]
"""

import csv
import math
import os
import subprocess
import sys
import tarfile
import tempfile

ARCHIVE = "/usr/share/doc/libcgal-demo/data.tar.gz"
FIGURES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "fig")
WIDTH = 800


class Maker:
    def __init__(self, program, folder):
        self.program = os.path.abspath(program)
        self.folder = folder
        with tarfile.open(ARCHIVE) as archive:
            archive.extractall(folder)

    def mesh(self, name):
        return os.path.join(self.folder, "data", "meshes", name)

    def file(self, name):
        return os.path.join(self.folder, name)

    @staticmethod
    def figure(name):
        return os.path.join(FIGURES, name + ".png")

    def run(self, *arguments, may_fail=False):
        """Runs the program; what it makes is valid unless the picture is to show that it is not."""
        command = [self.program, *map(str, arguments)]
        answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if answer.returncode != 0 and not may_fail:
            raise SystemExit(f"{' '.join(command)}\n{answer.stdout}")

    @staticmethod
    def shrink():
        """What people see needs no more than 256 colours."""
        from PIL import Image

        for entry in os.scandir(FIGURES):
            if entry.name.endswith(".png") and entry.name != "layout.png":
                picture = Image.open(entry.path)
                if picture.mode == "RGB" or picture.mode == "RGBA":
                    picture.convert("RGB").quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(entry.path, optimize=True)

    def unwrap(self, name, mesh, *options):
        """The surface with a checkerboard, and its atlas."""
        self.run("unwrap", mesh, "--png", self.figure(name + "_atlas"), "--png3d", self.figure(name), "--picture-width", WIDTH, *options)

    def parameterize(self, name, mesh, *options, shows_surface=True):
        """The layout, and the surface with a checkerboard."""
        pictures = ["--png", self.figure(name + "_layout"), "--picture-width", WIDTH]
        if shows_surface:
            pictures += ["--png3d", self.figure(name)]
        self.run("parameterize", mesh, *pictures, *options)

    def deform(self, name, mesh, handles, width):
        """The shape, before and after if it is a solid; a handle is a line of a file."""
        file = self.write(name + ".txt", "\n".join(handles) + "\n")
        self.run("deform", mesh, "--handles", file, "--png", self.figure(name), "--picture-width", width)

    def write(self, name, text):
        with open(self.file(name), "w", encoding="ascii") as out:
            out.write(text)
        return self.file(name)


def off_text(points, faces):
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(map(repr, p)) for p in points]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def bar(n, m):
    """A planar bar of n times m squares, of height 1, and its handles: the right end bent up."""
    points = [(i / m, j / m, 0.0) for j in range(m + 1) for i in range(n + 1)]
    faces = []
    for j in range(m):
        for i in range(n):
            a = j * (n + 1) + i
            faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    return points, faces


def box(n, m):
    """The surface of a box of n times m times m cubes, of height 1."""
    index, points, faces = {}, [], []

    def vertex(*p):
        if p not in index:
            index[p] = len(points)
            points.append(tuple(c / m for c in p))
        return index[p]

    sizes = (n, m, m)
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, sizes[axis]):
            for i in range(sizes[u]):
                for j in range(sizes[v]):
                    corners = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = side, i + di, j + dj
                        corners.append(vertex(*p))
                    if side == 0:
                        corners.reverse()
                    a, b, c, d = corners
                    faces += [(a, b, c), (a, c, d)]
    return points, faces


def spiral(n, m, turns):
    """A flat strip of n times m squares that winds around an axis, and rises with each turn."""
    points, faces = [], []
    for j in range(m + 1):
        for i in range(n + 1):
            angle = 2 * math.pi * turns * i / n
            radius = 1 + 0.6 * j / m
            points.append((radius * math.cos(angle), 0.2 * angle, radius * math.sin(angle)))
    for j in range(m):
        for i in range(n):
            a = j * (n + 1) + i
            faces += [(a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)]
    return points, faces


def read_off(path):
    with open(path, encoding="ascii") as text:
        words = [word for line in text for word in line.split("#")[0].split()]
    assert words[0] == "OFF"
    count = int(words[1])
    return [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(count)]


def atlases(maker):
    maker.unwrap("unwrap_organic", maker.mesh("elephant.off"))
    maker.unwrap("unwrap_bear", maker.mesh("bear.off"))
    maker.unwrap("unwrap_cad", maker.mesh("fandisk.off"))
    # Without a bound, and with a tight one.
    maker.unwrap("unwrap_no_bound", maker.mesh("bear.off"), "--max-distortion", "inf", "--branches", "none", "--min-occupancy", "0")
    maker.unwrap("unwrap_tight_bound", maker.mesh("bear.off"), "--max-distortion", "1.005")


def layouts(maker):
    mesh = maker.mesh("mannequin-devil.off")
    maker.parameterize("start", mesh, "--start", "tutte", "--max-iterations", "0", "--picture-up", "z")
    maker.parameterize("parameterize", mesh, "--picture-up", "z")
    strip = maker.write("strip.off", off_text(*spiral(160, 8, 1.4)))
    maker.parameterize("overlapping", strip, shows_surface=False)
    maker.parameterize("bijective", strip, "--bijective", shows_surface=False)
    maker.parameterize("free_border", maker.mesh("nefertiti.off"), shows_surface=False)
    maker.parameterize("fixed_border", maker.mesh("nefertiti.off"), "--start", "tutte", "--border", "square", "--fix-border",
                       shows_surface=False)


def energies(maker):
    mesh = maker.mesh("lion-head.off")
    for energy in ("symmetric-dirichlet", "exponential-symmetric-dirichlet", "conformal"):
        maker.parameterize("energy_" + energy.replace("-", "_"), mesh, "--energy", energy)


def planar_shapes(maker):
    points, faces = bar(60, 12)
    mesh = maker.write("bar.off", off_text(points, faces))
    lines = []
    for v, (x, y, _) in enumerate(points):
        if x == 0:
            lines.append(f"{v} {x} {y}")
        elif x == 5:
            angle = 0.75 * math.pi
            lines.append(f"{v} {1.5 - math.sin(angle) * (y - 0.5)} {2.4 + math.cos(angle) * (y - 0.5)}")
    maker.deform("deform_bar", mesh, lines, WIDTH)


def solids(maker):
    points, faces = box(40, 8)
    mesh = maker.write("box.off", off_text(points, faces))
    lines = []
    for v, (x, y, z) in enumerate(points):
        if x == 0:
            lines.append(f"{v} {x} {y} {z}")
        elif x == 5:
            lines.append(f"{v} {x} {1 - z} {y}")
    maker.deform("deform_solid", mesh, lines, 2 * WIDTH)


def organic_solid(maker):
    """The feet of an elephant stay, the end of its trunk moves."""
    mesh = maker.mesh("elephant.off")
    points = read_off(mesh)
    low, high = min(p[1] for p in points), max(p[1] for p in points)
    lines = []
    for v, (x, y, z) in enumerate(points):
        if y < low + 0.05 * (high - low):
            lines.append(f"{v} {x} {y} {z}")
        elif y > high - 0.02 * (high - low):
            lines.append(f"{v} {x + 0.35 * (high - low)} {y - 0.1 * (high - low)} {z}")
    maker.deform("deform_elephant", mesh, lines, 2 * WIDTH)


def repair(maker):
    """A map that waves fold, in magenta where it is flipped, and what becomes of it."""
    maker.run("parameterize", maker.mesh("lion-head.off"), "-o", maker.file("flat.obj"), "--unit-square")
    lines = []
    with open(maker.file("flat.obj"), encoding="ascii") as flat:
        for line in flat:
            if line.startswith("vt "):
                u, v = map(float, line.split()[1:3])
                line = f"vt {u + 1.2 * math.sin(12 * u) / 12} {v}\n"
            lines.append(line)
    folded = maker.write("folded.obj", "".join(lines))
    maker.run("measure", folded, "--png3d", maker.figure("repair_before"), "--picture-width", WIDTH, may_fail=True)
    maker.run("repair", folded, "-o", maker.file("repaired.obj"), "--png3d", maker.figure("repair_after"), "--picture-width", WIDTH)


def curves(maker):
    """How far the energy is above the least one, by iteration, for the methods as they were published, all from the same start."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4.5), dpi=100)
    energies = {}
    for method in ("pp", "cm", "slim", "akvf", "aqp"):
        trace = maker.file(method + ".csv")
        maker.run("parameterize", maker.mesh("lion-head.off"), "--method", method, "--start", "tutte", "--trace", trace,
                  "--max-iterations", "300", may_fail=True)
        with open(trace, encoding="ascii") as table:
            energies[method] = [float(row["energy"]) for row in csv.DictReader(table)]
    least = min(map(min, energies.values()))
    for method, values in energies.items():
        axes.plot([value / least - 1 for value in values], label=method)
    axes.set(xscale="symlog", yscale="log", xlabel="iteration", ylabel="energy over the least energy, less 1", ylim=(1e-5, None))
    axes.grid(True, alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(maker.figure("methods"))


def main():
    groups = {f.__name__: f for f in (atlases, layouts, energies, planar_shapes, solids, organic_solid, repair, curves)}
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= set(groups):
        raise SystemExit(f"{__doc__}NAME is one of {', '.join(groups)}")
    os.makedirs(FIGURES, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        maker = Maker(sys.argv[1], folder)
        for name in sys.argv[2:] or groups:
            groups[name](maker)
        maker.shrink()


if __name__ == "__main__":
    main()
