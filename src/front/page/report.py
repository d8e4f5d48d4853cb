#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run or an ablation as one page: report.py DIR OUT.html [SCENE.yaml]

Puts what the folder holds into one file that needs nothing else: the report, the observables, the tables of an ablation,
pictures, the scene, with plots by uPlot (uPlot.LICENSE). `scree report` calls it. Needs Python 3 alone."""

import base64
import csv
import html
import json
import math
import os
import sys

ROWS_MAX = 4000  # of a plot; of longer tables every n-th row is taken
PICTURES_MAX = 12
HERE = os.path.dirname(os.path.abspath(__file__))
KINDS = {".png": "image/png", ".svg": "image/svg+xml", ".mp4": "video/mp4"}

# The figures at the head of the page: key of report.json, words, unit
FIGURES = [
    ("last_step", "steps", ""), ("time", "simulated time", "s"), ("dt", "step", "s"), ("particles", "particles", ""),
    ("ranks", "ranks", ""), ("threads", "threads of a rank", ""), ("seconds", "wall clock", "s"),
    ("particle_steps_per_second", "particle steps per second", ""), ("pairs", "pairs", ""), ("contacts", "contacts", ""),
    ("rebuilds", "rebuilds", ""), ("bytes_per_particle", "memory of a particle", "B"), ("index", "index", ""),
    ("law", "contact law", ""), ("integrator", "integrator", "")]
VERSIONS = ["version", "git_revision", "compiler", "flags", "cpu", "host"]


class Mistake(Exception):
    """A message for the user."""


def read(name):
    with open(name, encoding="utf-8", errors="replace") as file:
        return file.read()


def number(text):
    """A number, or None for an empty or infinite value; other text as it is."""
    try:
        value = float(text)
    except ValueError:
        return text or None
    return value if math.isfinite(value) else None


def table(path):
    """A table with commas: its names, and its columns."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row]
    if not rows:
        return [], []
    names = rows[0]
    rows = [row for row in rows[1:] if len(row) == len(names)]
    return names, [[number(row[k]) for row in rows] for k in range(len(names))]


