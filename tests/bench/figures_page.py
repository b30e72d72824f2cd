"""docs/figures.md out of what was measured. No side effects, and no measure of its own: every figure is a key of a JSON file."""

import hashlib
import re

import table

# The runs of `tests/bench/figures --measure`, in the order in which the page names them, and their parts of `abrazo evaluate`.
PRESETS = ("responsive", "paper")
GENERATED = {"dance": "salsa", "fight": "fight"}  # the set, its style
SETS = {"salsa": "captured salsa", "dance": "generated dance", "fight": "generated fight"}
SEED, MINUTES = 5, 3
RUNS = {
    "salsa-responsive": ["moves", "zmp", "contact", "published"],
    "salsa-paper": ["selection", "timing", "moves", "zmp", "contact", "published"],
    "dance-responsive": ["moves", "zmp", "contact"],
    "dance-paper": ["moves", "zmp", "contact"],
    "fight-responsive": ["moves", "zmp", "contact"],
    "fight-paper": ["moves", "zmp", "contact"],
    "salsa-bodies": ["bodies"],
    "salsa-labels": [], "dance-labels": [], "fight-labels": [],  # of `abrazo suggest --agreement`
}

# (title, unit, scale, path of ours in report.json, path of the captured partner's or its value, goal on captured salsa)
MOVEMENT = [
    ("partner error, mean", "m", 1, "movement.partner_error_m", None, "0.26"),
    ("speed, 99th percentile", "m/s", 1, "movement.speed_p99_m_per_s.synthesised", "movement.speed_p99_m_per_s.captured", "1.9"),
    ("acceleration, times the captured", "", 1, "movement.acceleration_ratio", 1, "1.4"),
    ("sliding of landed feet, mean", "m/s", 1, "movement.slide_m_per_s.synthesised", "movement.slide_m_per_s.captured", "0.20"),
    ("sliding, share faster than 0.3 m/s", "%", 100, "movement.slide_share_fast.synthesised", "movement.slide_share_fast.captured",
     "15"),
    ("hover of locked feet, 90th percentile", "mm", 1000, "movement.hover_p90_m", None, "15"),
    ("holds of the selected pair: change, mean", "mm", 1000, "movement.hold_change_mean_m", None, "15"),
    ("holds of the capture that are held", "%", 100, "movement.captured_holds_held", 100, "at least 70"),
    ("lag", "ms", 1000, "movement.lag_s", 0, "40"),
    ("changes of source", "1/s", 1, "movement.changes_per_s", None, "1.5"),
    ("step at a change, largest", "cm", 100, "movement.step_at_change_max_m", None, "1"),
    ("successful moves", "%", 100, "moves.rate", None, "at least 85"),
    ("ZMP error of both bodies, times the captured", "", 1, "zmp.common_frames.ratio", 1, "2"),
    ("ZMP error of the partner, times the captured", "", 1, "zmp.partner_common_frames.ratio", 1, None),
    ("penetration beyond the selected pair's, 99th percentile", "mm", 1000, "contact.penetration_excess_p99_m", None, None),
]
# (key, title, better, unit, scale) of "published"
PUBLISHED = [
    ("mpjpe_m", "MPJPE", "lower", "mm", 1000), ("mpjve_m", "MPJVE, per frame", "lower", "mm", 1000),
    ("foot_sliding_m", "foot sliding, per frame", "as recorded", "cm", 100), ("skating_share", "skating frames", "lower", "%", 100),
    ("jitter_10_m_s3", "jitter", "as recorded", "10 m/s³", 1), ("penetration_share", "frames with penetration", "lower", "%", 100),
    ("penetration_depth_m", "depth of penetration, mean", "lower", "mm", 1000),
    ("contact_precision", "contact, precision", "higher", "%", 100), ("contact_recall", "contact, recall", "higher", "%", 100),
    ("contact_f1", "contact, F1", "higher", "%", 100), ("turned_away_share", "frames turned away", "as recorded", "%", 100),
    ("beat_echo_degree", "beat echo degree", "higher", "", 1), ("fid_cd", "FID of cross-distances", "lower", "", 1),
    ("diversity", "diversity of cross-distances", "as recorded", "", 1),
]
# What the paper prints (core/evaluation/report/html_paper.hpp has the same; a test compares).
PAPER_RECALL = {5: (0.9285, 0.9573), 10: (0.9507, 0.9773), 15: (0.9654, 0.9875), 20: (0.9787, 0.9898), 25: (0.9809, 0.9898),
                30: (0.9875, 0.9920), 35: (0.9875, 0.9920), 40: (0.9875, 0.9920), 45: (0.9920, 0.9942), 50: (0.9920, 0.9942)}
