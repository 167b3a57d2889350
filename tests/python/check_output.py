"""Checks a run directory against docs/files.md: check_output.py DIR FILES_MD.

Everything is read with other people's readers (h5py, an XML parser, csv, jsonschema); the Python snippets of the document
are run in DIR. Prints each violation and exits with 1 if there are any.
"""

import csv
import importlib.util
import json
import math
import os
import re
import sys
import xml.etree.ElementTree as xml

import h5py
import jsonschema
import numpy

violations = []


def expect(condition, text):
    if not condition:
        violations.append(text)


def documented(document, heading):
    """(name, type, unit) of the table rows in a section; a row may name several."""
    section = document.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    rows = []
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split(" | ")]
        if line.startswith("| `"):
            rows += [(name, cells[1:]) for name in re.findall(r"`([^`]+)`", cells[0])]
    return rows


def code_blocks(document, language):
    return re.findall(rf"```{language}\n(.*?)```", document, re.DOTALL)


def check_frame(path, document):
    """Attributes and datasets are the documented ones, with their types, units and one row per particle."""
    tables = documented(document, "Frames")
    datasets = {name: cells for name, cells in tables if name.startswith("/")}
    with h5py.File(path) as frame:
        for name in [name for name, _ in tables if not name.startswith("/")]:
            expect(name in frame.attrs, f"{path}: no attribute {name}")
        expect(frame.attrs["format"] == "scree frame", f"{path}: format is {frame.attrs['format']!r}")
        ids = frame["particles/id"][:]
        expect(numpy.all(numpy.diff(ids) > 0), f"{path}: ids are not ascending")
        for name in ["/particles/" + name for name in frame["particles"]] + ["/vertices"]:
            dataset = frame[name]
            if name not in datasets:
                expect(False, f"{path}: {name} is not documented")
                continue
            columns = re.search(r"\((\d+)\)", datasets[name][0])
            shape = (len(ids), int(columns.group(1))) if columns else (len(ids),)
            expect(dataset.shape == shape, f"{path}: {name} has shape {dataset.shape}, expected {shape}")
            expect(dataset.dtype == datasets[name][0].split()[0], f"{path}: {name} holds {dataset.dtype}")
            expect(dataset.attrs["units"] == datasets[name][1], f"{path}: {name} is in {dataset.attrs['units']}")
            expect(len(dataset.attrs["meaning"]) > 0, f"{path}: {name} has no meaning")
        optional = {name for name, cells in datasets.items() if re.search("on request|with `\[?(analysis|shape|heat)", cells[-1])}
        for name in set(datasets) - optional:
            expect(name in frame, f"{path}: no dataset {name}")
        return float(frame.attrs["time"])


def check_fields(directory, frames):
    """fields.xdmf names every frame once, in order, and says of each dataset what h5py finds."""
    grids = xml.parse(os.path.join(directory, "fields.xdmf")).getroot().findall("./Domain/Grid/Grid")
    expect(len(grids) == len(frames), f"fields.xdmf has {len(grids)} grids for {len(frames)} frames")
    kinds = {"Float": "f", "Int": "i", "UInt": "u", "UChar": "u"}
    for grid, (name, time) in zip(grids, frames):
        expect(float(grid.find("Time").get("Value")) == time, f"fields.xdmf: wrong time of {name}")
        with h5py.File(os.path.join(directory, name)) as frame:
            items = grid.findall(".//DataItem")
            expect(len(items) == len(frame["particles"]) + 1, f"fields.xdmf: {len(items)} arrays of {name}")
            expect(grid.find("Geometry/DataItem").text == f"{name}:/particles/position", f"no positions of {name}")
            for item in items:
                file, place = item.text.split(":")
                expect(file == name, f"fields.xdmf: {item.text} in the grid of {name}")
                dataset = frame[place]
                shape = tuple(int(n) for n in item.get("Dimensions").split())
                expect(shape == dataset.shape, f"fields.xdmf: {item.text} has dimensions {shape}")
                kind = (kinds[item.get("NumberType")], int(item.get("Precision")))
                expect(kind == (dataset.dtype.kind, dataset.dtype.itemsize), f"fields.xdmf: {item.text} is {kind}")
            for attribute in grid.findall("Attribute"):
                columns = frame[attribute.find("DataItem").text.split(":")[1]].shape[1:]
                kind = {(): "Scalar", (3,): "Vector", (9,): "Tensor"}.get(columns, "Matrix")
                expect(attribute.get("AttributeType") == kind, f"fields.xdmf: {attribute.get('Name')} is no {kind}")


def check_table(directory, name, document):
    """The header is documented, in this order; rows are full, times ascend and numbers are numbers.

    Columns with names of the case (WALL_force_x) and those behind the first table are there when the case asks for them.
    """
    with open(os.path.join(directory, name), newline="") as file:
        header, *rows = list(csv.reader(file))
    columns = [column for column, _ in documented(document, name) if column == column.lower()]
    usual = columns[: columns.index("stickiness") + 1] if "stickiness" in columns else columns
    expect(
        header == [column for column in columns if column in header] and header[: len(usual)] == usual,
        f"{name} has the columns {header}, documented are {columns}",
    )
    times = [float(row[0]) for row in rows]
    expect(times == sorted(times) and all(map(math.isfinite, times)), f"{name}: times do not ascend")
    for row in rows:
        expect(len([float(number) for number in row]) == len(header), f"{name}: {len(row)} numbers in a row")


def check_snippets(directory, document):
    """Runs the Python examples; those for pandas only where it is installed, those for tracks only where there are any."""
    os.chdir(directory)
    for code in code_blocks(document, "python"):
        if "pandas" in code and not importlib.util.find_spec("pandas"):
            continue
        if "tracks.csv" in code and not os.path.exists("tracks.csv"):
            continue
        exec(compile(code, "files.md", "exec"), {})


def main(directory, document_path):
    with open(document_path) as file:
        document = file.read()
    names = sorted(os.listdir(os.path.join(directory, "frames")))
    frames = [(f"frames/{name}", check_frame(os.path.join(directory, "frames", name), document)) for name in names]
    expect(len(frames) > 0, "there are no frames")
    check_fields(directory, frames)
    check_table(directory, "series.csv", document)
    for name in ("tracks.csv", "agglomerates.csv"):
        if os.path.exists(os.path.join(directory, name)):
            check_table(directory, name, document)
    listed = re.findall(r"^\| `([^`/]+)", document.split("\n## ")[0], re.MULTILINE)
    for name in os.listdir(directory):
        expect(name in listed or name.endswith(".png"), f"{name} is not in the list of files")
    with open(os.path.join(directory, "summary.json")) as file:
        summary = json.load(file)
    schema = json.loads(code_blocks(document, "json-schema")[0])
    violations.extend(f"summary.json: {error.message}" for error in jsonschema.Draft7Validator(schema).iter_errors(summary))
    expect(os.path.exists(os.path.join(directory, "case.toml")), "there is no case.toml")
    check_snippets(directory, document)
    print("\n".join(violations))
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], os.path.abspath(sys.argv[2])))