def series(path):
    """A table over time, for plots: one plot for each unit of its columns."""
    names, columns = table(path)
    numbers = [k for k in range(len(names)) if all(value is None or isinstance(value, float) for value in columns[k])]
    if len(numbers) < 2 or not columns[0]:
        return []
    every = -(-len(columns[0]) // ROWS_MAX)
    plots = {}
    for k in numbers[1:]:
        name, _, unit = names[k].partition("[")
        plots.setdefault(unit.rstrip("]"), []).append((name, columns[k][::every]))
    return [{"kind": "lines", "x": names[0], "unit": unit, "names": [name for name, _ in lines],
             "data": [columns[0][::every]] + [values for _, values in lines]} for unit, lines in plots.items()]


def front(path):
    """Speed against error, with the rows on the front."""
    names, columns = table(path)
    need = ["group", "settings", "seconds", "judged_error", "on_front"]
    if not all(name in names for name in need):
        raise Mistake(f"{path}: lacks one of the columns {', '.join(need)}")
    group, settings, seconds, error, on_front = (columns[names.index(name)] for name in need)
    rows = [{"group": str(g), "settings": str(s), "seconds": t, "error": e, "front": bool(f)}
            for g, s, t, e, f in zip(group, settings, seconds, error, on_front)
            if isinstance(t, float) and isinstance(e, float) and t > 0 and e > 0]
    return {"kind": "front", "rows": sorted(rows, key=lambda row: row["seconds"])} if rows else None


def shown(value):
    """A value of the report as text."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return ", ".join(shown(item) for item in value)
    return "" if value is None else str(value)


def html_table(names, rows, kind=""):
    """A table of texts; its head sorts where the kind is `sorts`."""
    head = "".join(f"<th>{html.escape(name.replace('_', ' '))}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{html.escape(shown(value))}</td>" for value in row) + "</tr>\n" for row in rows)
    return f'<div class="wide"><table class="{kind}"><thead><tr>{head}</tr></thead><tbody>\n{body}</tbody></table></div>\n'


def bars(stages):
    """Seconds of each stage: the mean over ranks as a bar."""
    mean = {name: stage["mean"] for name, stage in stages.items() if isinstance(stage, dict) and stage.get("mean")}
    total, most = sum(mean.values()), max(mean.values(), default=0)
    rows = "".join(
        f'<tr><td>{html.escape(name)}</td><td class="bar"><span style="width:{100 * value / most:.2f}%"></span></td>'
        f"<td>{value:.3g} s</td><td>{100 * value / total:.1f} %</td></tr>\n"
        for name, value in sorted(mean.items(), key=lambda item: -item[1]))
    return f'<table class="bars">{rows}</table>\n' if rows else ""


def section(title, text):
    return f"<section>\n<h2>{html.escape(title)}</h2>\n{text}</section>\n" if text else ""


class Page:
    """The sections of the page, and the data of its plots."""

    def __init__(self, folder):
        self.folder = folder
        self.sections = []
        self.plots = []

    def path(self, name):
        path = os.path.join(self.folder, name)
        return path if os.path.isfile(path) else None

    def add(self, title, text):
        self.sections.append(section(title, text))

    def plot(self, data):
        """The place of a plot."""
        self.plots.append(data)
        return f'<div class="plot" data-plot="{len(self.plots) - 1}"></div>\n'

    def add_report(self, report, plain):
        figures = ""
        for key, words, unit in FIGURES:
            if key in report:
                unit = "" if plain and key in ("time", "dt") else unit
                figures += f"<div><b>{html.escape(shown(report[key]))} {unit}</b>{words}</div>"
        self.add("Figures", f'<div class="figures">{figures}</div>\n')
        if report.get("stopped"):
            self.add("Stopped", f"<p>{html.escape(str(report['stopped']))}</p>\n")

    def add_stages(self, report):
        self.add("Seconds of each part of the step", bars(report.get("stages", {})))
        for key, value in report.items():
            if isinstance(value, list) and value and all(isinstance(item, dict) for item in value):
                names = list(value[0])
                self.add(key.replace("_", " ").capitalize(),
                         html_table(names, [[item.get(name) for name in names] for item in value]))

    def add_tables(self):
        names = sorted(name for name in os.listdir(self.folder)
                       if name == "observables.csv" or (name.startswith("bonds_broken") and name.endswith(".csv")))
        for name in names:
            plots = series(self.path(name))
            self.add("Observables" if name == "observables.csv" else name, "".join(self.plot(data) for data in plots))

    def add_ablation(self):
        if self.path("speed_error.csv"):
            data = front(self.path("speed_error.csv"))
            if data:
                self.add("Speed against error", "<p>Each point is a run with other settings; no run is both faster and more "
                         "accurate than one on the line.</p>\n" + self.plot(data))
        for name, title in (("speed_error.csv", "Settings"), ("ablate.csv", "Comparison"),
                            ("speed_error_reference.csv", "Reference")):
            if self.path(name):
                names, columns = table(self.path(name))
                self.add(title, html_table(names, list(zip(*columns)), "sorts"))
        if self.path("speed_error.txt"):
            self.add("Advice", f"<pre>{html.escape(read(self.path('speed_error.txt')))}</pre>\n")

    def add_pictures(self):
        shown_names = sorted(name for name in os.listdir(self.folder) if os.path.splitext(name)[1] in KINDS)
        text = ""
        for name in shown_names[:PICTURES_MAX]:
            kind = KINDS[os.path.splitext(name)[1]]
            with open(self.path(name), "rb") as file:
                data = f"data:{kind};base64,{base64.b64encode(file.read()).decode()}"
            tag = f'<video controls src="{data}"></video>' if kind.startswith("video") else f'<img alt="" src="{data}">'
            text += f"<figure>{tag}<figcaption>{html.escape(name)}</figcaption></figure>\n"
        self.add("Pictures", text)

    def add_rest(self, report, scene):
        if scene:
            self.add("Scene", f'<details open><summary>the effective scene: every key that applies</summary><pre class="scene">'
                              f"{html.escape(scene)}</pre></details>\n")
        if report:
            self.add("Program", html_table(["", ""], [[key.replace("_", " "), report[key]] for key in VERSIONS if key in report]))
            rest = [[key, value] for key, value in report.items() if not isinstance(value, dict) and
                    not (isinstance(value, list) and value and isinstance(value[0], dict))]
            self.add("All numbers", f"<details><summary>report.json</summary>{html_table(['key', 'value'], rest)}</details>\n")

    def text(self, title):
        # no "<" stands raw: "<!--" and "<script" would change what the browser takes for the end of the data
        data = json.dumps(self.plots, allow_nan=False).replace("<", "\\u003c")
        style = read(os.path.join(HERE, "uPlot.min.css")) + read(os.path.join(HERE, "page.css"))
        licence = read(os.path.join(HERE, "uPlot.LICENSE"))
        return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
                f'<meta name="viewport" content="width=device-width">\n<title>{html.escape(title)}</title>\n'
                f"<style>\n{style}</style>\n</head>\n<body>\n<h1>{html.escape(title)}</h1>\n"
                f"{''.join(self.sections)}"
                f"<script>\n/*\n{licence}*/\n{read(os.path.join(HERE, 'uPlot.iife.min.js'))}\n</script>\n"
                f'<script type="application/json" id="plots">{data}</script>\n'
                f"<script>\n{read(os.path.join(HERE, 'page.js'))}</script>\n</body>\n</html>\n")


def title_of(scene, folder):
    """The title of the scene, else the name of the folder."""
    for line in scene.splitlines():
        if line.startswith("title:"):
            words = line[6:].strip().strip("\"'")
            if words:
                return words
    return os.path.basename(os.path.abspath(folder))


def make(folder, out, scene):
    page = Page(folder)
    path = page.path("report.json")
    try:
        report = json.loads(read(path)) if path else {}
    except ValueError as error:
        raise Mistake(f"{path}: cannot be read: {error}") from error
    if not report and not page.path("ablate.csv") and not page.path("speed_error.csv"):
        raise Mistake(f"{folder}: holds neither report.json of a run nor a table of an ablation")
    if report:
        page.add_report(report, "\nunits: none" in scene)
    page.add_ablation()
    page.add_pictures()
    page.add_tables()
    page.add_stages(report)
    page.add_rest(report, scene)
    text = page.text(title_of(scene, folder))
    with open(out + ".part", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(out + ".part", out)


def main(arguments):
    if len(arguments) not in (3, 4):
        print(__doc__, file=sys.stderr)
        return 2
    try:
        make(arguments[1], arguments[2], read(arguments[3]) if len(arguments) > 3 else "")
    except (Mistake, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
