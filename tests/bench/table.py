"""What the benchmarks' figures say: rows of ratios and of figures beside their goals. No side effects."""

import re
import statistics

# (group, what is compared, ours, (what the other is called, its benchmark)..., goal: (which of the others, at least times))
RATIOS = [
    ("One solve", "linear systems of one frame", "linear/ours",
     [("UMFPACK", "linear/umfpack"), ("UMFPACK, ordering reused", "linear/umfpack, ordering reused"),
      ("dense LU, partial pivoting", "linear/dense LU, partial pivoting"),
      ("dense LU, full pivoting", "linear/dense LU, full pivoting")], {"UMFPACK": 20}),
    ("Tetrahedra", "one pair of bodies", "mesh/ours/real_time/threads:1",
     [("CGAL, its own order", "mesh/cgal/real_time/threads:1"),
      ("CGAL, our order, kept memory", "mesh/cgal in kept memory/real_time/threads:1"),
      ("TetGen, its own order", "mesh/tetgen/real_time/threads:1")], {}),
]
# (group, what, benchmark, counter or None for its time, unit, goal: at most)
FIGURES = [
    ("Library", "loaded into memory", "library/load", None, "ms", 500),
    ("Library", "opened and mapped", "library/load, mapped", None, "ms", None),
    ("Library", "floor: its bytes read from the page cache", "library/read bytes", None, "ms", None),
    ("Library", "built on one core", "library/build/one core", None, "ms", None),
    ("Library", "built on all cores", "library/build/all cores", None, "ms", 15000),
]
STEP_GOALS_US = {"p50_us": 500, "p99_us": 1000, "thread_p50_us": 500, "thread_p99_us": 1000}
STEP_COUNTERS = [("p50", "p50_us"), ("p95", "p95_us"), ("p99", "p99_us"), ("p50, processor", "thread_p50_us"),
                 ("p99, processor", "thread_p99_us")]
STEP_PARTS = [("p50 of retargeting", "retarget_us"), ("p50 of selecting", "select_us"), ("p50 of the mesh", "mesh_us"),
              ("p50 of editing", "solve_us")]
SCENE_COUNTERS = [("update, processor", "update_us", "us"), ("picture", "picture_ms", "ms"),
                  ("picture, processor of all threads", "picture_processor_ms", "ms")]
TO_US = {"ns": 1e-3, "us": 1.0, "ms": 1e3, "s": 1e6}


class Spread:
    """Median, least and quartiles of the repetitions."""

    def __init__(self, values):
        self.values = sorted(values)
        self.median = statistics.median(self.values)
        self.least = self.values[0]
        if len(self.values) > 1:
            self.low, _, self.high = statistics.quantiles(self.values, n=4, method="inclusive")
        else:
            self.low = self.high = self.median

    def scaled(self, factor):
        return Spread([value * factor for value in self.values])

    def as_json(self):
        return {"median": self.median, "min": self.least, "q1": self.low, "q3": self.high, "n": len(self.values)}


class Measured:
    """The repetitions of all programs by name of the benchmark; those with an error apart."""

    def __init__(self, outputs):
        self.times_us, self.counters, self.errors = {}, {}, {}
        for output in outputs:
            for run in output.get("benchmarks", []):
                if run.get("run_type") == "aggregate":
                    continue
                self.take(run)

    def take(self, run):
        name = run.get("run_name", run["name"]).removesuffix("/iterations:1/manual_time")
        for ending in ("/iterations:1", "/process_time", "/real_time"):
            if not name.startswith("mesh/"):  # its threads stand behind that
                name = name.replace(ending, "")
        if run.get("error_occurred"):
            self.errors[name] = run.get("error_message", "")
            return
        # Processor time where one thread works: what others do on the machine is not in it.
        own = "real_time" if name.startswith(("library/", "scene/")) else "cpu_time"
        self.times_us.setdefault(name, []).append(run[own] * TO_US[run["time_unit"]])
        for key, value in run.items():
            if isinstance(value, (int, float)):
                self.counters.setdefault((name, key), []).append(value)

    def time_us(self, name):
        if name in self.errors or name not in self.times_us:
            return None
        return Spread(self.times_us[name])

    def counter(self, name, counter):
        values = self.counters.get((name, counter))
        return Spread(values) if values and name not in self.errors else None

    def names(self, pattern):
        """(name, match) in the order of the numbers in them."""
        found = [(name, match) for name in {**self.times_us, **self.errors} if (match := re.fullmatch(pattern, name))]
        return sorted(found, key=lambda pair: [int(n) for n in re.findall(r"\d+", pair[0])])


