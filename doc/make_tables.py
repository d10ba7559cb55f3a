# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Writes tables of the manual, doc/tables, which includes them: no figure in them is typed by hand.

usage: make_tables.py KIND FILE...

  atlases PROGRAM MESH...        runs the program's `unwrap` with default settings
  cuts PROGRAM MESH...           ... and with the seams of `cut_to_disk()` only
  bijective PROGRAM MESH...      runs the program's `parameterize`, with and without `--bijective`, on disks
  splitting PROGRAM MESH         ... by the splitting scheme on the mesh of benchmark/data/stein_2022_measured.csv
  sizes parameterize.csv         of benchmark/performance/parameterize_report
  cgal comparison.csv            of benchmark/quality/compare_with_cgal
  methods METHODS.csv...         of benchmark/quality/run_methods on the meshes of
                                 benchmark/data/progressive_parameterizations_measured.csv: `default` by the characteristic gradient,
                                 other methods by the decrease of the energy, `pp` also with --largest-step
  killing METHODS.csv...         of the same, `akvf` on the meshes of benchmark/data/claici_2017_measured.csv, by the characteristic
                                 gradient to 1e-6, also with --backtracking 0.5
  bar bar_experiments.csv        of benchmark/quality/bar_experiments
  areas area_distortion.csv      of benchmark/quality/area_distortion
  solids NAME=ladder.csv...      of benchmark/performance/volume_ladder, for each linear solver
  ranks PROGRAM MESH HANDLES     runs `flip_free_maps_mpi deform` on 1, 2 and 4 ranks
