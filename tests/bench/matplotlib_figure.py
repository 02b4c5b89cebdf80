#!/usr/bin/env python3
"""Draws the figure of an SVG file by gjkscope with matplotlib, again and again, into a PNG.

Usage: matplotlib_figure.py FIGURE.svg FIGURE.png COUNT
Prints the seconds of the processor that one drawing takes. Reading the SVG and starting up are not in them.
"""

import io
import re
import sys
import time
import xml.etree.ElementTree as ElementTree

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Circle, FancyBboxPatch, PathPatch
from matplotlib.path import Path

DPI = 100


def style(element):
    def color(name):
        value = element.get(name)
        if value in (None, "none"):
            return "none"
        return matplotlib.colors.to_rgba(value, float(element.get(name + "-opacity", 1)))

    width = float(element.get("stroke-width", 0)) * 72 / DPI
    out = {"facecolor": color("fill"), "edgecolor": color("stroke"), "linewidth": width}
    if dashes := element.get("stroke-dasharray"):
        out["linestyle"] = (0, [float(d) / float(element.get("stroke-width")) for d in re.split("[ ,]", dashes)])
    return out


def path_of(text):
    points, codes = [], []
    for command, x, y in re.findall(r"([MLZ])(?:([-\d.]+) ([-\d.]+))?", text):
        points.append((float(x), float(y)) if x else (0, 0))
        codes.append({"M": Path.MOVETO, "L": Path.LINETO, "Z": Path.CLOSEPOLY}[command])
    return Path(points, codes)


def read(file):
    """Width, height and marks: functions that add one to axes."""
    root = ElementTree.parse(file).getroot()
    marks = []
    for element in root:
        get = lambda name, e=element: float(e.get(name, 0))
        kind = element.tag.rpartition("}")[2]
        if kind == "rect":
            at = (get("x"), get("y"), get("width"), get("height"), get("rx"), style(element))
            marks.append(lambda axes, at=at: axes.add_patch(FancyBboxPatch(
                at[:2], at[2], at[3], boxstyle=f"round,pad=0,rounding_size={at[4]}", **at[5])))
        elif kind == "circle":
            at = ((get("cx"), get("cy")), get("r"), style(element))
            marks.append(lambda axes, at=at: axes.add_patch(Circle(at[0], at[1], **at[2])))
        elif kind == "path":
            at = (path_of(element.get("d")), style(element))
            marks.append(lambda axes, at=at: axes.add_patch(PathPatch(at[0], **at[1])))
        elif kind == "text":
            at = (get("x"), get("y"), "".join(element.itertext()).replace("$", r"\$"),
                  get("font-size") * 72 / DPI, element.get("fill"))
            marks.append(lambda axes, at=at: axes.text(*at[:3], fontsize=at[3], color=at[4]))
    return float(root.get("width")), float(root.get("height")), marks


def draw(width, height, marks):
    figure = plt.figure(figsize=(width / DPI, height / DPI), dpi=DPI)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_xlim(0, width)
    axes.set_ylim(height, 0)
    axes.set_axis_off()
    for mark in marks:
        mark(axes)
    png = io.BytesIO()
    figure.savefig(png, format="png", dpi=DPI)
    plt.close(figure)
    return png.getvalue()


def main():
    figure = read(sys.argv[1])
    count = int(sys.argv[3])
    with open(sys.argv[2], "wb") as file:
        file.write(draw(*figure))  # What is loaded once is loaded now.
    begin = time.process_time()
    for _ in range(count):
        draw(*figure)
    print((time.process_time() - begin) / count)


main()
