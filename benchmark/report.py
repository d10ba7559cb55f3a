#!/usr/bin/env python3
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

"""Makes pages of HTML of the CSV files that the benchmark programs write: parameterize.html, methods.html and volume_methods.html,
of those whose files are in the folder. The pages need nothing from anywhere else, and this script nothing but Python 3.

usage: report.py FOLDER [--reference FILE]      (FILE: figures of another program, TSV, shown beside ours in methods.html)
"""

import argparse
import collections
import csv
import html
import math
import os
import statistics

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")
COLORS = ["#1d4ed8", "#b91c1c", "#047857", "#b45309", "#6d28d9", "#0e7490", "#be185d", "#4d7c0f", "#111827", "#9ca3af"]
PHASES = ["load", "start", "analyze", "assemble", "factorize", "solve", "line_search", "certify"]
STYLE = """
body{font:15px/1.5 Helvetica,Arial,sans-serif;color:#111827;max-width:1400px;margin:2em auto;padding:0 1.5em}
h2{font-size:1.25em;margin-top:2.2em;border-bottom:1px solid #d1d5db}.muted{color:#6b7280;font-size:.9em}
table{border-collapse:collapse;font-size:12.5px;margin:.6em 0}.scroll{overflow-x:auto}
th,td{padding:2px 7px;text-align:right;border-bottom:1px solid #e5e7eb;white-space:nowrap}
th:first-child,td:first-child{text-align:left}.best{font-weight:700}.off{color:#9ca3af}
.plots{display:flex;flex-wrap:wrap;gap:18px}svg{width:440px;height:auto}
"""


class Table:
    """A CSV or TSV file: its rows as dictionaries, and the lines that begin with # as comments."""

    def __init__(self, path, delimiter=","):
        with open(path, newline="", encoding="utf-8") as file:
            lines = [line for line in file if line.strip()]
        self.comments = [line[1:].strip() for line in lines if line.startswith("#")]
        reader = csv.DictReader((line for line in lines if not line.startswith("#")), delimiter=delimiter)
        self.rows = list(reader)
        self.columns = reader.fieldnames or []


def number(row, column):
    try:
        return float(row.get(column) or "nan")
    except ValueError:
        return math.nan


def text_of(value, digits=4):
    if isinstance(value, str):
        return value
    return "-" if value is None or not math.isfinite(value) else f"{value:.{digits}g}"


def median(values):
    """The median, in which what is not a number counts as infinite: a run that did not get there."""
    values = [value if math.isfinite(value) else math.inf for value in values]
    return statistics.median(values) if values else math.nan


def table(columns, rows, marks=None):
    """A table; `marks` maps (row, column) to a class of its cell."""
    head = "".join(f"<th>{html.escape(column)}</th>" for column in columns)
    body = ""
    for i, row in enumerate(rows):
        cells = ""
        for j, value in enumerate(row):
            mark = (marks or {}).get((i, j))
            cells += f"<td class='{mark}'>" if mark else "<td>"
            cells += html.escape(text_of(value)) + "</td>"
        body += f"<tr>{cells}</tr>\n"
    return f"<div class='scroll'><table><tr>{head}</tr>\n{body}</table></div>\n"


def whole_table(file):
    comments = "<br>".join(html.escape(comment) for comment in file.comments)
    return f"<p class='muted'>{comments}</p>\n" + table(file.columns, [[row[c] or "" for c in file.columns] for row in file.rows])


