#!/usr/bin/env python3
"""plots.py [--to FOLDER] [FOLDER]...: draws the CSV files that `windrow pareto`, `plants` and `verify --plots` wrote.

Each plot is an .svg beside its CSV, or in the folder behind --to; the fronts of pareto are a .png too. Without a folder:
out/pareto and out/plants.
./dev plots installs what it needs (Debian's python3-matplotlib) and runs it.
"""
import argparse
import csv
import pathlib
import sys

PAPER, INK, DIM, HAIRLINE = "#FBFAF7", "#1C222B", "#69717E", "#D5D4CE"
# Okabe and Ito's palette, darkened where it is too pale for thin lines.
SERIES = ("#0072B2", "#D55E00", "#009E73", "#B0568F", "#2E9BD6", "#B8860B", "#5B4B3A", "#1C222B")
DPI = 100  # page units a inch: sizes below are pixels


def read(file):
    with open(file, newline="", encoding="utf-8") as text:
        return list(csv.DictReader(text))


def by_key(rows, key):
    """Rows in groups of one value, both in the order of the file."""
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return groups


class Page:
    """A figure of `width` x `height` pixels; places count from its upper left corner."""

    def __init__(self, plt, width, height):
        self.plt, self.width, self.height = plt, width, height
        self.figure = plt.figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor=PAPER)

    def axes(self, left, top, width, height, title, x, y, x_range, y_range):
        axes = self.figure.add_axes((left / self.width, 1 - (top + height) / self.height, width / self.width, height / self.height))
        axes.set(facecolor=PAPER, xlim=x_range, ylim=y_range)
        axes.set_title(title, loc="left", fontsize=12, fontweight="bold", color=INK, pad=9)
        axes.set_xlabel(x, fontsize=10.5, color=INK, labelpad=7)
        axes.set_ylabel(y, fontsize=10.5, color=INK, labelpad=7)
        axes.grid(True, color=HAIRLINE, linewidth=0.75)
        axes.tick_params(which="both", length=0, labelsize=9.5, labelcolor=DIM, pad=6)
        axes.set_axisbelow(True)
        for spine in axes.spines.values():
            spine.set(color=DIM, linewidth=0.75)
        return axes

    def text(self, x, y, words, **style):
        self.figure.text(x / self.width, 1 - y / self.height, words, color=style.pop("color", INK), **style)

    def save(self, *files):
        for file in files:
            self.figure.savefig(file, facecolor=PAPER, dpi=1.25 * DPI if file.suffix == ".png" else DPI,
                                metadata={"Date": None} if file.suffix == ".svg" else None)
            if file.suffix == ".svg":  # its reader may have another font
                text = file.read_text(encoding="utf-8").replace("'DejaVu Sans'", "'DejaVu Sans', Verdana, sans-serif")
                file.write_text(text, encoding="utf-8")
            print(f"plots: {file}")
        self.plt.close(self.figure)


# --- Curves: plot, panel, line, x, y ------------------------------------------------------------------------------------


def lines_of(rows, plot, panel=""):
    """Name, x and y of each line of a panel."""
    chosen = [row for row in rows if (row["plot"], row["panel"]) == (plot, panel)]
    return [(name, [float(row["x"]) for row in line], [float(row["y"]) for row in line])
            for name, line in by_key(chosen, "line").items()]


def label(axes, words, x, y, colour, **style):
    axes.annotate(words, (x, y), xytext=(5, 0), textcoords="offset points", color=colour, fontsize=9.5,
                  va=style.pop("va", "center"), annotation_clip=False, **style)


def steps(low, high, step):
    return [low + n * step for n in range(int((high - low) / step + 1e-6) + 1)]


def draw_bend(plt, rows, folder):
    page = Page(plt, 1000, 640)
    axes = page.axes(90, 60, 770, 500, "How far plants lean in a steady wind", "wind at the plant [m/s]",
                     "lean of the tip [degrees]", (0, 30), (0, 90))
    axes.set_yticks(range(0, 91, 15))
    moved = {"wheat": 1.5, "leaf": -1.5}  # names that would meet
    for colour, (name, x, y) in zip(SERIES, lines_of(rows, "bend")):
        axes.plot(x, y, color=colour, linewidth=1.7)
        label(axes, name, x[-1], y[-1] + moved.get(name, 0), colour)
    page.save(folder / "bend.svg")