def times(ours, other):
    """How many times ours goes into the other's: of the medians, and what the quartiles of both allow."""
    return {"median": other.median / ours.median, "low": other.low / ours.high, "high": other.high / ours.low,
            "of_min": other.least / ours.least}


def ratio_rows(measured):
    """Every comparison there is a figure of ours for; a competitor that failed says why."""
    compared = list(RATIOS)
    for name, match in measured.names(r"knn/ours/(\d+)/(\d+)"):
        size, count = match.groups()
        others = [(who, f"knn/{key}/{size}/{count}") for who, key in
                  [("our own tree", "own tree"), ("every distance, double", "brute double"), ("every distance, single", "brute single"),
                   ("nanoflann, best leaf", "nanoflann")]]
        goals = {"every distance, double": 8} if (size, count) == ("1000000", "10") else {}
        compared.append(("Nearest poses", f"{count} of {int(size):,}".replace(",", " "), name, others, goals))
    rows = []
    for group, what, ours, others, goals in compared:
        own = measured.time_us(ours)
        if own is None:
            continue
        for who, name in others:
            other = measured.time_us(name)
            if other is None and name not in measured.errors:
                continue
            rows.append(ratio_row(group, what, own, who, other, goals.get(who), measured.errors.get(name)))
    rows += whole_solve(measured) + builds(measured)
    return sorted(rows, key=lambda row: list(dict.fromkeys(r["group"] for r in rows)).index(row["group"]))


def ratio_row(group, what, ours, who, other, goal, error=None):
    row = {"group": group, "what": what, "ours_us": ours.as_json(), "other": who, "goal": goal, "error": error}
    if other is not None:
        row["other_us"] = other.as_json()
        row["times"] = times(ours, other)
        row["met"] = None if goal is None else row["times"]["median"] >= goal
    else:
        row["met"] = None if goal is None else False
    return row


def whole_solve(measured):
    """Everything of a step as it is, and its linear systems in the other's way: what the whole would take."""
    whole, linear = measured.time_us("whole/ours"), measured.time_us("linear/ours")
    if whole is None or linear is None:
        return []
    rows = []
    for who, name in (("UMFPACK", "linear/umfpack"), ("dense LU, partial pivoting", "linear/dense LU, partial pivoting")):
        other = measured.time_us(name)
        if other is not None:
            swapped = other.scaled((whole.median - linear.median + other.median) / other.median)
            goal = 20 if who == "UMFPACK" else None
            rows.append(ratio_row("One solve", "whole step, linear systems the other way", whole, who, swapped, goal))
    return rows


def builds(measured):
    one, both = measured.time_us("library/build/one core"), measured.time_us("library/build/all cores")
    rows = []
    if one is not None and both is not None:
        rows.append(ratio_row("Library", "built on all cores", both, "on one core", one, None))
    return rows


def figure_row(group, what, value, unit, goal, at_least=False):
    met = None if goal is None else (value.median >= goal if at_least else value.median <= goal)
    return {"group": group, "what": what, "value": value.as_json(), "unit": unit, "goal": goal,
            "at_least": at_least, "met": met}


