"""What the samples of a soak say: verdict, table and picture. No side effects but the files it is told to write."""

import csv
import statistics


def column(samples, name):
    """(hours, value) of every sample that has the value."""
    return [(s["seconds"] / 3600, s[name]) for s in samples if s.get(name) is not None]


def slope_per_hour(points):
    """Median of the slopes between all pairs of a thinned series (Theil-Sen): single peaks do not count. None
    for fewer than three points."""
    if len(points) < 3:
        return None
    points = points[:: max(1, len(points) // 200)]
    slopes = [
        (later[1] - earlier[1]) / (later[0] - earlier[0])
        for i, earlier in enumerate(points)
        for later in points[i + 1 :]
        if later[0] > earlier[0]
    ]
    return statistics.median(slopes) if slopes else None


def warm_up_s(samples, least_s=120.0):
    """Till the history in memory has reached its bound and stays there, and at least so long; half of the run
    at most."""
    if not samples:
        return 0.0
    end_s = samples[-1]["seconds"]
    history = [(s["seconds"], s["history_mb"]) for s in samples if s.get("history_mb") is not None]
    full_s = next((t for t, mb in history if mb >= 0.97 * max(h for _, h in history)), 0.0) if history else 0.0
    return min(max(least_s, full_s + 60), end_s / 2)


class Verdict:
    def __init__(self):
        self.lines = []  # (is good, or None where nothing is asked; what; how much)

    def add(self, good, what, found):
        self.lines.append((good, what, found))

    @property
    def good(self):
        return all(good is not False for good, _, _ in self.lines)

    def text(self):
        marks = {True: "ok", False: "FAILED", None: ""}
        return "".join(f"{marks[good]:>7}  {what}: {found}\n" for good, what, found in self.lines)


def judge(samples, recorded, sent, limits):
    """recorded: `abrazo session info --json` of the file with "holes" (frames left out) and "poses", or None; sent: `abrazo send --json`'s summary, or None;
    limits: memory [MB/h], pictures [1/s] and latency [ms, the 99th percentile of a sample] at the median."""
    verdict = Verdict()
    if not samples:
        verdict.add(False, "samples", "none were taken")
        return verdict
    last = samples[-1]
    verdict.add(None, "lasted", f"{last['seconds'] / 60:.1f} min, {len(samples)} samples")
    begin = warm_up_s(samples)
    steady = [s for s in samples if s["seconds"] >= begin]
    history = [mb for _, mb in column(steady, "history_mb")]
    fills = bool(history) and history[-1] > 1.03 * history[0]  # in a short run: then memory grows as it should
    for name, unit, limit in (("pss_mb", "MB", limits["memory"]), ("rss_mb", "MB", limits["memory"]),
                              ("threads", "", 0.5), ("fds", "", 0.5)):
        points = column(steady, name)
        slope = slope_per_hour(points)
        if slope is None:
            continue
        hours = points[-1][0] - points[0][0]
        rise = slope * hours  # what a short run saw of it; its slope alone is noise
        unjudged = fills and unit == "MB"
        verdict.add(None if unjudged else rise <= limit * max(hours, 0.25), f"{name} after {begin:.0f} s",
                    f"{slope:+.2f} {unit}/h, from {points[0][1]:.1f} to {points[-1][1]:.1f}, "
                    f"most {max(v for _, v in points):.1f}" + (" (the history still fills)" if unjudged else ""))
    rates = [s["pictures_per_s"] for s in steady if s.get("pictures_per_s") is not None]
    if rates:
        verdict.add(statistics.median(rates) >= limits["pictures"], "pictures per second",
                    f"median {statistics.median(rates):.1f}, least {min(rates):.1f}")
    for name in ("out_p50_ms", "out_p99_ms", "out_max_ms", "solve_p50_ms", "solve_p99_ms"):
        values = [s[name] for s in steady if s.get(name) is not None]
        if values:
            good = statistics.median(values) <= limits["latency"] if name == "out_p99_ms" else None
            verdict.add(good, name, f"median {statistics.median(values):.2f}, worst {max(values):.2f}")
    cpu = [s["cpu"] for s in steady if s.get("cpu") is not None]
    if cpu:
        verdict.add(None, "processor", f"median {100 * statistics.median(cpu):.0f} % of a core")
    verdict.add(last["recording_lost"] == 0, "lost by the recorder", str(last["recording_lost"]))
    failed = last["failed"] - steady[0]["failed"]
    verdict.add(failed == 0, f"steps that failed after {begin:.0f} s", str(failed))
    if recorded is None:
        verdict.add(False, "session file", "cannot be read")
    else:
        whole = recorded["frames"] >= last["recorded"] and recorded["holes"] == 0 and recorded["damaged_rows"] == 0
        verdict.add(whole and recorded["poses"] >= last["received"], "session file has",
                    f"{recorded['frames']} of {last['recorded']} frames, {recorded['holes']} left out between, "
                    f"{recorded['damaged_rows']} damaged; {recorded['poses']} of {last['received']} poses that came in")
        hours = max(1e-9, last["seconds"] / 3600)
        verdict.add(None, "session file", f"{last['file_mb']:.0f} MB, {last['file_mb'] / hours:.0f} MB/h, log at most "
                    f"{max(s['log_mb'] for s in samples):.1f} MB")
    if sent is not None:
        came = last["received"]
        verdict.add(came >= sent["frames"] - last["stream_lost"] - 2, "frames that came in",
                    f"{came} of {sent['frames']} sent; {last['stream_lost']} lost, {last['late']} late, "
                    f"{last['replaced']} replaced before they were solved, {last['overflowed']} packets overflowed")
    return verdict


def write_csv(file, samples):
    names = list(dict.fromkeys(name for sample in samples for name in sample))
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, names)
        writer.writeheader()
        writer.writerows(samples)


PANELS = (  # title, what is drawn, the limit that is drawn with it
    ("memory [MB]", ("rss_mb", "pss_mb", "history_mb"), None),
    ("session file [MB]", ("file_mb", "log_mb"), None),
    ("packet in to packet out [ms]", ("out_p50_ms", "out_p99_ms", "solve_p50_ms", "solve_p99_ms"), "latency"),
    ("pictures per second", ("pictures_per_s",), "pictures"),
    ("processor [cores]", ("cpu",), None),
    ("threads, open files", ("threads", "fds"), None),
    ("frames lost, late, replaced, failed so far", ("recording_lost", "stream_lost", "late", "replaced", "failed"), None),
)


def draw(file, samples, title, limits):
    """@return whether there is matplotlib to draw with"""
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(len(PANELS), 1, figsize=(11, 2.1 * len(PANELS)), sharex=True)
    for axis, (label, names, limit) in zip(axes, PANELS):
        for name in names:
            points = column(samples, name)
            axis.plot([60 * hours for hours, _ in points], [value for _, value in points], label=name, linewidth=1)
        axis.set_title(label, fontsize=9, loc="left")
        if limit:
            axis.axhline(limits[limit], color="black", linestyle="--", linewidth=0.8, label="asked for")
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7, loc="lower right", bbox_to_anchor=(1, 1), ncol=len(names) + 1, frameon=False,
                    borderaxespad=0.1)
    axes[-1].set_xlabel("minutes")
    figure.suptitle(title, fontsize=11)
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    pyplot.close(figure)
    return True