def draw_blades(plt, rows, folder):
    page = Page(plt, 1120, 520)
    for left, panel, title in ((90, "bent", "Bent: its length stays"),
                               (640, "translated", "Translated by the same tip's way: it stretches")):
        axes = page.axes(left, 60, 440, 374, title, "downwind [m]", "height [m]", (0, 0.4), (0, 0.34))
        axes.set_xticks(steps(0, 0.4, 0.1))
        axes.set_yticks(steps(0, 0.3, 0.1))
        for colour, (speed, x, y) in zip(SERIES, lines_of(rows, "blades", panel)):
            axes.plot(x, y, color=colour, linewidth=1.8)
            if panel == "bent":
                label(axes, speed + (" m/s" if speed == "0.5" else ""), x[-1], y[-1], colour, va="bottom")
    page.save(folder / "blades.svg")


def draw_shells(plt, rows, folder):
    page = Page(plt, 1120, 370)
    for left, panel, title in ((90, "stems", "Stems: bent by 7 m/s and by their weight"),
                               (640, "translated", "Push h^2 and droop, inward parts removed")):
        axes = page.axes(left, 60, 440, 220, title, "downwind [m]", "height [m]", (-0.5, 0.6), (0, 0.55))
        axes.set_xticks(steps(-0.5, 0.5, 0.25))
        axes.set_yticks(steps(0, 0.5, 0.1))
        for name, x, y in lines_of(rows, "shells", panel):
            if name.startswith("strand"):
                axes.plot(x, y, color=SERIES[1], linewidth=1.2)
            elif name == "shell 0":
                axes.plot(x, y, color=INK, linewidth=2)
            else:
                axes.plot(x, y, color=SERIES[2], linewidth=0.9, alpha=0.75)
    page.save(folder / "shells.svg")


def draw_spring(plt, rows, folder):
    page = Page(plt, 1000, 520)
    axes = page.axes(90, 60, 770, 380, "Wheat in a gust that comes at once: the same swing at 15 to 1000 Hz", "time [s]",
                     "fraction of the steady lean", (0, 2), (0, 1.8))
    axes.set_xticks(steps(0, 2, 0.25))
    axes.set_yticks(steps(0, 1.75, 0.25))
    for n, (name, x, y) in enumerate(lines_of(rows, "spring")):
        if n == 0:
            axes.plot(x, y, color=SERIES[n], linewidth=1.5)
        else:  # its frames alone: they lie on the curve
            axes.plot(x, y, "o", color=SERIES[n], markerfacecolor="none", markersize=1.5 * (1.2 + n), markeredgewidth=1)
        label(axes, name, 2, 1.4 - 0.12 * n, SERIES[n])
    page.save(folder / "spring.svg")


def draw_cascade(plt, rows, folder):
    page = Page(plt, 1000, 520)
    axes = page.axes(90, 60, 870, 380, "The tip of a fur whose body jumps, at 60 Hz", "time after the body's jump [s]",
                     "way of the tip", (0, 12), (0, 1.1))
    axes.set_xticks(range(13))
    axes.set_yticks(steps(0, 1, 0.25))
    names = ("stages, 20 shells (wide)", "a fraction a frame, 20 shells", "stages, 200 shells: on the same line",
             "a fraction a frame, 200 shells")
    for n, (name, (_, x, y)) in enumerate(zip(names, lines_of(rows, "cascade"))):
        # Where the two on stages lie on each other, the wide one shows beside the narrow one.
        axes.plot(x, y, color=SERIES[n], linewidth=4.5 if n == 0 else 1.5)
        label(axes, name, 2.5, 0.74 - 0.09 * n, SERIES[n])
    page.save(folder / "cascade.svg")


def draw_plants(plt, rows, folder):
    for draw in (draw_bend, draw_blades, draw_shells, draw_spring, draw_cascade):
        draw(plt, rows, folder)


