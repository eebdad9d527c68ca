#!/usr/bin/env python3
"""scaling.py BIN [--mesh FILE] [--scheme S] [--levels N] [--output DIR] [--repeats R] [--plot SVG]: seconds of each phase of kith-mpi on 1, 2, 4 and
8 ranks, and on one process without MPI, for one surface (strong) and for one that grows with the ranks (weak). Then a curve to 1024
ranks, which is computed: one process does all that the ranks would do, in as many tiles, and the rank with the largest share of the
faces, which `kith plan` tells, has that share of refining and writing. BIN has kith and kith-mpi. Without FILE the surface is a
torus. BIN/plot draws the measured jobs into SVG, with lines of ideal scaling from one rank on."""

import argparse
import json
import math
import os
import statistics
import subprocess
import tempfile
import time

PHASES = ("read", "partition", "cut", "send", "refine", "write", "wait")
MEASURED = (1, 2, 4, 8)
COMPUTED = (16, 64, 256, 1024)


def write_torus(path, rows, columns):
    """Writes a torus of so many quads in OFF."""
    with open(path, "w") as out:
        print("OFF", rows * columns, rows * columns, 0, file=out)
        for i in range(rows):
            for j in range(columns):
                a, b = 2 * math.pi * i / rows, 2 * math.pi * j / columns
                print(math.cos(a) * (3 + math.cos(b)), math.sin(a) * (3 + math.cos(b)), math.sin(b), file=out)
        for i in range(rows):
            for j in range(columns):
                k, m = (i + 1) % rows, (j + 1) % columns
                print(4, i * columns + j, k * columns + j, k * columns + m, i * columns + m, file=out)


class Jobs:
    """The programs and what they refine."""

    def __init__(self, options, directory):
        self.options = options
        self.stats = os.path.join(directory, "stats")
        self.output = os.path.join(directory, "out." + options.format)
        self.environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1")

    def refine(self, mesh, ranks, tiles=None):
        """Returns the seconds of a job, and those of its phases on each rank. No ranks: one process without MPI."""
        words = ["refine", mesh, "-s", self.options.scheme, "-n", str(self.options.levels), "-o", self.output, "--stats", self.stats]
        program = [os.path.join(self.options.bin, "kith-mpi" if ranks else "kith")]
        if ranks:
            program = ["mpirun", "-n", str(ranks)] + program
        elif self.options.format == "ply":
            words.append("--binary")
        if tiles:
            words += ["--tiles", str(tiles)]
        since = time.monotonic()
        subprocess.run(program + words, check=True, stdout=subprocess.DEVNULL, env=self.environment)
        seconds = time.monotonic() - since
        with open(self.stats) as lines:
            told = [json.loads(line) for line in lines][:ranks or 1]
        return seconds, [{**rank["seconds"], "processor": rank["processor_seconds"]} for rank in told]

    def plan(self, mesh, ranks):
        """Returns the largest share of the last faces that a rank has, and the bytes that rank 0 sends to others."""
        words = ["plan", mesh, "-s", self.options.scheme, "-n", str(self.options.levels), "--ranks", str(ranks), "--json"]
        told = subprocess.run([os.path.join(self.options.bin, "kith")] + words, check=True, capture_output=True, text=True)
        each = json.loads(told.stdout)["ranks"]
        faces = [rank["last_faces"] for rank in each]
        return max(faces) / sum(faces), sum(rank["message_bytes"] for rank in each[1:])

    def medians(self, meshes, ranks_of):
        """Returns the medians of jobs that take turns: of their seconds, and of each phase on the rank where it took longest."""
        runs = {ranks: [] for ranks in ranks_of}
        for _ in range(self.options.repeats):
            for ranks in ranks_of:
                runs[ranks].append(self.refine(meshes[ranks], ranks))
        result = {}
        for ranks, of in runs.items():
            result[ranks] = {"job": statistics.median(seconds for seconds, _ in of)}
            for phase in PHASES + ("processor",):
                result[ranks][phase] = statistics.median(max(rank[phase] for rank in phases) for _, phases in of)
        return result


