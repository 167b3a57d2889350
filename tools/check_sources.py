#!/usr/bin/python3
"""Checks that every name in docs/sources.md exists. usage: check_sources.py SOURCE_DIRECTORY SCREE_PROGRAM

A name stands in backticks behind its kind: key `contact.normal`; tests `Suite.A`, `Suite.B`; case `01_drag`;
plot `01_drag: Speed by scheme`; column `stickiness`; example `02_bouncing_ball`; scene `dense`; file `docs/files.md`.
"""

import re
import subprocess
import tomllib

import house

KINDS = {"key", "test", "case", "plot", "column", "example", "scene", "file"}
CLAIM = re.compile(r"\b(\w+?)s? ((?:`[^`\n]+`(?:, | and )?)+)")
TEST = re.compile(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", re.MULTILINE)


def tests_of(root):
    return {f"{suite}.{name}" for path in house.files(root, "tests/unit")
            for suite, name in TEST.findall(path.read_text(encoding="utf-8"))}


def plots_of(root):
    found = set()
    for path in (root / "verify").glob("*/case.toml"):
        plots = tomllib.loads(path.read_text(encoding="utf-8")).get("verify", {}).get("plots", [])
        found.update(f"{path.parent.name}: {plot['title']}" for plot in plots)
    return found


def columns_of(root):
    return {word for line in (root / "docs/files.md").read_text(encoding="utf-8").splitlines() if line.startswith("|")
            for word in house.code_words(line.split("|")[1])}


def names_of(root, program):
    """For each kind a function that tells whether a name exists."""
    tests, plots, columns = tests_of(root), plots_of(root), columns_of(root)
    known_keys = {}

    def is_key(name):
        if name not in known_keys:
            known_keys[name] = subprocess.run([program, "explain", name], capture_output=True).returncode == 0
        return known_keys[name]

    return {
        "key": is_key,
        "test": tests.__contains__,
        "case": lambda name: (root / "verify" / name / "case.toml").exists(),
        "plot": plots.__contains__,
        "column": columns.__contains__,
        "example": lambda name: (root / "examples" / name / "case.toml").exists(),
        "scene": lambda name: (root / "bench" / f"{name}.toml").exists(),
        "file": lambda name: (root / name).exists(),
    }


def unanswered(path):
    """Rows of the tables whose last cell, the answer, is empty."""
    return [f"{path}:{number}: no answer" for number, line in house.numbered_lines(path)
            if line.startswith("|") and not line.rstrip().rstrip("|").split("|")[-1].strip()]


def check(root, program):
    path = root / "docs/sources.md"
    exists = names_of(root, program)
    problems = unanswered(path)
    for number, line in house.numbered_lines(path):
        for kind, names in CLAIM.findall(line):
            if kind not in KINDS:
                continue
            problems += [f"{path}:{number}: there is no {kind} '{name}'"
                         for name in house.code_words(names) if not exists[kind](name)]
    return problems


if __name__ == "__main__":
    house.main(check)