def draw_jets(plt, rows, folder):
    """Half-width, speed on the axis and what varies of it against the distance, with what experiments found."""
    page = Page(plt, 1240, 440)
    far = 14
    decay = [6 + 0.25 * n for n in range(33)]
    panels = (("half-width", "Half-width", "r_half / d", 1.6, 0.4, "0.094 and 0.102 x / d",
               [([5, far], [5 * spread, far * spread]) for spread in (0.094, 0.102)]),
              ("mean", "Mean on the axis", "u_c / U", 1.2, 0.2, "6 d / x", [(decay, [6 / x for x in decay])]),
              ("swing", "What varies on the axis", "u' / u_c", 0.5, 0.1, "0.25 and 0.28",
               [([6, far], [weight, weight]) for weight in (0.25, 0.28)]))
    for n, (panel, title, y_title, high, step, words, published) in enumerate(panels):
        axes = page.axes(80 + 410 * n, 60, 310, 300, title, "x / d", y_title, (0, far), (0, high))
        axes.set_xticks(range(0, far + 1, 2))
        axes.set_yticks(steps(0, high, step))
        for x, y in published:
            axes.plot(x, y, color=DIM, linewidth=1.1, linestyle=(0, (4, 3)))
        for m, (name, x, y) in enumerate(lines_of(rows, "jet_spreading", panel)):
            axes.plot(x, y, color=SERIES[m], linewidth=1.5)
            if n == 0:
                label(axes, name, 0.3, (1.5, 1.39)[m], SERIES[m])
        label(axes, words + " (Pope 2000)", 0.3, {"half-width": 1.28, "mean": 0.1, "swing": 0.43}[panel], DIM)
    page.save(folder / "jets.svg")


# --- Fronts: what `windrow pareto` found --------------------------------------------------------------------------------

TITLES = {"taylor_green_2d": "Vortices carried by a wind (2D, periodic, exact)",
          "vortex_pair": "A pair of vortices in a wind (2D, open boundaries)",
          "abc_flow": "Interwoven vortices carried by a wind (3D, periodic, exact)",
          "jet": "A motor's jet in a wind over a floor (3D, open boundaries)",
          "gusty_fan": "A circling fan in gusts over a log profile (3D, open boundaries)",
          "house": "A wind around a house and a ball (3D, open boundaries)"}
# Two blues and two oranges that eyes of all kinds tell apart. Based on: Okabe & Ito 2008, Color Universal Design.
COLOURS = {("second_order", "cubic"): ("#0060A8", "second-order step, cubic advection"),
           ("second_order", "linear"): ("#56B4E9", "second-order step, linear advection"),
           ("stable_fluids", "cubic"): ("#C44E00", "classic split (stable fluids), cubic advection"),
           ("stable_fluids", "linear"): ("#F0AE20", "classic split (stable fluids), linear advection")}
SHAPES = {"direct": ("o", "direct solve"), "multigrid": ("D", "multigrid, 2 cycles"), "jacobi80": ("s", "80 Jacobi sweeps"),
          "jacobi40": ("^", "40 Jacobi sweeps"), "jacobi20": ("v", "20 Jacobi sweeps")}
DEFAULT = ("second_order", "cubic", "direct")
WORST_DRAWN = 3.0  # an error of 300 % is no flow any more; what is above lies on the upper edge


def front_of(points):
    """Of (cost, error): the indices of those that nothing beats, by rising cost."""
    front, least = [], float("inf")
    for n in sorted((n for n, point in enumerate(points) if all(value < float("inf") for value in point)),
                    key=lambda n: points[n]):
        if points[n][1] < least or (front and points[n] == points[front[-1]]):
            front.append(n)
            least = points[n][1]
    return front


class Labels:
    """Places for labels beside points: of some around each the one that covers least of what is drawn already. Pixels, y up."""
    # A front falls to the right and has nothing beneath it: first below and to the left, nearer places before farther ones.
    OFFSETS = ((-12, -13, "right"), (-14, -1, "right"), (0, -22, "center"), (-20, -28, "right"), (12, 13, "left"), (14, -1, "left"),
               (12, -15, "left"), (-30, -44, "right"), (-48, -22, "right"), (-10, -48, "right"), (0, -60, "center"),
               (-60, -58, "right"), (30, 29, "left"), (-80, -40, "right"), (-30, -80, "right"), (40, -36, "left"),
               (-90, -86, "right"), (-120, -66, "right"), (50, 49, "left"))
    SIZE = 12

    def __init__(self, room):
        self.room, self.things = room, []

    def avoid(self, left, low, right, high, weight):
        self.things.append((left, low, right, high, weight))

    def find(self, words, x, y):
        width = 0.6 * self.SIZE * len(words)
        best = None
        for n, (dx, dy, align) in enumerate(self.OFFSETS):
            left = x + dx - width * {"left": 0, "center": 0.5, "right": 1}[align]
            rect = (left, y + dy - 0.55 * self.SIZE, left + width, y + dy + 0.55 * self.SIZE)
            cost = 0.002 * n
            for thing in self.things:
                shared = (max(0, min(rect[2], thing[2]) - max(rect[0], thing[0])) *
                          max(0, min(rect[3], thing[3]) - max(rect[1], thing[1])))
                if shared > 0:
                    cost += thing[4] * min(1, shared / (0.25 * (thing[2] - thing[0]) * (thing[3] - thing[1])))
            if rect[0] < self.room[0] or rect[1] < self.room[1] or rect[2] > self.room[2] or rect[3] > self.room[3]:
                cost += 1e6
            if best is None or cost < best[0]:
                best = (cost, rect, dx, dy, align)
        _, rect, dx, dy, align = best
        self.avoid(rect[0] - 2, rect[1] - 2, rect[2] + 2, rect[3] + 2, 50)
        return dx, dy, align