def print_table(title, rows):
    print(f"\n{title}\n")
    print("| ranks | job | " + " | ".join(PHASES) + " | processor |")
    print("|" + "---|" * (len(PHASES) + 3))
    for ranks, row in rows.items():
        print(f"| {ranks or 'no MPI'} | {row['job']:.2f} | " + " | ".join(f"{row[phase]:.3f}" for phase in PHASES) +
              f" | {row['processor']:.2f} |")


def print_curve(jobs, mesh, rows):
    """Prints the computed seconds of one surface on many ranks."""
    one, most = rows[1], max(MEASURED)
    start = one["job"] - sum(one[phase] for phase in PHASES)  # of MPI and the processes
    seconds_per_byte = rows[most]["send"] / jobs.plan(mesh, most)[1]
    print("\nOne surface on more ranks, computed; seconds\n")
    print("| ranks | read | partition | cut | send | refine | write | times as fast as 1 rank |")
    print("|---|---|---|---|---|---|---|---|")
    for ranks in COMPUTED:
        runs = [jobs.refine(mesh, 0, ranks)[1][0] for _ in range(jobs.options.repeats)]
        share, sent = jobs.plan(mesh, ranks)
        phases = {phase: statistics.median(run[phase] for run in runs) for phase in PHASES}
        row = [phases["read"], phases["partition"], phases["cut"], sent * seconds_per_byte, phases["refine"] * share, phases["write"] * share]
        print(f"| {ranks} | " + " | ".join(f"{x:.4f}" for x in row) + f" | {(one['job'] - start) / sum(row):.1f} |")
    print(f"\nRank 0 reads, partitions, cuts and sends alone. Not counted: {start:.2f} s until MPI has started and ended, and what ranks "
          "wait for one another at a file.")


def plot_of(title, rows, ideal):
    """Returns the plot of jobs of MPI. `ideal` takes the seconds on one rank and a number of ranks."""
    rows = {ranks: row for ranks, row in rows.items() if ranks}
    curves = [{"name": name, "points": [[ranks, row[name]] for ranks, row in rows.items()], "is_dashed": False}
              for name in ("job", "refine", "write")]
    curves += [{"name": "ideal", "points": [[ranks, ideal(rows[1][name], ranks)] for ranks in rows], "is_dashed": True}
               for name in ("job", "refine")]
    return {"title": title, "x": {"title": "ranks", "is_logarithmic": True},
            "y": {"title": "seconds", "is_logarithmic": True}, "curves": curves}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bin")
    parser.add_argument("--mesh")
    parser.add_argument("--scheme", default="catmull-clark")
    parser.add_argument("--levels", type=int, default=5)
    parser.add_argument("--format", default="ply", choices=("ply", "vtu"))
    parser.add_argument("--output", help="the directory to write to; a temporary one if not given")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--plot", help="the .svg to draw the measured jobs into")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.output) as directory:
        jobs = Jobs(options, directory)
        torus = {ranks: os.path.join(directory, f"torus{ranks}.off") for ranks in MEASURED}
        for ranks, path in torus.items():
            write_torus(path, 48 * ranks, 64)
        mesh = options.mesh or torus[4]
        strong = jobs.medians(dict.fromkeys((0,) + MEASURED, mesh), (0,) + MEASURED)
        print_table(f"{os.path.basename(mesh)}, {options.scheme}, {options.levels} levels, .{options.format}: "
                    "seconds of each phase, on the rank where it takes longest", strong)
        plots = [plot_of("One surface (strong scaling)", strong, lambda one, ranks: one / ranks)]
        if not options.mesh:
            weak = jobs.medians(torus, MEASURED)
            print_table("A torus of 3072 quads for each rank", weak)
            plots.append(plot_of("As much surface for each rank (weak scaling)", weak, lambda one, ranks: one))
        if options.plot:
            note = (f"{options.scheme}, {options.levels} levels, .{options.format}: seconds on the slowest rank, medians of "
                    f"{options.repeats}; {os.cpu_count()} processors")
            subprocess.run([os.path.join(options.bin, "plot"), options.plot], check=True, text=True,
                           input=json.dumps({"note": note, "plots": plots}))
        print_curve(jobs, mesh, strong)


if __name__ == "__main__":
    main()
