# SPDX-License-Identifier: MIT
"""paper and report at a tiny size: what they write, and that the page's figures are the data's."""

import csv
import json
import math
import os
import re
import shutil
import subprocess
import tempfile
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

from sim_program import SCENARIOS

SWEEPS = ("a_cylinder", "b_occlusion", "c_distance", "c_fixated", "c_stretched")
FIGURES = ("fig6a_raw", "fig6a_removed", "fig6b_true_depth", "fig6b_found_depth", "fig6b_rms",
           "fig6c_position", "fig6c_readings", "table3_distance", "table3_occlusion", "track_throw_offset",
           "track_throw_error")
SECTIONS = ("summary", "setting", "fig6a", "fig6b", "fig6c", "table3", "failures", "why",
            "tracking", "files")
TRIALS = 2


def run_program(*arguments, path=None):
    environment = dict(os.environ)
    if path is not None:
        environment["PATH"] = path
    return subprocess.run([os.environ["OCELLUS_SIM"], *map(str, arguments)], env=environment,
                          capture_output=True, text=True, timeout=300, check=False)


def write_tiny_scenarios(folder):
    """The real ones, with fewer pixels and points, and one short closed loop."""
    for name in (*SWEEPS, "track_throw"):
        text = (SCENARIOS / f"{name}.toml").read_text()
        text = text.replace('size = "320x240"', 'size = "160x120"')
        points = "[0.0, 0.1, 0.5]" if name == "b_occlusion" else "[1.2, 2.0, 3.2]"
        text = re.sub(r"points = \[[^]]*\]", f"points = {points}", text)
        text = re.sub(r"duration = [\d.]+", "duration = 0.7", text)
        (folder / f"{name}.toml").write_text(text)


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        scenarios = cls.folder / "scenarios"
        scenarios.mkdir()
        write_tiny_scenarios(scenarios)
        cls.runs = {jobs: cls.folder / f"jobs{jobs}" for jobs in (1, 2)}
        for jobs, out in cls.runs.items():
            finished = run_program("paper", "--out", out, "--trials", TRIALS, "--jobs", jobs,
                                   "--scenarios", scenarios)
            if finished.returncode != 0:
                raise AssertionError(finished.stderr)
        cls.out = cls.runs[1]
        cls.text = (cls.out / "report.html").read_text()
        cls.page = ElementTree.fromstring(cls.text)

    def copy_of_run(self):
        copy = pathlib.Path(tempfile.mkdtemp(dir=self.folder)) / "run"
        shutil.copytree(self.out, copy)
        return copy

    def rows(self, scenario):
        with open(self.out / scenario / "trials.csv", newline="") as file:
            return list(csv.DictReader(file))

    def tables(self):
        """key: list of rows of cells' texts, the head first."""
        return {table.get("data-key"): [["".join(cell.itertext()) for cell in row]
                                        for row in table.iter("tr")]
                for table in self.page.iter("table")}

    def test_the_page_stands_alone(self):
        self.assertNotIn("http", self.text)
        for element in self.page.iter():
            self.assertNotIn(element.tag, ("script", "link", "iframe", "object"))
            source = element.get("src", "data:")
            self.assertTrue(source.startswith("data:"), source[:60])
            target = element.get("href", "#")
            if not target.startswith("#"):
                self.assertTrue((self.out / target).exists(), target)
        self.assertNotIn("url(", self.text)
        self.assertNotIn("@import", self.text)

    def test_every_figure_and_section_is_there_once(self):
        ids = [element.get("id") for element in self.page.iter() if element.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        for name in (*FIGURES, *SECTIONS):
            self.assertIn(name, ids)
        for target in re.findall(r'href="#([^"]+)"', self.text):
            self.assertIn(target, ids)
        for name in FIGURES:
            figure = next(e for e in self.page.iter("figure") if e.get("id") == name)
            self.assertEqual(len(list(figure.iter("svg"))), 1)
            self.assertTrue("".join(figure.find("figcaption").itertext()).strip())
        self.assertGreaterEqual(len(list(self.page.iter("img"))), 4)

    def check_cell(self, cell, expected, where):
        if expected is None:
            self.assertEqual(cell, "–", where)
        else:
            digits = len(cell.split(".")[1])
            self.assertAlmostEqual(float(cell), expected, delta=0.51 * 10 ** -digits + 1e-5 *
                                   abs(expected), msg=where)

    def check_statistics(self, scenario, column, statistic, table):
        heads, *lines = table
        rows = self.rows(scenario)
        self.assertEqual(len(lines), len({row["method"] for row in rows}))
        for name, *cells in lines:
            for index, cell in enumerate(cells):
                point = None if heads[index + 1] == "all" else str(index)
                values = [float(row[column]) for row in rows
                          if row["method"] == name and row[column] and point in (None, row["point"])]
                power = 1 if statistic == "mean" else 2
                expected = None
                if values:
                    expected = math.fsum(v ** power for v in values) / len(values)
                    expected = expected if power == 1 else math.sqrt(expected)
                self.check_cell(cell, expected, (scenario, column, statistic, name, index))

    def test_tables_are_the_trials(self):
        checked = 0
        for key, table in self.tables().items():
            scenario, column, statistic = (key.split(" ") + ["", ""])[:3]
            if statistic in ("mean", "rms"):
                self.check_statistics(scenario, column, statistic, table)
                checked += 1
        self.assertEqual(checked, 11)

    def test_failures_are_the_trials(self):
        checked = 0
        for key, (_, *lines) in self.tables().items():
            scenario, what, unit = (key.split(" ") + ["", ""])[:3]
            if unit != "percent":
                continue
            for name, *cells in lines:
                rows = [row for row in self.rows(scenario) if row["method"] == name]
                failed = [row for row in rows if row["success"] == "0" and
                          (what == "failed" or row["status"] == "ok")]
                self.check_cell(cells[-1], 100 * len(failed) / len(rows), (key, name))
                for point, cell in enumerate(cells[:-1]):
                    here = [row for row in failed if row["point"] == str(point)]
                    self.check_cell(cell, 100 * len(here) / TRIALS, (key, name, point))
                checked += 1
        self.assertGreater(checked, 8)

    def test_squares_and_trends(self):
        _, *lines = self.tables()["c_distance err_sq_pct value"]
        rows = self.rows("c_distance")
        for name, *cells in lines:
            errors = [float(row["err"]) for row in rows if row["method"] == name and row["err"]]
            expected = 100 * math.fsum(e * e for e in errors) / len(errors)
            self.assertAlmostEqual(float(cells[-1]), expected, delta=0.051 * expected)
        caption = next("".join(f.find("figcaption").itertext()) for f in self.page.iter("figure")
                       if f.get("id") == "fig6c_position")
        a, b = self.exponential(rows, "hough_gradient")
        self.assertRegex(caption, rf"hough_gradient {a:.2g}·exp\({b:.2f} d\)".replace("+", r"\+"))

    @staticmethod
    def exponential(rows, method):
        """log e = log a + b d by least squares over the points' means."""
        points = sorted({float(row["distance"]) for row in rows})
        means = []
        for point in points:
            errors = [float(row["err"]) for row in rows
                      if row["method"] == method and float(row["distance"]) == point]
            means.append(math.log(sum(errors) / len(errors)))
        middle, level = sum(points) / len(points), sum(means) / len(means)
        slope = (sum((x - middle) * (y - level) for x, y in zip(points, means)) /
                 sum((x - middle) ** 2 for x in points))
        return math.exp(level - slope * middle), slope

    def test_what_was_reached_is_the_data(self):
        claims = {row[0]: row[1:] for row in self.tables()["claims"][1:]}
        rows = self.rows("c_distance")
        errors = [float(row["err"]) for row in rows if row["method"] == "sphere"]
        mean = sum(errors) / len(errors)
        asked, found, verdict = claims["(c) position of the ball, sphere, mean"]
        self.assertEqual(asked, "≤ 0.003 SMU")
        self.assertEqual(found, f"sphere {mean:.4f}")
        self.assertEqual(verdict, "reached" if mean <= 0.003 else "not reached")
        self.assertGreaterEqual(len(claims), 11)
        self.assertIn(f"This run has {TRIALS} trials at a point", "".join(self.page.itertext()))

    def test_thresholds(self):
        for half in ("distance", "occlusion"):
            _, *lines = self.tables()[f"table3 {half}"]
            self.assertEqual(len(lines), 3)
            for _, votes, share, most, trials, radius, *_ in lines:
                self.assertGreaterEqual(int(most), int(votes))
                self.assertGreater(int(votes), 0)
                self.assertEqual(int(trials), TRIALS)
                self.assertAlmostEqual(float(share), int(votes) / (2 * math.pi * float(radius)),
                                       delta=0.01)
        for rows in json.loads((self.out / "table3.json").read_text()).values():
            for row in rows if isinstance(rows, list) else ():
                self.assertEqual(row["pictures"], 2 * TRIALS)
        # No trial's own largest threshold with a circle is below the one that works in all.
        for row in self.rows("c_distance"):
            if row["method"] == "hough_gradient":
                working = int(self.tables()["table3 distance"][1 + int(row["point"])][1])
                self.assertLessEqual(working, int(row["votes"]))

    def test_the_same_whatever_the_jobs(self):
        names = sorted(path.relative_to(self.out) for path in self.out.rglob("*")
                       if path.is_file() and path.name not in ("clock.json", "report.html"))
        self.assertGreater(len(names), 25)
        for name in names:
            self.assertEqual(*((out / name).read_bytes() for out in self.runs.values()), name)
        copies = [self.copy_of_run(), pathlib.Path(tempfile.mkdtemp(dir=self.folder)) / "run"]
        shutil.copytree(self.runs[2], copies[1])
        shutil.copy(copies[0] / "clock.json", copies[1])
        for copy in copies:
            self.assertEqual(run_program("report", copy).returncode, 0)
        self.assertEqual(*((copy / "report.html").read_bytes() for copy in copies))

    def test_what_is_missing_is_told(self):
        copy = self.copy_of_run()
        shutil.rmtree(copy / "b_occlusion")
        shutil.rmtree(copy / "track_throw")
        (copy / "table3.json").unlink()
        finished = run_program("report", copy)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        page = "".join(ElementTree.fromstring((copy / "report.html").read_text()).itertext())
        for words in (f"{copy}/b_occlusion/summary.json: is missing; ocellus-sim run "
                      f"hostsim/scenarios/b_occlusion.toml --out {copy}/b_occlusion makes it",
                      f"{copy}/table3.json: is missing; ocellus-sim paper makes it",
                      f"{copy}/track_*/: there is none"):
            self.assertIn(words, finished.stderr)
            self.assertIn(words, page)
        self.assertIn("Fig. 6(c).", page)

    def check_refused(self, finished, *words):
        self.assertEqual(finished.returncode, 2, finished.stderr)
        for word in words:
            self.assertIn(word, finished.stderr)

    def test_nothing_or_damage_is_an_error(self):
        empty = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        self.check_refused(run_program("report", empty), f"{empty}: holds no results",
                           "ocellus-sim paper --out")
        self.check_refused(run_program("report", empty / "none"), "is no folder")
        for name, text, words in (
                ("c_distance/summary.json", '{"scenario": ', "is no JSON"),
                ("c_distance/summary.json", '{"scenario": "c_distance"}', "run the scenario again"),
                ("table3.json", '{"distance": [], "occlusion": []}', "is not what ocellus-sim"),
                ("table3.json", '{}', "is not what ocellus-sim paper writes"),
                ("track_throw/frames.csv", "frame,time_s\n0,0.0\n1\n", "frames.csv:3: has 1 field"),
                ("track_throw/frames.csv", "frame,time_s\n", "has no frame"),
                ("track_throw/frames.csv", "time_s,hidden\nsoon,0\n", "frames.csv")):
            copy = self.copy_of_run()
            (copy / name).write_text(text)
            self.check_refused(run_program("report", copy), name.split("/")[-1], words)

    def test_without_gnuplot_nothing_begins(self):
        out = self.folder / "unplotted"
        finished = run_program("paper", "--out", out, path=str(self.folder))
        self.check_refused(finished, "gnuplot", "apt-get install gnuplot-nox")
        self.assertFalse(out.exists())

    def test_wrong_scenarios_are_told_before_anything_runs(self):
        out = self.folder / "unrun"
        self.check_refused(run_program("paper", "--out", out, "--scenarios", self.folder / "no"),
                           "--scenarios", "is no folder")
        scenarios = self.folder / "broken"
        shutil.copytree(self.folder / "scenarios", scenarios)
        (scenarios / "track_throw.toml").write_text("name = 1\n")
        self.check_refused(run_program("paper", "--out", out, "--scenarios", scenarios),
                           f"{scenarios}/track_throw.toml:1:")
        self.assertFalse(out.exists())

    def test_help(self):
        text = run_program("paper", "--help").stdout
        for word in ("--trials", "--jobs", "--seed", "--scenarios", "--video", "report.html",
                     "table3.json", "gnuplot"):
            self.assertIn(word, text)
        self.assertIn("DIR", run_program("report", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