def time_text(ms, _=None):
    return f"{ms / 1000:g} s" if ms >= 1000 else f"{ms:g} ms"


def ticks_of(low, high):
    """1, 2, 5 (or 1 alone where there are many decades) times a power of ten, within the ends."""
    many = high / low > 2000
    return [step * 10.0 ** decade for decade in range(-12, 12) for step in ((1,) if many else (1, 2, 5))
            if low <= step * 10.0 ** decade <= high]


def draw_panel(page, rows, title, runner, frame):
    points = [(float(row["ms_per_second"]), float(row["error"])) for row in rows]
    finite = [error for _, error in points if 0 < error <= WORST_DRAWN]
    costs = [cost for cost, _ in points if cost > 0]
    x_range = (min(costs) / 3.5, max(costs) * 1.4)  # room for labels at the left
    y_range = (min(finite) / 2.2, min(max(finite), WORST_DRAWN) * 1.5)
    axes = page.axes(*frame, title, f"computing time for one second of flow ({runner})", "error of the velocity at the end",
                     x_range, y_range)
    axes.set(xscale="log", yscale="log")
    axes.minorticks_off()
    axes.set_xticks(ticks_of(*x_range), [time_text(value) for value in ticks_of(*x_range)])
    axes.set_yticks(ticks_of(*y_range), [f"{round(100 * value, 7):g} %" for value in ticks_of(*y_range)])
    axes.set(xlim=x_range, ylim=y_range)
    front = front_of(points)
    # On the upper edge where there is no error to speak of.
    places = [(cost, min(max(error, y_range[0]), y_range[1]) if error <= WORST_DRAWN else y_range[1]) for cost, error in points]
    pixels = axes.transData.transform(places)
    corners = axes.transAxes.transform([(0, 0), (1, 1)])
    labels = Labels((corners[0][0] + 3, corners[0][1] + 3, corners[1][0] - 3, corners[1][1] - 3))

    def mark(n, size, strength, **edge):
        row = rows[n]
        axes.plot(*places[n], SHAPES[row["pressure"]][0], color=COLOURS[row["scheme"], row["advection"]][0], alpha=strength,
                  markersize=size * (0.8 if row["pressure"] == "multigrid" else 1), clip_on=False,
                  **(edge or {"markeredgewidth": 0}))

    def is_default(n):
        return (rows[n]["scheme"], rows[n]["advection"], rows[n]["pressure"]) == DEFAULT

    for n, (x, y) in enumerate(pixels):
        if n not in front:
            mark(n, 5, 0.42)
            labels.avoid(x - 3.6, y - 3.6, x + 3.6, y + 3.6, 0.4)
    for n in range(len(rows)):
        if is_default(n):
            axes.plot(*places[n], "o", markersize=14, markerfacecolor="none", markeredgecolor=INK, markeredgewidth=1, clip_on=False)
    axes.plot(*zip(*[places[n] for n in front]), color=INK, alpha=0.75, linewidth=1.35)
    for a, b in zip(front, front[1:]):
        for part in range(1, 12):
            x, y = pixels[a] + part / 12 * (pixels[b] - pixels[a])
            labels.avoid(x - 2, y - 2, x + 2, y + 2, 1)
    for n in front:
        mark(n, 8, 1, markeredgecolor=INK, markeredgewidth=0.75)
        radius = 9.5 if is_default(n) else 5.6
        labels.avoid(pixels[n][0] - radius, pixels[n][1] - radius, pixels[n][0] + radius, pixels[n][1] + radius, 12)
    named = None  # the grid is named where it changes
    for n in front:
        words = ("" if rows[n]["grid"] == named else rows[n]["grid"] + ", ") + "CFL " + rows[n]["cfl"]
        named = rows[n]["grid"]
        dx, dy, align = labels.find(words, *pixels[n])
        far = abs(dx) + abs(dy) > 30
        axes.annotate(words, places[n], xytext=(dx * 72 / DPI, dy * 72 / DPI), textcoords="offset points", ha=align, va="center",
                      fontsize=9, color=INK, arrowprops={"arrowstyle": "-", "color": DIM, "linewidth": 0.6} if far else None)


