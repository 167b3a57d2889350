#!/usr/bin/python3
"""Checks who includes whom: only downward through the layers. usage: check_includes.py SOURCE_DIRECTORY"""

import re

import house

# Layer: the layers that it may include besides itself.
MAY_INCLUDE = {
    "physics": "",
    "base": "",
    "kernels": "physics",
    "compute": "base",
    "data": "compute physics base",
    "mpi": "data compute base",
    "particles": "mpi data compute kernels physics base",
    "fluid": "mpi data compute kernels physics base",
    "coupling": "particles fluid mpi data compute kernels physics base",
    "analysis": "particles fluid mpi data kernels physics base",
    "output": "mpi data base",
    "input": "data physics base",
    "app": "input output analysis coupling particles fluid mpi data compute kernels physics base",
}
# The only file of the shared text that knows the compiler and so may include the compiler's headers.
COMPILER_FILE = "physics/device.h"
SHARED_TEXT = {"physics", "kernels"}
INCLUDE = re.compile(r'\s*#\s*include\s*(<|")([^>"]+)')


def problem_with(layer, path, sign, name):
    if sign == "<":
        if layer in SHARED_TEXT and path != COMPILER_FILE:
            return f"<{name}>: the text shared with devices includes no library"
        return None
    if not name.startswith("scree/"):
        return f'"{name}": name files of the project as "scree/LAYER/..."'
    other = name.split("/")[1]
    if other != layer and other not in MAY_INCLUDE.get(layer, "").split():
        return f"{layer}/ may not include {other}/"
    return None


def check(root):
    source, problems = root / "src" / "scree", []
    for path in house.files(root, "src"):
        relative = path.relative_to(source).as_posix()
        layer = relative.split("/")[0]
        if layer not in MAY_INCLUDE:
            problems.append(f"{path}:1: {layer}/ is no layer")
            continue
        for number, line in house.numbered_lines(path):
            match = INCLUDE.match(line)
            problem = match and problem_with(layer, relative, *match.groups())
            if problem:
                problems.append(f"{path}:{number}: {problem}")
    return problems


if __name__ == "__main__":
    house.main(check)
