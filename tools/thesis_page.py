#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""thesis_page.py [BIN, usually build/release/bin]: makes docs/thesis_figures.md and its pictures again.

The counts of the thesis's tables are compared with those of kith; another count is an error. The pictures and the page
have the same bytes on one machine, but for the seconds.
"""
import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BIN = os.path.join(ROOT, sys.argv[1] if len(sys.argv) > 1 else "build/release/bin")
DOCS = os.path.join(ROOT, "docs")

# Table 2.1: scheme, elements, refinement operator, smoothing operator. The thesis leaves the last cell of 4-8 empty.
CLASSES = [
    ("catmull-clark", "quads", "primal", "approximating"), ("doo-sabin", "quads", "dual", "approximating"),
    ("loop", "triangles", "primal", "approximating"), ("sqrt3", "triangles", "primal and edge flip", "approximating"),
    ("butterfly", "triangles", "primal", "interpolating"), ("kobbelt", "quads", "primal", "interpolating"),
    ("4-8", "triangles", "alternating face and vertex", ""), ("nasri-hasbini", "quads", "ternary", "approximating"),
]
# Each row has vertices, edges, faces, seconds or None, and the size as printed.
TABLES = [
    ("1.1", "a cube", "cube", "catmull-clark", [
        (8, 12, 6, None, "2.4 KB"), (26, 48, 24, None, "7.4 KB"), (98, 192, 96, None, "27.7 KB"),
        (386, 768, 384, None, "108.7 KB"), (1538, 3072, 1536, None, "432.7 KB"),
        (6146, 12288, 6144, None, "1.7 MB"), (24578, 49152, 24576, None, "6.8 MB"),
        (98306, 196608, 98304, None, "27.0 MB"), (393218, 786432, 393216, None, "108.0 MB"),
        (1572866, 3145728, 1572864, None, "432.0 MB")]),
    ("2.2", "the torus", "torus", "catmull-clark", [
        (288, 576, 288, 0, "162.1 KB"), (1152, 2304, 1152, .01, "324.0 KB"), (4608, 9216, 4608, .03, "1.3 MB"),
        (18432, 36864, 18432, .09, "5.1 MB"), (73728, 147456, 73728, .42, "20.2 MB"),
        (294912, 589824, 294912, 1.67, "81.0 MB"), (1179648, 2359296, 1179648, 6.68, "324.0 MB"),
        (4718592, 9437184, 4718592, 31.9, "1.3 GB")]),
    ("2.3", "the cupid", "cupid", "catmull-clark", [
        (6713, 14235, 7532, 0, "3.1 MB"), (28480, 56940, 28470, .26, "10.0 MB"),
        (113890, 227760, 113880, 1.31, "34.8 MB"), (455530, 911040, 455520, 5.27, "139.0 MB"),
        (1822090, 3644160, 1822080, 20.98, "556.1 MB")]),
    ("2.4", "the torus", "torus", "nasri-hasbini", [
        (288, 576, 288, 0, "162.1 KB"), (2592, 5184, 2592, .05, "1.3 MB"), (23328, 46656, 23328, .36, "11.4 MB"),
        (209952, 419904, 209952, 3.25, "102.5 MB")]),
    ("2.5", "the cupid", "cupid", "doo-sabin", [
        (6713, 14235, 7532, 0, "3.1 MB"), (28470, 56940, 28480, .5, "10.0 MB"),
        (113880, 227760, 113890, 3.37, "34.8 MB"), (455520, 911040, 455530, 40.96, "139.0 MB"),
        (1822080, 3644160, 1822090, 1349.99, "556.1 MB")]),
]
# Each figure has its numbers, mesh, scheme, the levels that are shown or None for the limit surface, and a name.
FIGURES = [
    ("2.1, 2.26", "torus", "catmull-clark", "0,1,2", "torus"),
    ("2.7", "cube", "catmull-clark", "0,1,2,3", "cube"),
    ("2.8", "axe", "catmull-clark", "0,1,2,3", "axe"),
    ("2.11", "cube", "doo-sabin", "0,1,2,3", "cube"),
    ("2.12", "pentacube", "doo-sabin", "0,1,2,3", "pentacube"),
    ("2.14", "triangulated_cube", "loop", "0,1,2,3", "triangulated cube"),
    ("2.15", "gourd", "loop", "0,1,2", "gourd"),
    ("2.19", "triangulated_cube", "sqrt3", "0,1,2,3", "triangulated cube"),
    ("2.20", "rook", "sqrt3", "0,1,2", "rook"),
    ("2.24", "hollow_cube", "nasri-hasbini", "0,1,2", "hollow cube"),
    ("2.27", "cupid", "catmull-clark", None, "cupid"),
    ("4.15", "t_shape", "catmull-clark", "0,1,2,3", "T with creases"),
]
TITLES = {"catmull-clark": "Catmull-Clark", "doo-sabin": "Doo-Sabin", "loop": "Loop", "sqrt3": "√3",
          "nasri-hasbini": "Nasri-Hasbini"}


def kith(*words):
    return subprocess.run([os.path.join(BIN, "kith"), *words], check=True, capture_output=True, text=True).stdout


def size(number):
    for unit in ("B", "KB", "MB"):
        if number < 1000:
            return f"{number:.3g} {unit}"
        number /= 1024
    return f"{number:.3g} GB"


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        facts = dict(line.split(":", 1) for line in file.read().split("\n\n")[0].splitlines())
    name, family, model = (facts[key + "\t" * tabs].strip() for key, tabs in (("model name", 1), ("cpu family", 1),
                                                                             ("model", 2)))
    return f"{name}, family {family}, model {model}"


def seconds(mesh, scheme, level, folder):
    """Returns the seconds that kith takes on one thread to make a level, the least of three runs."""
    stats, output = os.path.join(folder, "stats.json"), os.path.join(folder, "fine.ply")
    runs = []
    for _ in range(3):
        kith("refine", mesh, "-s", scheme, "-n", str(level), "-o", output, "--binary", "--threads", "1", "--stats", stats)
        with open(stats, encoding="utf-8") as file:
            runs.append(json.load(file)["seconds"]["refine"])
    return min(runs)


def classification():
    takes = {scheme["name"]: scheme["takes"] for scheme in json.loads(kith("schemes", "--json"))}
    return ["**Table 2.1**: the schemes; kith has more of them, see [schemes](schemes.md).", "",
            "| scheme | elements | refinement | smoothing | kith takes |", "|---|---|---|---|---|",
            *(f"| {' | '.join(row)} | {takes[row[0]]} |" for row in CLASSES), ""]


def table(number, title, mesh, scheme, rows, folder):
    path = os.path.join(folder, mesh + ".obj")
    levels = json.loads(kith("plan", path, "-s", scheme, "-n", str(len(rows) - 1), "--json"))["levels"]
    timed = rows[0][3] is not None
    lines = [f"**Table {number}**: {title}, {TITLES[scheme]}.", "",
             "| level | vertices | edges | faces | size: thesis | kith |" + (" seconds: thesis | kith |" if timed else ""),
             "|---|---|---|---|---|---|" + ("---|---|" if timed else "")]
    for level, ((*counts, told, printed), ours) in enumerate(zip(rows, levels)):
        found = [ours[kind] for kind in ("vertices", "edges", "faces")]
        if found != counts:
            sys.exit(f"table {number}, level {level}: kith has {found}, the thesis {counts}")
        line = f"| {level} | " + " | ".join(f"{n:,}" for n in counts) + f" | {printed} | {size(ours['bytes'])} |"
        if timed:
            line += f" {told:g} | " + (f"{seconds(path, scheme, level, folder):.2g} |" if level > 0 else "0 |")
        lines.append(line)
    return lines + [""]


def figure(number, mesh, scheme, levels, name, folder):
    picture = f"thesis/{mesh}_{scheme}.png".replace("-", "_")
    more = ["-n", levels, "--size", f"{220 * (levels.count(',') + 1)}x240"] if levels else [
        "--view", "20,15", "--size", "440x320"]
    kith("picture", os.path.join(folder, mesh + ".obj"), "-s", scheme, *more, "-o", os.path.join(DOCS, picture))
    shown = f"levels 0 to {levels[-1]}" if levels else "its limit surface"
    return [f"**Figure {number}**: {name}, {TITLES[scheme]}, {shown}.", "",
            f"![{name} by {TITLES[scheme]}.]({picture})", ""]


def main():
    os.makedirs(os.path.join(DOCS, "thesis"), exist_ok=True)
    lines = ["# Tables and figures of the thesis", "",
             "After reading this page you know how kith compares with the numbers that the thesis prints, and",
             "how its surfaces look.", "",
             "`tools/thesis_page.py` makes this page and its pictures. It fails if a count of a table differs.",
             "Sizes of kith are those of a level with all connectivity. Meshes whose coordinates the thesis does",
             "not give are shapes of ours with the same counts. Seconds of kith are those of one thread for the",
             "last level as lists of faces. The thesis had a Pentium 4 of 3 GHz; kith ran on this processor:",
             processor() + ".", "", "## Tables", ""]
    with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
        subprocess.run([os.path.join(BIN, "example_figures"), folder], check=True, stdout=subprocess.DEVNULL)
        for one in TABLES:
            lines += table(*one, folder) + (classification() if one[0] == "1.1" else [])
        lines += ["## Figures", ""]
        for one in FIGURES:
            lines += figure(*one, folder)
    lines += ["The diagrams of chapter 4 are drawn from associations: [the association space](concepts/association_space.md).",
              "[Ghost rings](distributed.md) shows a mesh in parts, as figures 2.28 to 2.30."]
    with open(os.path.join(DOCS, "thesis_figures.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


main()
