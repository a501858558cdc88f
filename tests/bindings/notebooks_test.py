#!/usr/bin/env python3
"""notebooks_test.py [NAME...]: runs the code of each notebook from its first cell to its last, as a reader does; their own asserts hold.

Drawing goes into memory. No Jupyter is needed.
"""
import json
import pathlib
import sys
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "bindings/python/notebooks"


def main():
    books = sorted(FOLDER.glob("*.ipynb"))
    if len(books) < 4:
        sys.exit(f"{FOLDER} has {len(books)} notebooks")
    for book in books:
        if len(sys.argv) > 1 and book.stem not in sys.argv[1:]:
            continue
        begin, names = time.perf_counter(), {"__name__": "__main__"}
        cells = json.loads(book.read_text(encoding="utf-8"))["cells"]
        for number, cell in enumerate(cells):
            if cell["cell_type"] == "code":
                if cell["outputs"]:
                    sys.exit(f"{book.name} was kept with outputs: clear them")
                code = compile("".join(cell["source"]), f"{book.name}, cell {number}", "exec")
                exec(code, names)  # pylint: disable=exec-used
        if not plt.get_fignums():
            sys.exit(f"{book.name} draws nothing")
        plt.close("all")
        print(f"{book.stem}: {time.perf_counter() - begin:.1f} s")


if __name__ == "__main__":
    main()
