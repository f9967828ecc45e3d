# SPDX-License-Identifier: MIT
"""Bounds, and what was observed, of every public function in one build."""
import collections
import hashlib
import json
import pathlib
import pickle

from . import boards, build, observe, timing
from .bounds import Annotations, Matcher
from .boards import ROOT
from .code import Program, Refused
from .ipet import MODELS, Analysis
from .lines import Lines

Row = collections.namedtuple("Row", "function bound refused calls observed")
"""bound, observed: (insn, typ, max) or None; refused: why there is no bound, or None."""

_BOARD = ["hash.c", "corpus_small.c", "corpus_maths.c", "corpus_colour.c", "corpus_eye.c",
          "corpus_fit.c", "corpus_camera.c", "corpus_cone.c", "corpus_head.c"]
_WORST = ["observe.c", "worst_frames.c", "worst_colours.c", "worst_fits.c"]


class Study:
    """One build: its files are in a folder of its own below `folder`, made anew when a
    source has changed."""

    def __init__(self, config, folder):
        self.config = config
        name = "-".join(map(str, (config.core, config.level.strip("-"), config.width,
                                  config.height, config.cracks)))
        self.folder = pathlib.Path(folder) / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self._state = self._read_state()

    # ---- Building ----

    def _read_state(self):
        """Tells two states of what goes into the build apart."""
        digest = hashlib.sha256()
        files = [path for folder in ("lib", "port", "tests/board", "tests/wcet", "tests/support",
                                     "tools/wcet")
                 for path in (ROOT / folder).glob("**/*") if path.suffix in (".c", ".h", ".in",
                                                                             ".txt", ".cmake")]
        for path in sorted(files):
            digest.update(str(path).encode() + path.read_bytes())
        digest.update(repr((self.config, build.FLAGS)).encode())
        return digest.hexdigest()

    def _made(self, name, make):
        """The file `name`, made when it is not of this state of the sources."""
        path, stamp = self.folder / name, self.folder / (name + ".stamp")
        if not path.exists() or not stamp.exists() or stamp.read_text() != self._state:
            make(path)
            stamp.write_text(self._state)
        return path

    def _objects(self):
        return build.compile_all(self.config, build.sources(), self.folder / "lib")

    def library(self):
        """An ELF of the library, to be read."""
        return self._made("library.elf", lambda path: build.link_library(
            self.config, self._objects(), path))

    def program(self):
        """An ELF of the program that is observed."""
        def make(path):
            paths = [ROOT / "tests" / "board" / name for name in _BOARD]
            paths += [ROOT / "tests" / "wcet" / name for name in _WORST]
            include = [word for folder in ("port", "lib/src", "tests/support", "tests/board",
                                           "tests/wcet") for word in ("-I", ROOT / folder)]
            objects = build.compile_all(self.config, paths, self.folder / "program", include)
            build.link_program(self.config, self._objects() + objects, self.folder, path)
        return self._made("observe.elf", make)

    # ---- Bounds ----

    def analysis(self, elf):
        annotations = Annotations(sorted((ROOT / "lib" / "src").glob("**/*.[ch]")))
        values = self._made("values.pickle", lambda path: path.write_bytes(pickle.dumps(
            build.evaluate(self.config, annotations.expressions(), self.folder / "values"))))
        annotations.values = pickle.loads(values.read_bytes())
        annotations.check_values()
        return Analysis(Program(elf), Matcher(annotations, Lines(elf)), self.config.core)

    # ---- Observed ----

    def observed(self, elf, functions):
        """function -> (calls, Counts)."""
        def make(path):
            seen = observe.observe(elf, timing.OF_COMPILER[self.config.core],
                                   [*boards.QEMU, "-M", boards.of_core(self.config.core).machine],
                                   watched=functions)
            path.write_text(json.dumps({"calls": seen.calls, "blocks": seen.blocks}))
        return json.loads(self._made("observed.json", make).read_text())["calls"]

    # ---- Both ----

    def rows(self, functions=None, observing=False):
        """A Row for each public function, or each of `functions`."""
        public = build.public_functions()
        elf = self.program() if observing else self.library()
        seen = self.observed(elf, public) if observing else {}
        analysis = self.analysis(elf)
        rows = []
        for name in functions or public:
            calls, most = seen.get(name, (0, None))
            bound, refused = None, None
            try:
                bound = analysis.bound(name)
            except Refused as error:
                refused = str(error)
            rows.append(Row(name, bound, refused, calls, tuple(most) if calls else None))
        return rows


def ratio(row, model=0):
    """Bound over observed, in one of MODELS; None without one of the two."""
    if row.bound is None or row.observed is None:
        return None
    return row.bound[model] / max(1, row.observed[model])


def faults(row):
    """What is wrong with a row by itself: no bound, or one that was exceeded."""
    if row.refused:
        return [f"refused: {row.refused}"]
    return [f"{row.function}: {row.observed[k]} {MODELS[k]} observed, over its bound {row.bound[k]}"
            for k in range(len(MODELS)) if row.observed and row.observed[k] > row.bound[k]]
