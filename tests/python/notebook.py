"""Runs a notebook cell by cell in plain Python: what Jupyter would do with it, without Jupyter.

python3 notebook.py FILE     runs it and keeps its answers in the file: text, and pictures as PNG
"""

import base64
import contextlib
import io
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def pictures():
    """The figures that were drawn, as PNG; none is left."""
    found = []
    for number in plt.get_fignums():
        stream = io.BytesIO()
        plt.figure(number).savefig(stream, format="png", dpi=72, metadata={"Software": None})
        found.append(stream.getvalue())
    plt.close("all")
    return found


def run(notebook):
    """Runs the code cells in their order; for each (what it printed, its pictures)."""
    plt.show = lambda *words, **named: None
    names = {"__name__": "__main__"}
    answers = []
    for number, cell in enumerate(cell for cell in notebook["cells"] if cell["cell_type"] == "code"):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile("".join(cell["source"]), f"cell {number + 1}", "exec"), names)
        answers.append((printed.getvalue(), pictures()))
    return answers


def keep(notebook, answers):
    """Puts the answers into the cells."""
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for number, (cell, (printed, drawn)) in enumerate(zip(cells, answers)):
        cell["execution_count"] = number + 1
        cell["outputs"] = []
        if printed:
            text = printed.splitlines(keepends=True)
            cell["outputs"].append({"name": "stdout", "output_type": "stream", "text": text})
        for picture in drawn:
            png = base64.b64encode(picture).decode() + "\n"
            data = {"image/png": png, "text/plain": ["<Figure>"]}
            cell["outputs"].append({"data": data, "metadata": {}, "output_type": "display_data"})


if __name__ == "__main__":
    file = pathlib.Path(sys.argv[1])
    contents = json.loads(file.read_text())
    keep(contents, run(contents))
    file.write_text(json.dumps(contents, indent=1, ensure_ascii=False) + "\n")