SHOWN_K = (5, 10, 20, 30, 50)
PAPER_TIMES_MS = {7500: (12.4, 40.5), 15000: (13.6, 77.0), 30000: (15.0, 145.2)}
PAPER_MOVES = [("salsa dance, leave one out (expert)", 27, 26), ("salsa dance, user A (beginner)", 40, 34),
               ("salsa dance, user B (beginner)", 31, 26), ("fighting, leave one out (expert)", 26, 24)]
PAPER_ZMP = {"salsa dance": (0.70, 0.72), "fighting": (2.24, 2.21)}

SECTIONS = ["Runs", "One solve", "Linear systems", "Nearest poses", "Tetrahedra and library", "3-D view", "Packet to packet",
            "An hour live", "Movement of the partner", "The paper's tables", "Figures of the literature", "Other bodies",
            "Suggested labels", "Sizes and limits"]
HEAD = """# Figures

Written by `tests/bench/figures`; do not edit. [Benchmarks](benchmarks.md) says how these figures are measured and how to write this
page again; the [guide](guide/evaluation.md#metrics) defines the metrics.
"""
SEAL = "<!-- sha256 of all above: "


class Missing(Exception):
    """A figure that the page needs is in none of the files."""


def value(report, path):
    """What stands at "a.b.c"; None where it could not be measured."""
    found = report
    for key in path.split("."):
        if not isinstance(found, dict) or key not in found:
            raise Missing(f"there is no {path}")
        found = found[key]
    return found


def number(figure, scale=1):
    """Three digits; nothing is a dash."""
    if figure is None:
        return "-"
    scaled = figure * scale
    return "0" if abs(scaled) < 5e-4 else table.number(scaled)


def thousands(count):
    return f"{count:,}".replace(",", " ")


