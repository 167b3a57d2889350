#!/usr/bin/python3
"""Checks sizes and openings of source files. usage: check_files.py SOURCE_DIRECTORY"""

import house

LONGEST = 600


def opening_problem(path, lines):
    """A file says what it is in a comment; NAME.cpp beside NAME.h may leave that to its header."""
    if path.suffix == ".cpp" and path.with_suffix(".h").exists():
        return None
    if not lines or not lines[0].startswith("//"):
        return "the file does not open with a comment that says what it is"
    return None


def check(root):
    problems = []
    for path in house.files(root, "src", "tests", "tools", "share", suffixes=house.SOURCE_SUFFIXES | {".py"}):
        lines = path.read_text(encoding="utf-8").splitlines()
        if len(lines) > LONGEST:
            problems.append(f"{path}:{LONGEST + 1}: {len(lines)} lines; at most {LONGEST} in a file")
        if path.suffix == ".py":
            continue
        problem = opening_problem(path, lines)
        if problem:
            problems.append(f"{path}:1: {problem}")
        guarded = any(line.startswith(("#pragma once", "#ifndef")) for line in lines)
        if path.suffix == ".h" and not guarded:
            problems.append(f"{path}:1: a header without #pragma once")
    return problems


if __name__ == "__main__":
    house.main(check)
