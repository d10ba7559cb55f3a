# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Writes tables of the manual, doc/tables, which includes them: no figure in them is typed by hand.

usage: make_tables.py atlases PROGRAM MESH...     runs the program's `unwrap` with default settings
       make_tables.py sizes parameterize.csv      of benchmark/performance/parameterize_report
       make_tables.py cgal comparison.csv         of benchmark/quality/compare_with_cgal
"""

import csv
import datetime
import json
import os
import platform
import subprocess
import sys
import tempfile

TABLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "tables")


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.machine()


def read(path):
    """The rows of a CSV file, and its comments."""
    with open(path, newline="", encoding="utf-8") as file:
        lines = [line for line in file if line.strip()]
    comments = [line[1:].strip() for line in lines if line.startswith("#")]
    return list(csv.DictReader(line for line in lines if not line.startswith("#"))), comments


def write(name, heads, rows, remarks):
    with open(os.path.join(TABLES, name + ".txt"), "w", encoding="utf-8") as file:
        for row in [heads, ["---"] + ["--:"] * (len(heads) - 1)] + rows:
            file.write("| " + " | ".join(map(str, row)) + " |\n")
        file.write("\n" + " ".join(remarks) + "\n")


def thousands(number):
    return f"{int(number):,}".replace(",", " ")


def digits(value, number=2):
    return f"{float(f'{float(value):.{number}g}'):g}"


def atlases(program, meshes):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        for mesh in meshes:
            subprocess.run([program, "unwrap", mesh, "-o", os.path.join(folder, "atlas.obj"), "--json", report, "--threads", "1"],
                           check=True, stdout=subprocess.DEVNULL)
            with open(report, encoding="utf-8") as file:
                summary = json.load(file)
            rows.append([os.path.splitext(os.path.basename(mesh))[0].replace("_", " "), thousands(summary["faces"]), summary["cut"]["genus"],
                         summary["cut"]["borders"], summary["number_of_charts"], f"{summary['energy']:.4f}",
                         f"{100 * summary['occupancy']:.0f} %", digits(summary["seconds"]["total"])])
    write("atlases", ["Mesh", "Faces", "Genus", "Borders", "Charts", "Mean energy", "Covered", "Seconds"], rows,
          [f"Measured on one thread, {processor()}, {datetime.date.today()}."])


def sizes(path):
    table, comments = read(path)
    rows = [[thousands(row["faces"]), digits(row["cpu_seconds"]), digits(row["factorization_cpu_seconds"]), row["factorizations"],
             row["iterations"], digits(float(row["factor_entries"]) / 1e6) + " million", thousands(float(row["peak_memory_mb"])) + " MB"]
            for row in table if row["mesh"].startswith("ladder") and row["rule"] == "default" and row["threads"] == "1"]
    write("sizes", ["Triangles", "CPU seconds", "of these one factorization", "factorizations", "iterations", "entries of the factor",
                    "peak memory"], rows, ["Measured with:"] + ["; ".join(comments[:2]) + f"; {datetime.date.today()}."])


def cgal(path):
    table, comments = read(path)

    def cell(row):
        flips = int(row["flips"])
        text = f"{flips} flip{'s' if flips > 1 else ''}" if flips != 0 else f"{float(row['energy']):.3f}"
        if flips == 0 and row["bijective"] == "no":
            text += " (overlap)"
        if row["status"].startswith("error"):
            text += ", error"
        return text + f", {digits(row['seconds'])} s"

    meshes = list(dict.fromkeys((row["mesh"], row["faces"]) for row in table))
    cells = {(row["method"], row["mesh"]): cell(row) for row in table}
    names = {"Flip_free_maps": "`parameterize()`", "Flip_free_maps bijective": "the same, `bijective(true)`"}
    rows = [[names.get(method, f"`{method}_parameterizer_3`")] + [cells[method, mesh] for mesh, _ in meshes]
            for method in dict.fromkeys(row["method"] for row in table)]
    heads = [f"{os.path.splitext(mesh)[0].replace('_', ' ')} ({faces})" for mesh, faces in meshes]
    write("cgal", ["Method"] + heads, rows, [f"Measured on {processor()}, {datetime.date.today()}."])


def main():
    kinds = {"atlases": lambda files: atlases(files[0], files[1:]), "sizes": lambda files: sizes(files[0]), "cgal": lambda files: cgal(files[0])}
    if len(sys.argv) < 3 or sys.argv[1] not in kinds:
        sys.exit(__doc__)
    os.makedirs(TABLES, exist_ok=True)
    kinds[sys.argv[1]](sys.argv[2:])


if __name__ == "__main__":
    main()