def rows_of(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def anchor(title):
    return "".join(c for c in title.lower() if c.isalnum() or c in " -").replace(" ", "-")


# Speed ----------------------------------------------------------------------------------------------------------------------

class Bench:
    """table.json of tests/bench/run."""

    def __init__(self, content):
        self.about, self.ratios, self.figures = content["machine"], content["ratios"], content["figures"]

    def figure(self, what, needed=True):
        for row in self.figures:
            if row["what"] == what:
                return row["value"]["median"]
        if needed:
            raise Missing(f"tests/bench/run measured no \"{what}\"")
        return None

    def compared(self, group, needed=True):
        rows = [row for row in self.ratios if row["group"] == group]
        if needed and not rows:
            raise Missing(f"tests/bench/run compared nothing of \"{group}\"")
        return rows

    def group(self, name):
        return [row for row in self.figures if row["group"] == name]


def time_text(us):
    if us >= 1e6:
        return f"{number(us, 1e-6)} s"
    return f"{number(us, 1e-3)} ms" if us >= 1000 else f"{number(us)} us"


def one_solve(bench):
    rows = []
    for name, what in [("*responsive*, selection by intent", "responsive at 60 Hz"), ("at 120 Hz", "responsive at 120 Hz"),
                       ("with cold caches", "responsive at 60 Hz, cold caches"),
                       ("on other bodies", "responsive at 60 Hz, bodies user and 0.85"),
                       ("*responsive*, selection by Eq. 7", "responsive by Eq. 7 at 60 Hz"),
                       ("*paper*, 15 Hz", "paper at 15 Hz"), ("*paper*, 60 Hz", "paper at 60 Hz")]:
        has_goal = "," not in what
        cells = [number(bench.figure(f"{what}: {which}"), 1e-3) for which in ("p50, processor", "p99, processor", "p50", "p99")]
        rows.append([name, *cells, "0.5 / 1" if has_goal else ""])
    stages = []
    for name, what in [("by intent", "responsive"), ("by Eq. 7", "responsive by Eq. 7")]:
        stages.append([name, *(number(bench.figure(f"{what} at 60 Hz: p50 of {part}"))
                               for part in ("retargeting", "selecting", "the mesh", "editing"))])
    return ("Milliseconds of one whole step, 60 Hz unless another rate is named. Other load is in the clock's times, not in those of the "
            "processor.\n\n"
            + rows_of(["", "p50, processor", "p99, processor", "p50, clock", "p99, clock", "goal, p50 / p99"], rows)
            + "\nStages of a step of *responsive*, medians in microseconds:\n\n"
            + rows_of(["selection", "retargeting", "selection", "mesh", "editing"], stages))


def ratio_rows(rows):
    out = []
    for row in rows:
        if "times" not in row:
            out.append([row["what"], time_text(row["ours_us"]["median"]), row["other"], "not compared: " + row["error"], "", ""])
            continue
        times = row["times"]
        out.append([row["what"], time_text(row["ours_us"]["median"]), row["other"], time_text(row["other_us"]["median"]),
                    f"{number(times['median'])} ({number(times['low'])}-{number(times['high'])})", row["goal"] or ""])
    return rows_of(["", "ours", "compared with", "theirs", "ratio (range by quartiles)", "goal"], out)


def linear_systems(bench):
    errors = [row for row in bench.figures if row["what"].endswith("farthest position")]
    if not errors:
        raise Missing("tests/bench/run measured no distance from the solution in extended precision")
    return (ratio_rows(bench.compared("One solve")) + "\nLargest distance of a position, in nanometres: "
            + "; ".join(f"{row['what'].removesuffix(', farthest position')} {number(row['value']['median'])}" for row in errors)
            + f". UMFPACK: {bench.about.get('UMFPACK', 'unknown')}.\n")


def nearest_poses(bench):
    rows = [row for row in bench.compared("Nearest poses") if row["what"].startswith("10 of ")]
    text = ("The k nearest of all poses of the library, exactly, by FLANN (what libraries in memory use).\n\n" + ratio_rows(rows))
    queries = {}  # "10 of 7 500, 0 cm off" -> names of searches
    for row in bench.group("Nearest poses"):
        if row["what"].endswith("cm off: p50"):
            search, query = row["what"].removesuffix(": p50").split(", 10 of ")
            queries.setdefault("10 of " + query, set()).add(search)
    if queries:
        searches = sorted(set.union(*queries.values()))
        text += ("\nUsers with offsets on every coordinate, p50/p99 in microseconds:\n\n"
                 + rows_of(["", *searches], [[query, *(spread(bench, f"{search}, {query}") for search in searches)]
                                             for query in sorted(queries, key=by_number)]))
    return text


def by_number(text):
    return [int(digits.replace(" ", "")) for digits in re.findall(r"\d[\d ]*", text)]


def spread(bench, what):
    return "/".join(number(bench.figure(f"{what}: {percentile}")) for percentile in ("p50", "p99"))


def tetrahedra_and_library(bench):
    build = [["built on all cores, by the clock", "15 s"], ["built on one core, by the clock", ""], ["loaded into memory", "500 ms"],
             ["opened and mapped", ""], ["floor: its bytes read from the page cache", ""]]
    rows = [[what, time_text(1000 * bench.figure(what.removesuffix(", by the clock"))), goal] for what, goal in build]
    return (ratio_rows(bench.compared("Tetrahedra")) + f"\nLibrary ({bench.about['library']}) from text files, with TetGen:\n\n"
            + rows_of(["", "measured", "goal at most"], rows))


def view(bench):
    rows = [[row["what"], number(row["value"]["median"]), row["unit"], f"at least {row['goal']}" if row["goal"] else ""]
            for row in bench.group("3-D view")]
    return rows_of(["", "measured", "unit", "goal"], rows) if rows else not_measured("tests/bench/run --only scene")


def packets(bench):
    rows = bench.group("Packet to packet")
    if not rows:
        return not_measured("tests/bench/run --only packets")
    return ("`abrazo live` without a window; poses in and the partner out as VMC over loopback.\n\n"
            + rows_of(["", "measured", "unit", "goal at most"],
                      [[row["what"], number(row["value"]["median"]), row["unit"], row["goal"] or ""] for row in rows]))


def not_measured(command):
    """For what may be left out: it needs a display, or an hour."""
    return f"Not measured in this run: `{command}`.\n"


def hour_live(verdict):
    if verdict is None:
        return not_measured("tests/soak/soak 60")
    marks = {"ok": "yes", "FAILED": "**no**"}
    rows = []
    for line in verdict.splitlines():
        mark, rest = line[:7].strip(), line[9:]
        what, _, found = rest.partition(": ")
        rows.append([what, found, marks.get(mark, "")])
    return "`tests/soak/soak`: the workbench with a stream, sending and recording.\n\n" + rows_of(["", "found", "met"], rows)


# Movement and the paper's tables --------------------------------------------------------------------------------------------

def movement(reports):
    rows = []
    for what, unit, scale, path, captured, goal in MOVEMENT:
        cells = []
        for name in SETS:
            cells += [number(value(reports[f"{name}-{preset}"], path), scale) for preset in PRESETS]
            cells.append("" if captured is None else number(captured) if not isinstance(captured, str)
                         else number(value(reports[f"{name}-responsive"], captured), scale))
        rows.append([what + (f" [{unit}]" if unit else ""), goal or "", *cells])
    head = [f"{name}: {which}" for name in SETS for which in (*(f"`{preset}`" for preset in PRESETS), "captured")]
    return ("Each take is answered by all the others, at the rate of the preset (`responsive` 60 Hz, `paper` 15 Hz). A goal is an upper bound "
            "unless it says otherwise, for `responsive` on captured salsa.\n\n" + rows_of(["", "goal", *head], rows))


def percent(share):
    return "-" if share is None else f"{100 * share:.1f}%"


def both(first, second):
    return f"{first}/{second}"


def papers_tables(reports):
    paper = reports["salsa-paper"]
    recall = [[row["k"], both(percent(row["recall_best"]), percent(row["recall_best2"])),
               both(*(percent(share) for share in PAPER_RECALL[row["k"]]))] for row in value(paper, "selection") if row["k"] in SHOWN_K]
    times = [[thousands(row["pairs"]), both(number(row["knn_us"], 1e-3), number(row["brute_us"], 1e-3)),
              both(*PAPER_TIMES_MS[row["pairs"]])] for row in value(paper, "timing") if row["pairs"] in PAPER_TIMES_MS]
    if not recall or not times:
        raise Missing("the run salsa-paper has no row of Table I or II")
    rows = []
    for name in SETS:
        for preset in PRESETS:
            report = reports[f"{name}-{preset}"]
            rows.append([f"{name}, `{preset}`", f"{value(report, 'moves.successful')} of {value(report, 'moves.total')}",
                         percent(value(report, "moves.rate")), percent(value(report, "moves.lenient_rate")),
                         number(value(report, "zmp.original_asf")), number(value(report, "zmp.synthesised_asf")),
                         number(value(report, "zmp.ratio")), number(value(report, "zmp.common_frames.ratio"))])
    rows += [[f"paper: {what}", f"{successful} of {total}", percent(successful / total), "", *[""] * 4]
             for what, total, successful in PAPER_MOVES]
    rows += [[f"paper: {what}", "", "", "", number(original), number(made), number(made / original), ""]
             for what, (original, made) in PAPER_ZMP.items()]
    return ("Tables I and II, captured salsa: recall of the best pair/of either of the best two among the k nearest; time of one selection by "
            "k nearest/by brute force.\n\n"
            + rows_of(["k", "recall", "of the paper"], recall) + "\n" + rows_of(["pairs", "ms", "of the paper"], times)
            + "\nTables III and IV: successful moves (lenient: also by the alternative label), and ZMP error of both bodies in ASF units. "
            "*Common* counts only frames that count in both motions.\n\n"
            + rows_of(["", "moves", "share", "lenient", "ZMP captured", "synthesised", "ratio", "ratio, common"], rows))


def literature(reports):
    rows = []
    for key, title, better, unit, scale in PUBLISHED:
        ours = [value(reports[f"salsa-{preset}"], f"published.{key}.synthesised") for preset in PRESETS]
        others = [value(reports["salsa-responsive"], f"published.{key}.{which}") for which in ("nearest_neighbour", "recording")]
        rows.append([title + (f" [{unit}]" if unit else ""), better, *(number(figure, scale) for figure in ours + others)])
    return ("Captured salsa at 30 frames a second. The baselines are those of `responsive`, at 60 Hz. [Comparison](comparison.md) says what can "
            "be compared.\n\n"
            + rows_of(["", "better", "`responsive`", "`paper`", "nearest neighbour", "recording"], rows))


BASELINES = ("angles_copied", "paper_mesh", "no_mesh")
BODY_COLUMNS = [("hold change [mm]", "hold_change_mean_m", 1000), ("penetration p99 [mm]", "penetration_excess_p99_m", 1000),
                ("sliding", "slide_ratio", 1), ("speed p99", "speed_p99_ratio", 1), ("acceleration p99", "acceleration_p99_ratio", 1)]


def other_bodies(reports):
    rows = []
    for pair in value(reports["salsa-bodies"], "bodies.pairs"):
        ours = (pair["retargeted"], pair["live"])
        posture = [both(*(", ".join(number(m[f"posture_{body}"][key]) for body in ("active", "passive")) for m in ours))
                   for key in ("pelvis_height_ratio", "knee_change_deg", "trunk_change_deg")]
        rows.append([pair["bodies"], *posture, both(*(number(m["contact_25cm"]["f1"]) for m in ours)),
                     number(max(pair[other]["contact_25cm"]["f1"] for other in BASELINES)),
                     *(both(*(number(m[key], scale) for m in ours)) for _, key, scale in BODY_COLUMNS)])
    return ("Recorded pairs on other bodies, captured salsa, offline (`abrazo retarget`)/live without the future. Contact is F1 against the "
            "recording, of joints within 25 cm, beside the best baseline (joint angles copied, the paper's mesh, no mesh); sliding, speed and "
            "acceleration are divided by those of the recording. Posture, active, passive body: height of the pelvis over the recorded one in "
            "proportion, changes of the angles of knees (negative: more bent) and trunk in degrees.\n\n"
            + rows_of(["bodies", "pelvis", "knees", "trunk", "contact", "baseline", *(title for title, _, _ in BODY_COLUMNS)], rows))


def suggested_labels(reports):
    ways = ("suggestions", "nearest_pose", "majority")
    rows = []
    for name in SETS:
        found = [value(reports[f"{name}-labels"], way) for way in ways]
        rows.append([name, "/".join(percent(way["frame_share"]) for way in found),
                     "/".join(str(way["found"]) for way in found) + f" of {found[0]['moves']}", "/".join(number(way["f1"]) for way in found),
                     number(found[0]["boundary_median_frames"]), percent(value(reports[f"{name}-labels"], "roles.frame_share"))])
    return ("Each take is suggested from the others and compared with its annotation: suggestions/label of the nearest pose/most frequent "
            "label.\n\n"
            + rows_of(["", "frames that agree", "moves found", "F1 at IoU 0.5", "boundary error, median [frames]",
                       "frames with the right active performer"], rows))


def sizes(bench, reports):
    size = bench.about.get("library bytes")
    if not size:
        raise Missing("tests/bench/run did not say how large its library is")
    rows = [[f"library file, {bench.about['library']}", f"{number(size / 1e6)} MB"]]
    rows += [[f"pairs of the library, {SETS[name]}", thousands(value(reports[f"{name}-responsive"], "library_pairs"))]
             for name in SETS]
    return (rows_of(["", "measured"], rows)
            + "\nLimits are promises and stand where they are kept: [large libraries](library-file.md#large-libraries-are-mapped), "
            "[session files](session-file.md), [files and packets of strangers](../SECURITY.md), "
            "[comparable figures](comparison.md#what-cannot).\n")


# The page -------------------------------------------------------------------------------------------------------------------

def runs(bench, abouts):
    if bench is None and not abouts:
        raise Missing("neither tests/bench/run nor tests/bench/figures --measure was run")
    rows, machines, more = [], {}, []
    if bench is not None:
        about = bench.about
        rows.append(["benchmarks", f"`{about['command']}`", about["library"], about["revision"], about["load before and after (1, 5, 15 min)"]])
        machines[about["machine"]] = ["benchmarks"]
        more = [f"- {key}: {about[key]}" for key in ("compiler", "packages") if about.get(key)]
        more.append(f"- repetitions of the benchmarks: {about['repetitions']}")
    for name, about in abouts.items():
        rows.append([name, f"`{about['command']}`", about["data"], about["revision"], about["load"]])
        machines.setdefault(about["machine"], []).append(name)
    lines = [f"- {on}" + ("" if len(machines) == 1 else f": {', '.join(names)}") for on, names in machines.items()]
    return ("A figure of speed is the median of the repetitions. Movement has the same figures on every run; times do not.\n\n"
            + "\n".join(lines + more) + "\n\n" + rows_of(["run", "command", "data", "revision", "load before and after"], rows))


UNMEASURED = "Not measured: "


class Partial(dict):
    """Runs by name, of which some may not be there."""

    def __missing__(self, name):
        raise Missing(f"the run {name} is not there")


def page(table_json, reports, abouts, verdict=None, is_partial=False):
    """The whole page; a partial one says in a section what has to be measured. @raises Missing with the same"""
    reports = Partial(reports)
    bench = Bench(table_json) if table_json else None
    made = [lambda: runs(bench, abouts), *(lambda part=part: of_bench(part, bench) for part in (
        one_solve, linear_systems, nearest_poses, tetrahedra_and_library, view, packets)), lambda: hour_live(verdict),
        *(lambda part=part: part(reports) for part in (movement, papers_tables, literature, other_bodies, suggested_labels)),
        lambda: sizes(of_bench(lambda found: found, bench), reports)]
    for name in RUNS:
        if not is_partial and name not in abouts:
            raise Missing(f"the run {name} is not there")
    text = HEAD + "\n" + ", ".join(f"[{title}](#{anchor(title)})" for title in SECTIONS) + "\n"
    for title, make in zip(SECTIONS, made, strict=True):
        try:
            content = make()
        except Missing as missing:
            if not is_partial:
                raise
            content = f"{UNMEASURED}{missing}.\n"
        text += f"\n## {title}\n\n{content}"
    return sealed(text + "\n")


def of_bench(part, bench):
    if bench is None:
        raise Missing("there is no table of tests/bench/run")
    return part(bench)


def sealed(text):
    return f"{text}{SEAL}{hashlib.sha256(text.encode()).hexdigest()} -->\n"


def problems(text):
    """What is wrong with a page: no section, or a line that the command did not write."""
    found = [f"there is no section \"{title}\"" for title in SECTIONS if f"\n## {title}\n" not in text]
    body, mark, _ = text.rpartition(SEAL)
    if not mark:
        return found + ["the line with its checksum is missing"]
    if sealed(body) != text:
        found.append("it was edited by hand")
    return found


def unmeasured(text):
    """Sections of a partial page that have no figures."""
    return [title for title in SECTIONS if f"\n## {title}\n\n{UNMEASURED}" in text]
