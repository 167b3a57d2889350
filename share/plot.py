"""Draws a run of Scree: DIR/series.png from series.csv, and DIR/particles.png from the last frame;
DIR/groups.png too where the particles belong to several groups; DIR/fluid.png from the last frame of a fluid.

usage: plot.py DIR
"""

import argparse
import pathlib
import sys

try:
    import h5py
    import matplotlib
    import numpy as np
except ImportError as missing:
    sys.exit(f"plot.py: {missing}; install the packages python3-numpy, python3-h5py and python3-matplotlib")

matplotlib.use("Agg")

import plot_fluid
import plot_particles
import plot_series


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("directory", type=pathlib.Path, help="a run directory")
    directory = parser.parse_args().directory
    pictures = []
    if (directory / "series.csv").exists():
        pictures.append(plot_series.draw(directory / "series.csv", directory / "series.png"))
    frames = sorted((directory / "frames").glob("frame_*.h5"))
    if frames:
        pictures += plot_particles.draw(frames[-1], directory)
    fluid = sorted((directory / "fluid").glob("fluid_*.h5"))
    if fluid:
        pictures.append(plot_fluid.draw(fluid[-1], directory / "fluid.png"))
    if not any(pictures):
        sys.exit(f"plot.py: '{directory}' holds neither rows in series.csv nor frames; is it a run directory?")
    for picture in filter(None, pictures):
        print(picture)


if __name__ == "__main__":
    main()
