#!/usr/bin/python3
"""Checks that ARCHITECTURE.md is about this tree. usage: check_architecture.py SOURCE_DIRECTORY

Its list of folders is a code block with one folder per line, indented by two spaces per level, a description behind two
spaces or more. Names in backticks that look like files must exist, below the root or below src/scree.
"""

import re

import house

LONGEST = 150
LISTED_TO = 2  # levels below src/scree
FILE_LIKE = re.compile(r"[\w.*/-]+/|[\w./*-]+\.(h|cpp|py|md|toml|cmake|txt|json)")


def listed_folders(text):
    """Paths of the folders in the first code block whose first line is "src/scree/"."""
    match = re.search(r"^```\n(src/scree/.*?)^```", text, re.MULTILINE | re.DOTALL)
    folders, open_folders = set(), []
    for line in match.group(1).splitlines() if match else []:
        depth = (len(line) - len(line.lstrip())) // 2
        name = line.split()[0]
        if not name.endswith("/"):
            continue
        open_folders[depth:] = [name]
        folders.add("".join(open_folders))
    return folders


def folders_of_tree(root):
    """Folders below src/scree that hold source files, down to LISTED_TO levels."""
    found = {"src/scree/"}
    for path in house.files(root, "src/scree"):
        parts = path.relative_to(root / "src/scree").parts[:-1][:LISTED_TO]
        found.update("src/scree/" + "/".join(parts[:n]) + "/" for n in range(1, len(parts) + 1))
    return found


def exists(root, name):
    """NAME and NN_name stand for any name."""
    pattern = re.sub("NN_name|NAME", "*", name).rstrip("/")
    return any(any(base.glob(pattern)) for base in (root, root / "src/scree"))


def check(root):
    path = root / "ARCHITECTURE.md"
    text = path.read_text(encoding="utf-8")
    problems = []
    if len(text.splitlines()) > LONGEST:
        problems.append(f"{path}:{LONGEST + 1}: longer than {LONGEST} lines")
    listed, real = listed_folders(text), folders_of_tree(root)
    problems += [f"{path}:1: {folder} is not in the list of folders" for folder in sorted(real - listed)]
    problems += [f"{path}:1: {folder} is listed and does not exist" for folder in sorted(listed - real)]
    for number, line in house.numbered_lines(path):
        for word in house.code_words(line):
            if FILE_LIKE.fullmatch(word) and not exists(root, word):
                problems.append(f"{path}:{number}: {word} does not exist")
    return problems


if __name__ == "__main__":
    house.main(check)