"""

import csv
import datetime
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TABLES = os.path.join(HERE, "tables")
PUBLISHED = os.path.join(HERE, "..", "benchmark", "data")


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


def write_text(name, sentences, table=""):
    with open(os.path.join(TABLES, name + ".txt"), "w", encoding="utf-8") as file:
        file.write(table + " ".join(sentences) + "\n")


def write(name, heads, rows, remarks):
    lines = [heads, ["---"] + ["--:"] * (len(heads) - 1)] + rows
    write_text(name, remarks, "".join("| " + " | ".join(map(str, row)) + " |\n" for row in lines) + "\n")


def thousands(number):
    return f"{int(number):,}".replace(",", " ")


def digits(value, number=2):
    return f"{float(f'{float(value):.{number}g}'):g}"


def atlases(program, meshes):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            summary = run(program, "unwrap", mesh, folder)
            rows.append([name_of(mesh), thousands(summary["faces"]), summary["cut"]["genus"],
                         summary["cut"]["borders"], summary["number_of_charts"], f"{summary['energy']:.4f}",
                         f"{100 * summary['occupancy']:.0f} %", digits(summary["seconds"]["total"])])
    write("atlases", ["Mesh", "Faces", "Genus", "Borders", "Charts", "Mean energy", "Covered", "Seconds"], rows, [measured()])


def sizes(path):
    table, comments = read(path)
    shown = [row for row in table if row["mesh"].startswith("ladder") and row["rule"] == "default" and row["threads"] == "1"]
    rows = [[thousands(row["faces"]), digits(row["cpu_seconds"]), digits(row["factorization_cpu_seconds"]), row["factorizations"],
             row["iterations"], digits(float(row["factor_entries"]) / 1e6) + " million", thousands(float(row["peak_memory_mb"])) + " MB"]
            for row in shown]
    middle = min(shown, key=lambda row: abs(float(row["faces"]) - 100000))
    phases = {"start": "the start", "factorize": "the factorization", "analyze": "orderings", "solve": "solves",
              "assemble": "gradients and the matrix", "line_search": "line searches", "certify": "certificates"}
    shares = ", ".join(f"{name} {100 * float(middle['seconds_' + phase]) / float(middle['seconds']):.0f} %" for phase, name in phases.items())
    write("sizes", ["Triangles", "CPU seconds", "of these one factorization", "factorizations", "iterations", "entries of the factor",
                    "peak memory"], rows, [f"Of the time for {thousands(middle['faces'])} triangles: {shares}.", "Measured with:"] + ["; ".join(comments[:2]) + f"; {datetime.date.today()}."])


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


def name_of(mesh):
    return os.path.splitext(os.path.basename(mesh))[0].replace("_", " ")


def measured():
    return f"Measured on one thread, {processor()}, {datetime.date.today()}."


def run(program, command, mesh, folder, *options):
    """The summary of a run of the program."""
    report = os.path.join(folder, "report.json")
    subprocess.run([program, command, mesh, *options, "--json", report, "--threads", "1"], check=True, stdout=subprocess.DEVNULL)
    with open(report, encoding="utf-8") as file:
        return json.load(file)


def cuts(program, meshes):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            summary = run(program, "unwrap", mesh, folder, "--max-distortion", "inf", "--min-occupancy", "0", "--no-pack")
            rows.append([name_of(mesh), thousands(summary["faces"]), summary["cut"]["genus"], summary["cut"]["seam_edges"],
                         f"{summary['energy']:.3f}", summary["number_of_charts"], digits(summary["cut"]["seconds"])])
    write("cuts", ["Surface", "Triangles", "Genus", "Seam edges", "Energy", "Charts after splits of overlaps", "Seconds for the seams"], rows,
          [measured()])


def bijective(program, meshes):
    energies, times = [], []
    with tempfile.TemporaryDirectory() as folder:
        for mesh in meshes:
            free = run(program, "parameterize", mesh, folder, "-o", os.path.join(folder, "free.obj"))
            judged = subprocess.run([program, "measure", os.path.join(folder, "free.obj"), "--json", os.path.join(folder, "m.json")],
                                    stdout=subprocess.DEVNULL, check=True)
            with open(os.path.join(folder, "m.json"), encoding="utf-8") as file:
                judged = json.load(file)
            if judged["bijective"]:
                continue
            kept = run(program, "parameterize", mesh, folder, "--bijective")
            energies.append(100 * (kept["energy"] / free["energy"] - 1))
            times.append(kept["cpu_seconds"] / free["cpu_seconds"])
    text = (f"On {len(meshes)} surfaces that were cut to disks, by short cuts or along trees to some points, the free map of the default method "
            f"overlapped itself on {len(times)}. All of these were mapped bijectively, with energies {digits(statistics.median(energies))} % "
            f"greater in the median ({digits(max(energies))} % at most), in {digits(statistics.median(times))} times the CPU time in the median, "
            f"between {digits(min(times))} and {digits(max(times))} times.")
    write_text("bijective", [text, measured()])


def splitting(program, mesh):
    published, _ = read(os.path.join(PUBLISHED, "stein_2022_measured.csv"))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for theirs in published:
            assert theirs["mesh"] == os.path.splitext(os.path.basename(mesh))[0]
            name, end = theirs["energy_name"], float(theirs["energy"])
            for method in ("splitting", "splitting+"):
                trace = os.path.join(folder, "trace.csv")
                summary = run(program, "parameterize", mesh, folder, "--method", method, "--energy", name, "--trace", trace,
                              "--max-iterations", "20000")
                points, _ = read(trace)
                passed = next((point["iteration"] for point in points if float(point["energy"]) <= end), "-")
                rows.append([name.replace("-", " "), f"`{method}`", summary["iterations"], f"{summary['energy']:.4f}", passed])
            rows.append([name.replace("-", " "), "authors' program", theirs["iterations"], f"{end:.4f}", theirs["iterations"]])
    write("splitting", ["Energy", "Method", "Iterations", "Mean energy", "Iteration that passes the authors' end"], rows,
          [f"{name_of(mesh).capitalize()}, {thousands(published[0]['faces'])} triangles, from a Tutte embedding.", measured()])


SETS = {"d1": "D1, well cut ones", "d2": "D2, cut to far points", "d3": "D3, cut to many points", "d3p": "D3 with badly shaped cuts"}


def by_mesh_and_method(paths):
    """The rows of files of run_methods that ended well."""
    runs, comments = {}, []
    for path in paths:
        table, comments = read(path)
        runs.update({(row["mesh"], row["method"]): row for row in table if row["status"] == "success"})
    return runs, comments


def methods(paths):
    runs, comments = by_mesh_and_method(paths)
    published, _ = read(os.path.join(PUBLISHED, "progressive_parameterizations_measured.csv"))
    theirs = {row["mesh"]: int(row["factorizations"]) for row in published if row["status"] == "ok"}
    columns = ["default", "pp", "pp from the largest step", "pp+"]
    meshes = [row["mesh"] for row in published if all((row["mesh"], method) in runs for method in columns)]
    count = {(mesh, method): int(runs[mesh, method]["factorizations"]) for mesh in meshes for method in columns}
    both = [mesh for mesh in meshes if mesh in theirs]

    def cell(values):
        return f"{digits(statistics.median(values), 3)}, {max(values)}"

    rows = []
    for key, title in SETS.items():
        names = [mesh for mesh in both if mesh.split("_")[0] == key]
        if names:
            rows.append([f"{title}: {len(names)}"] + [cell([count[mesh, method] for mesh in names]) for method in columns] +
                        [cell([theirs[mesh] for mesh in names])])
    rows.append([f"all {len(both)}, in the median over the authors' program", ""] +
                [f"{statistics.median([count[mesh, method] / theirs[mesh] for mesh in both]):.2f}" for method in columns[1:]] + ["1"])
    left_out = [f"{name_of(mesh)}, on which the authors' program fails ({', '.join(f'`{method}` {count[mesh, method]}' for method in columns)})"
                for mesh in meshes if mesh not in theirs]
    remarks = [f"Measured with: {comments[0] if comments else processor()}; {datetime.date.today()}."]
    if left_out:
        remarks.append("Left out: " + "; ".join(left_out) + ".")
    # Those with progressive references, over those without.
    pairs = [("p-cm+", "cm+"), ("p-slim+", "slim+"), ("p-akvf+", "akvf+")]
    for column, text in (("eta", "to within 1 % of their last energy"), ("iterations", "to the end")):
        parts = []
        for progressive, plain in pairs:
            ratios = [float(runs[mesh, progressive][column]) / float(runs[mesh, plain][column]) for mesh in theirs
                      if (mesh, progressive) in runs and (mesh, plain) in runs and float(runs[mesh, plain][column]) > 0]
            if ratios:
                parts.append(f"`{progressive}` {statistics.median(ratios):.2f} times those of `{plain}` ({len(ratios)} surfaces)")
        if parts:
            remarks.append(f"Iterations {text}, in the median: " + ", ".join(parts) + ".")
    iterations = [int(runs[mesh, "default"]["iterations"]) for mesh in meshes if mesh.startswith("d1_")]
    if iterations:
        remarks.append(f"`default` takes {min(iterations)} to {max(iterations)} iterations on D1.")
    write("methods", ["Surfaces, and their number", "`default`", "`pp`", "`pp`, from the largest step", "`pp+`", "authors' program"], rows, remarks)


def killing(paths):
    runs, comments = by_mesh_and_method(paths)
    published, _ = read(os.path.join(PUBLISHED, "claici_2017_measured.csv"))
    ours, theirs = ("eta", "to_0.1_percent", "to_1e-5"), ("to_1_percent", "to_0.1_percent", "to_1e-5")
    names = {"akvf": "`akvf`", "akvf with factor 0.5": "`akvf`, by halves", "akvf+": "`akvf+`"}
    rows = []
    for mesh in published:
        rows.append([name_of(mesh["mesh"]), thousands(mesh["faces"])] +
                    [" / ".join(f"{float(runs[mesh['mesh'], method][column]):.0f}" for column in ours) for method in names] +
                    [" / ".join(mesh[column] for column in theirs)])
    energies = [abs(float(runs[mesh["mesh"], "akvf"]["energy"]) - float(mesh["energy"])) for mesh in published]
    write("killing", ["Surface", "Triangles", *names.values(), "authors' program"], rows,
          [f"The last energies differ from those of the authors' program by {max(energies):.0e} at most.",
           f"Measured with: {comments[0] if comments else processor()}; {datetime.date.today()}."])


def bar(path):
    table, comments = read(path)
    shown = ["cm", "vertex-space-newton", "projected-newton", "slim", "aqp"]
    said = {}
    for line in comments:
        match = re.match(r"(.*), armijo: .*to 1e-6 ([^,;]*).*time to 1e-9 (\S+) \(paper: (.*)\)", line)
        if match:
            said[match.group(1)] = list(match.groups()[1:])
    rows = []
    for experiment, figures in said.items():
        runs = {row["method"]: row for row in table if row["experiment"] == experiment and row["steps"] == "armijo"}
        cells = [" / ".join(runs[m][f"iterations_to_{end}"].replace("-1", "-") for end in ("1e-3", "1e-6", "1e-9")) for m in shown]
        rows.append([experiment] + cells + figures)
    write("bar", ["Experiment"] + [f"`{m}`" for m in shown] + ["`vertex-space-newton` over `cm`: iterations to 10<sup>-6</sup>",
                                                               "time to 10<sup>-9</sup>", "in the paper"],
          rows, [f"Measured with: {comments[0]}; {datetime.date.today()}."])


def areas(path):
    table, comments = read(path)
    rows = []
    for key, title in SETS.items():
        of_set = [row for row in table if row["mesh"].split("_")[0] == key]
        # A developable surface has no distortion to compare.
        pairs = [(float(row["gradient_mean_difference"]), float(row["dirichlet_mean_difference"])) for row in of_set]
        pairs = [pair for pair in pairs if pair[1] > 1e-6]
        if pairs:
            medians = [digits(statistics.median(pair[k] for pair in pairs), 3) for k in range(2)]
            rows.append([title] + medians + [f"{sum(g < d for g, d in pairs)} of {len(pairs)}"])
    write("areas", ["Disks", "symmetric gradient", "symmetric Dirichlet", "less on"], rows,
          [f"Measured with: {comments[0]}; {datetime.date.today()}."])


def solids(arguments):
    heads, rows = ["Tetrahedra"], {}
    for number, argument in enumerate(arguments):
        name, path = argument.split("=", 1)
        table, comments = read(path)
        heads += [f"{name}: CPU seconds", "iterations of conjugate gradients", "peak memory"]
        for row in table:
            cells = rows.setdefault(int(row["tetrahedra"]), {})
            cells[number] = [digits(row["cpu_s"]), row["inner_iterations"] if row["inner_iterations"] != "0" else "",
                             thousands(float(row["peak_mb"])) + " MB"]
    write("solids", heads, [[thousands(size)] + sum((cells.get(i, ["", "", ""]) for i in range(len(arguments))), [])
                            for size, cells in sorted(rows.items())],
          [f"Measured with: {comments[0]}; {datetime.date.today()}."])


def ranks(program, mesh, handles):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for number in (1, 2, 4):
            said = subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(number), program, "deform", mesh, "--handles", handles,
                                   "-o", os.path.join(folder, "out.mesh"), "--tolerance", "1e-7"], check=True, stdout=subprocess.PIPE).stdout.decode()

            def figure(name):
                return re.search(r"\b" + name + r" ([-+.e0-9]+)", said).group(1)

            rows.append([thousands(figure("tetrahedra")), number, figure("energy"), figure("iterations"), figure("iterations of conjugate gradients"),
                         thousands(float(figure("peak memory of the largest"))) + " MB", digits(figure("total"), 3)])
    write("ranks", ["Tetrahedra", "Ranks", "Energy", "Iterations", "Iterations of conjugate gradients", "Memory of the largest rank", "Seconds"],
          rows, [f"Measured on {os.cpu_count()} cores, {processor()}, {datetime.date.today()}."])


def main():
    kinds = {"atlases": lambda files: atlases(files[0], files[1:]), "cuts": lambda files: cuts(files[0], files[1:]),
             "bijective": lambda files: bijective(files[0], files[1:]), "splitting": lambda files: splitting(*files),
             "sizes": lambda files: sizes(files[0]), "cgal": lambda files: cgal(files[0]), "methods": methods,
             "killing": killing, "bar": lambda files: bar(files[0]), "areas": lambda files: areas(files[0]),
             "solids": solids, "ranks": lambda files: ranks(*files)}
    if len(sys.argv) < 3 or sys.argv[1] not in kinds:
        sys.exit(__doc__)
    os.makedirs(TABLES, exist_ok=True)
    kinds[sys.argv[1]](sys.argv[2:])


if __name__ == "__main__":
    main()