def draw_legend(plt, page, top):
    from matplotlib.lines import Line2D
    marker = {"linestyle": "none", "markersize": 9, "markeredgewidth": 0}
    ring = {"markerfacecolor": "none", "markeredgecolor": INK, "markeredgewidth": 1, "linestyle": "none", "markersize": 11}
    blank = {"linestyle": "none", "color": PAPER}
    columns = ((100, "Colour: time step and advection",
                [(Line2D([], [], marker="o", color=colour, **marker), words) for colour, words in COLOURS.values()]),
               (620, "Shape: pressure",
                [(Line2D([], [], marker=shape, color=DIM, **marker), words) for shape, words in SHAPES.values()]),
               (960, "Marks",
                [(Line2D([], [], color=INK, linewidth=1.35), "the front: whatever is as exact takes longer"),
                 (Line2D([], [], marker="o", **ring), "what a Wind does by default: second-order, cubic, direct"),
                 (Line2D([], [], marker="o", color=DIM, alpha=0.42, linestyle="none", markersize=6, markeredgewidth=0),
                  "pale points are beaten: something is as quick and more exact"),
                 (Line2D([], [], **blank), "CFL: cells that the fastest air crosses in a step"),
                 (Line2D([], [], **blank), "on the upper edge: the flow was lost, error above 300 %")]))
    for left, title, entries in columns:
        legend = page.figure.legend([entry[0] for entry in entries], [entry[1] for entry in entries], title=title,
                                    loc="upper left", bbox_to_anchor=(left / page.width, 1 - top / page.height),
                                    borderaxespad=0, frameon=False, fontsize=10.5, labelspacing=0.75, borderpad=0, handlelength=1.2,
                                    alignment="left", labelcolor=INK)
        legend.get_title().set(fontsize=10.5, fontweight="bold", color=INK)


def draw_pareto(plt, rows, folder):
    most = max(int(row["threads"]) for row in rows)
    flows = list(by_key([row for row in rows if int(row["threads"]) == most], "case").items())
    header, row_height, panel_height, left, between, right = 116, 544, 440, 100, 110, 30
    lines = (len(flows) + 1) // 2
    page = Page(plt, 1600, header + lines * row_height + 190)
    page.text(34, 42, "Speed against error: the least error that can be had for the time", fontsize=18.5, fontweight="bold")
    page.text(34, 70, "Each point is one method on one grid with one time step. Lower is more exact, further left is quicker. "
              + rows[0]["machine"] + ".", fontsize=11, color=DIM)
    runner = ("the device, to the end of each step" if rows[0]["backend"] == "vulkan" else
              f"{most} thread{'' if most == 1 else 's'}")
    width = (page.width - left - right - (0 if len(flows) == 1 else between)) / min(len(flows), 2)
    for n, (name, runs) in enumerate(flows):
        frame = (left + n % 2 * (width + between), header + n // 2 * row_height, width, panel_height)
        draw_panel(page, runs, TITLES.get(name, name), runner, frame)
    draw_legend(plt, page, header + lines * row_height + 8)
    page.save(folder / "pareto.svg", folder / "pareto.png")


DRAWS = {"pareto.csv": draw_pareto, "plants.csv": draw_plants, "jet_spreading.csv": draw_jets}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--to", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("folders", nargs="*", type=pathlib.Path, default=[pathlib.Path("out/pareto"), pathlib.Path("out/plants")],
                        metavar="FOLDER")
    asked = parser.parse_args()
    folders = asked.folders
    found = [folder / name for folder in folders for name in DRAWS if (folder / name).is_file()]
    if not found:
        print(f"plots: no {', '.join(DRAWS)} in {', '.join(map(str, folders))}: run windrow pareto, plants or verify --plots first.",
              file=sys.stderr)
        return 2
    try:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
    except ImportError:
        print(f"plots: the figures are in {', '.join(map(str, found))}; install python3-matplotlib to have them drawn.",
              file=sys.stderr)
        return 3
    plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "windrow", "font.family": "DejaVu Sans"})
    if asked.to:
        asked.to.mkdir(parents=True, exist_ok=True)
    for file in found:
        DRAWS[file.name](plt, read(file), asked.to or file.parent)
    return 0


if __name__ == "__main__":
    sys.exit(main())