def plot(title, series, x_label, y_label, log_x=False):
    """Lines over a logarithmic axis y: `series` is a list of (name, color, points)."""
    lines = []
    for name, color, points in series:
        points = [(x, y) for x, y in points if math.isfinite(x) and math.isfinite(y) and y > 0 and (x > 0 or not log_x)]
        if points:
            lines.append((name, color, [(math.log10(x) if log_x else x, math.log10(y)) for x, y in points]))
    if not lines:
        return ""
    xs = [x for _, _, points in lines for x, _ in points]
    ys = [y for _, _, points in lines for _, y in points]
    low_x, high_x, low_y, high_y = min(xs), max(xs), math.floor(min(ys)), math.ceil(max(ys))
    high_x, high_y = max(high_x, low_x + 1e-9), max(high_y, low_y + 1)

    def at(x, y):
        return f"{50 + 380 * (x - low_x) / (high_x - low_x):.1f},{225 - 195 * (y - low_y) / (high_y - low_y):.1f}"

    svg = f"<svg viewBox='0 0 440 290' font-size='10' font-family='Helvetica,Arial'><text x='50' y='15'>{html.escape(title)}</text>"
    for y in range(low_y, high_y + 1, max(1, (high_y - low_y) // 6)):
        a, b = at(low_x, y), at(high_x, y)
        svg += f"<polyline points='{a} {b}' stroke='#e5e7eb'/><text x='45' y='{float(a.split(',')[1]) + 3}' text-anchor='end'>1e{y}</text>"
    for x in (low_x, high_x):
        value = text_of(10**x if log_x else x, 3)
        svg += f"<text x='{at(x, low_y).split(',')[0]}' y='238' text-anchor='middle'>{value}</text>"
    svg += f"<text x='240' y='238' text-anchor='middle'>{html.escape(x_label)}</text><text x='430' y='15' text-anchor='end'>{html.escape(y_label)}</text>"
    for i, (name, color, points) in enumerate(lines):
        path = " ".join(at(x, y) for x, y in points)
        svg += f"<polyline points='{path}' fill='none' stroke='{color}' stroke-width='1.6'><title>{html.escape(name)}</title></polyline>"
        svg += f"<text x='{50 + 96 * (i % 4)}' y='{255 + 13 * (i // 4)}' fill='{color}'>{html.escape(name)}</text>"
    return svg + "</svg>\n"


def page(path, title, comments, body):
    notes = "<br>".join(html.escape(comment) for comment in comments)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>{html.escape(title)}</title>"
                   f"<style>{STYLE}</style></head><body>\n<h1>{html.escape(title)}</h1>\n<p class='muted'>{notes}</p>\n{body}</body></html>\n")
    print(path)


def set_of(mesh):
    return mesh.split("_")[0]


def published_tables(names):
    return "<h2>Published figures</h2>\n" + "".join(whole_table(Table(os.path.join(DATA, name))) for name in names)


def best_energies(rows):
    best = collections.defaultdict(lambda: math.inf)
    for row in rows:
        if number(row, "energy") < best[row["mesh"]]:
            best[row["mesh"]] = number(row, "energy")
    return best


def convergence(traces, best, key, x_column, x_label):
    """A plot for each mesh: the relative distance of the energy to the best one known."""
    points = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in traces.rows:
        mesh = row["mesh"]
        points[mesh][key(row)].append((number(row, x_column), number(row, "energy") / best[mesh] - 1))
    names = list(dict.fromkeys(name for lines in points.values() for name in lines))
    plots = "".join(plot(mesh, [(n, COLORS[names.index(n) % len(COLORS)], p) for n, p in lines.items()], x_label, "E / best - 1")
                    for mesh, lines in points.items())
    return f"<h2>Convergence</h2>\n<div class='plots'>{plots}</div>\n"


def methods_page(folder, reference):
    results = Table(os.path.join(folder, "methods.csv"))
    best = best_energies(results.rows)
    methods = list(dict.fromkeys(row["method"] for row in results.rows))
    meshes = sorted({row["mesh"] for row in results.rows})
    run = {(row["mesh"], row["method"]): row for row in results.rows}

    def within(mesh, method, relative):
        return (mesh, method) in run and number(run[mesh, method], "energy") <= best[mesh] * (1 + relative)

    def value(mesh, method, column):
        return number(run[mesh, method], column) if within(mesh, method, 1e-3) else math.nan

    body = ("<h2>Overview</h2>\n<p>Share of the meshes on which a method ends within 1 % and 0.01 % of the best energy that any method "
            "found, and medians over all meshes; runs that do not end within 0.1 % of the best energy count as infinite.</p>\n")
    columns = ["iterations", "eta", "factorizations", "factorization_units", "seconds", "peak_memory_mb"]
    ran = {method: [mesh for mesh in meshes if (mesh, method) in run] for method in methods}
    body += table(["method", "meshes", "within 1 %", "within 0.01 %"] + columns,
                  [[m, len(ran[m])] + [sum(within(mesh, m, r) for mesh in ran[m]) / len(ran[m]) for r in (1e-2, 1e-4)]
                   + [median([value(mesh, m, c) for mesh in ran[m]]) for c in columns] for m in methods])
    body += "<h2>Medians for each set</h2>\n"
    for name in sorted({set_of(mesh) for mesh in meshes}):
        body += table([name] + columns, [[m] + [median([value(mesh, m, c) for mesh in ran[m] if set_of(mesh) == name]) for c in columns]
                                         for m in methods])
    body += ("<h2>Pairs of methods</h2>\n<p class='muted'>Median ratio of seconds, row over column, on meshes where both end within "
             "0.1 % of the best energy.</p>\n")
    body += table([""] + methods, [[a] + [statistics.median(r) if (r := [
        value(mesh, a, "seconds") / value(mesh, b, "seconds") for mesh in meshes if within(mesh, a, 1e-3) and within(mesh, b, 1e-3)
        and value(mesh, b, "seconds") > 0]) else math.nan for b in methods] for a in methods])
    body += ("<h2>All runs</h2>\n<p class='muted'>Iterations / &eta; / energy; bold: within 0.1 % of the best energy, grey: no "
             "success.</p>\n")
    rows, marks = [], {}
    for i, mesh in enumerate(meshes):
        rows.append([mesh])
        for j, method in enumerate(methods):
            row = run.get((mesh, method))
            rows[-1].append(f"{row['iterations']} / {row['eta']} / {text_of(number(row, 'energy'), 8)}" if row else "-")
            if row and row["status"] != "success":
                marks[i, j + 1] = "off"
            elif within(mesh, method, 1e-3):
                marks[i, j + 1] = "best"
    body += table(["mesh"] + methods, rows, marks)
    if reference:
        body += "<h2>Another program on the same meshes</h2>\n" + whole_table(Table(reference, "\t"))
    body += convergence(Table(os.path.join(folder, "methods_traces.csv")), best, lambda row: row["method"], "iteration", "iterations")
    body += published_tables(["liu_2018_statements.csv", "liu_2018_table_1.csv", "shtengel_2017_table_1.csv", "claici_2017_table_1.csv"])
    page(os.path.join(folder, "methods.html"), "Flip_free_maps: methods compared", results.comments, body)


def parameterize_page(folder):
    runs = Table(os.path.join(folder, "parameterize.csv"))
    published = Table(os.path.join(DATA, "progressive_parameterizations_measured.csv"))
    # Only where the mesh has as many faces, or the program failed and says nothing about faces.
    faces = {row["mesh"]: number(row, "faces") for row in runs.rows}
    figures = {row["mesh"]: row for row in published.rows
               if number(row, "faces") == faces.get(row["mesh"]) or math.isnan(number(row, "faces"))}
    best = best_energies(runs.rows + [row for row in figures.values() if number(row, "energy") > 0])
    body = ("<p>A <em>unit</em> is the CPU time of one numeric factorization of the matrix of the full mesh in the same run; where a run "
            "needs none, one is timed after it. Units to 1e-2, 1e-4 and 1e-6 are those spent, the start included, until the energy is within "
            "that relative distance of the lowest energy known for the mesh, published figures included. Rule <em>default</em>: stopped by "
            "the characteristic gradient. Rule <em>energy</em>: by a relative decrease of the energy of 1e-6.</p>\n<h2>Medians</h2>\n")
    columns = ["iterations", "factorizations", "units", "units_to_1e-2", "units_to_1e-4", "units_to_1e-6", "seconds", "peak_memory_mb"]
    groups = collections.defaultdict(list)
    for row in runs.rows:
        groups[row["set"], row["rule"], row["threads"]].append(row)
    body += table(["set", "rule", "threads", "meshes"] + columns,
                  [list(key) + [len(rows)] + [median([number(row, c) for row in rows]) for c in columns] for key, rows in groups.items()])
    known = [row for row in runs.rows if row["mesh"] in figures]
    if known:
        body += "<h2>Beside the published program of progressive parameterizations</h2>\n"
        columns = [c for c in published.columns if c not in ("mesh", "faces")]
        body += table(["mesh", "rule", "threads", "our energy", "our units", "our seconds"] + columns,
                      [[row["mesh"], row["rule"], row["threads"], number(row, "energy"), number(row, "units"), number(row, "seconds")]
                       + [figures[row["mesh"]][c] or "" for c in columns] for row in known])
    ladder = [row for row in runs.rows if row["set"] == "ladder" and row["status"] == "success"]
    if ladder:
        series = collections.defaultdict(list)
        for row in ladder:
            series[f"{row['rule']}, threads {row['threads']}"].append(row)
        body += "<h2>Resolution ladder</h2>\n<p class='muted'>One generated surface, refined; memory is that of the process.</p>\n<div class='plots'>"
        for column in ("seconds", "peak_memory_mb"):
            body += plot("", [(name, COLORS[i % len(COLORS)], [(number(row, "faces"), number(row, column)) for row in rows])
                              for i, (name, rows) in enumerate(series.items())], "triangles", column, True)
        body += "</div>\n"
        rows = []
        for name, steps in series.items():
            for before, row in zip([None] + steps, steps):
                growth = [math.log(number(row, c) / number(before, c)) / math.log(number(row, "faces") / number(before, "faces"))
                          if before else math.nan for c in ("seconds", "peak_memory_mb")]
                rows.append([name, row["faces"]] + [number(row, c) for c in ("units", "seconds", "speedup", "peak_memory_mb")]
                            + [number(row, "peak_memory_mb") * 2**20 / number(row, "faces")] + growth)
        body += table(["series", "triangles", "units", "seconds", "speedup", "MB", "bytes / triangle", "growth of time", "of memory"], rows)
    body += "<h2>Where the time goes</h2>\n<p class='muted'>Wall-clock seconds by phase.</p>\n"
    body += table(["mesh", "rule", "threads", "seconds"] + PHASES,
                  [[row["mesh"], row["rule"], row["threads"], number(row, "seconds")] + [number(row, "seconds_" + p) for p in PHASES]
                   for row in runs.rows])
    body += "<h2>All runs</h2>\n" + table(runs.columns, [[row[c] or "" for c in runs.columns] for row in runs.rows],
                                         {(i, 0): "off" for i, row in enumerate(runs.rows) if row["status"] != "success"})
    body += convergence(Table(os.path.join(folder, "parameterize_traces.csv")), best,
                        lambda row: f"{row['rule']}, {row['threads']}", "units", "units of CPU time")
    page(os.path.join(folder, "parameterize.html"), "Flip_free_maps: performance of parameterize()", runs.comments, body)


def volume_page(folder):
    results = Table(os.path.join(folder, "volume_methods_results.csv"))
    traces = Table(os.path.join(folder, "volume_methods.csv"))
    body = "<h2>Methods</h2>\n<p class='muted'>Objective: mean energy of the elements and the term of the handles.</p>\n"
    body += table(results.columns, [[row[c] or "" for c in results.columns] for row in results.rows])
    points = collections.defaultdict(list)
    for row in traces.rows:
        points[row["method"]].append(row)
    objectives = [number(row, "objective") for row in traces.rows if math.isfinite(number(row, "objective"))]
    best = min(objectives) if objectives else math.nan
    for title, shift in (("Objectives", 0), ("How far from the best", 1)):
        body += f"<h2>{title}</h2>\n<div class='plots'>"
        for x in ("iteration", "cpu_s"):
            body += plot("", [(name, COLORS[i % len(COLORS)], [(number(row, x), number(row, "objective") / (best if shift else 1) - shift)
                                                               for row in rows])
                              for i, (name, rows) in enumerate(points.items())], x, "relative distance" if shift else "objective")
        body += "</div>\n"
    body += published_tables(["slim_cube_measured.csv"])
    page(os.path.join(folder, "volume_methods.html"), "Flip_free_maps: methods on a solid", results.comments, body)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--reference")
    arguments = parser.parse_args()
    folder = arguments.folder

    def has(*names):
        return all(os.path.exists(os.path.join(folder, name)) for name in names)

    if has("methods.csv", "methods_traces.csv"):
        methods_page(folder, arguments.reference)
    if has("parameterize.csv", "parameterize_traces.csv"):
        parameterize_page(folder)
    if has("volume_methods.csv", "volume_methods_results.csv"):
        volume_page(folder)


if __name__ == "__main__":
    main()
