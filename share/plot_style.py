"""What all pictures have in common: colours, and units that give readable numbers."""

import numpy as np

INK = "#2b3440"
COLOURS = ["#0072b2", "#e69f00", "#009e73", "#d55e00", "#cc79a7", "#56b4e9", "#8c6d31", "#7f7f7f"]

STYLE = {
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.linewidth": 0.8,
    "grid.color": "#e3e6ea",
    "grid.linewidth": 0.7,
    "lines.linewidth": 1.6,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "font.size": 10,
}


def si_scale(largest, unit):
    """The factor and the unit with a prefix that make `largest` a number between 1 and 1000."""
    prefixes = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
    if not np.isfinite(largest) or largest <= 0:
        return 1.0, unit
    power = int(np.clip(3 * np.floor(np.log10(largest * 1.0000001) / 3), -18, 9))
    return 10.0**-power, prefixes[power] + unit
