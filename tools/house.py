"""What the checks of the source tree share. Each check returns problems as texts "path:line: what is wrong"."""

import pathlib
import re
import sys

SOURCE_SUFFIXES = {".h", ".cpp", ".cl"}


def files(root, *folders, suffixes=SOURCE_SUFFIXES):
    """All files with those suffixes below the folders, in order."""
    found = (path for folder in folders for path in (root / folder).rglob("*"))
    return sorted(path for path in found if path.suffix in suffixes and path.is_file())


def numbered_lines(path):
    return enumerate(path.read_text(encoding="utf-8").splitlines(), start=1)


def code_words(text):
    """The words in backticks of a Markdown text."""
    return re.findall(r"`([^`\n]+)`", text)


def main(check):
    """Runs a check on the source tree given on the command line; the exit code tells whether it found anything."""
    problems = check(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:])
    print(*problems, sep="\n", end="\n" if problems else "")
    sys.exit(1 if problems else 0)