def figure_rows(measured, packets=()):
    rows = []
    for name, match in sorted(measured.names(r"step/(.+)/(\d+) Hz(, .+)?"), key=lambda pair: pair[1].group(1) != "paper"):
        for what, counter in STEP_COUNTERS + (STEP_PARTS if match[2] == "60" else []):
            value = measured.counter(name, counter)
            if value is not None:
                more = match[3] or ""  # cold caches, other bodies: nothing is promised for them
                rows.append(figure_row("One solve", f"{match[1]} at {match[2]} Hz{more}: {what}", value, "us",
                                       None if more else STEP_GOALS_US.get(counter)))
    rows += accuracy_rows(measured)
    for name, match in measured.names(r"knn/ours/(\d+)/(\d+)"):
        value = measured.time_us(name)
        goal = 700 if match.groups() == ("1000000", "10") else None
        if value is not None:
            rows.append(figure_row("Nearest poses", f"{match[2]} of {int(match[1]):,}".replace(",", " "), value, "us", goal))
    for name, match in measured.names(r"query/(.+)/(\d+)/(\d+) cm"):
        for what in ("p50", "p99"):
            value = measured.counter(name, what + "_us")
            if value is not None:
                size = f"{int(match[2]):,}".replace(",", " ")
                rows.append(figure_row("Nearest poses", f"{match[1]}, 10 of {size}, {match[3]} cm off: {what}", value, "us", None))
    for threads in ("1", "2"):
        for who in ("ours", "cgal", "cgal in kept memory"):
            value = measured.counter(f"mesh/{who}/real_time/threads:{threads}", "real_time")
            if value is not None:
                rows.append(figure_row("Tetrahedra", f"{who}, clock per pair on {threads} thread(s)", value, "us", None))
    for group, what, name, counter, unit, goal in FIGURES:
        value = measured.time_us(name) if counter is None else measured.counter(name, counter)
        if value is not None:
            rows.append(figure_row(group, what, value.scaled(1 / TO_US[unit]) if counter is None else value, unit, goal))
    for name, match in measured.names(r"scene/(.+)/(\d+x\d+)"):
        for what, counter, unit in SCENE_COUNTERS:
            value = measured.counter(name, counter)
            if value is not None:
                rows.append(figure_row("3-D view", f"{match[1]}, {match[2]}: {what}", value, unit, None))
        value = measured.counter(name, "pictures_per_s")
        if value is not None:
            goal = 30 if match[2] == "1280x720" and match[1] == "as at the start" else None
            rows.append(figure_row("3-D view", f"{match[1]}, {match[2]}: pictures", value, "1/s", goal, at_least=True))
    return rows + packet_rows(packets)


def packet_rows(packets):
    rows = []
    for rate in sorted({run["rate_hz"] for run in packets}):
        runs = [run for run in packets if run["rate_hz"] == rate]
        for key in ("p50", "p95", "p99"):
            goal = 3 if key == "p99" and rate == 120 else None
            rows.append(figure_row("Packet to packet", f"{rate:.0f} Hz: {key}", Spread([run[key] for run in runs]), "ms", goal))
        unanswered = Spread([run["sent"] - run["answered"] for run in runs])
        rows.append(figure_row("Packet to packet", f"{rate:.0f} Hz: frames without an answer", unanswered, "", None))
    return rows


def accuracy_rows(measured):
    """How near ours is to the solution in extended precision, and the others to ours."""
    rows = []
    for who, name, counter in [("ours to extended precision", "linear/ours", "largest_error_m"),
                               *((f"{who} to ours", name, "largest_difference_m") for who, name in RATIOS[0][3])]:
        value = measured.counter(name, counter)
        if value is not None:
            rows.append(figure_row("One solve", f"{who}, farthest position", value.scaled(1e9), "nm", 10))
    return rows


def number(value):
    if value == 0:
        return "0"
    digits = 0 if abs(value) >= 100 else 1 if abs(value) >= 10 else 2 if abs(value) >= 1 else 3
    return f"{value:.{digits}f}"


def spread_text(spread):
    return f"{number(spread['median'])} ({number(spread['min'])}; {number(spread['q1'])}-{number(spread['q3'])})"


def verdict(met):
    return {None: "", True: "yes", False: "**no**"}[met]


def markdown(ratios, figures, machine):
    lines = ["# Benchmarks", ""]
    lines += [f"- {key}: {value}" for key, value in machine.items()]
    lines += ["", "Each figure: median (least; quartiles) of the repetitions. Times of one thread are processor time.", ""]
    lines += ["## Ratios", "", "| | what | ours [us] | against | theirs [us] | times | of the least | goal | met |",
              "|---|---|---|---|---|---|---|---|---|"]
    for row in ratios:
        head = f"| {row['group']} | {row['what']} | {spread_text(row['ours_us'])} | {row['other']} |"
        if "times" not in row:
            lines.append(f"{head} not compared: {row['error']} | | | {row['goal'] or ''} | {verdict(row['met'])} |")
            continue
        t = row["times"]
        goal = f"{row['goal']} x" if row["goal"] else ""
        lines.append(f"{head} {spread_text(row['other_us'])} | **{number(t['median'])}** ({number(t['low'])}-{number(t['high'])}) "
                     f"| {number(t['of_min'])} | {goal} | {verdict(row['met'])} |")
    lines += ["", "## Figures", "", "| | what | measured | unit | goal | met |", "|---|---|---|---|---|---|"]
    for row in figures:
        goal = f"{'>=' if row['at_least'] else '<='} {row['goal']}" if row["goal"] is not None else ""
        lines.append(f"| {row['group']} | {row['what']} | {spread_text(row['value'])} | {row['unit']} | {goal} | {verdict(row['met'])} |")
    return "\n".join(lines) + "\n"
