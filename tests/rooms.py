#!/usr/bin/env python3
"""Fails where an include goes up or round in a circle between rooms; draws the rooms with --draw FILE.svg.

A room is a folder with code. The tables headed "| room |" in the READMEs of cloth, collision, engine and render
list them from top to bottom, and are the order that is allowed: a room includes rooms below it. Of the top
folders, each includes those after it.
"""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
tops = ["demo", "render", "cloth", "collision", "engine"]  # render and cloth do not know each other


def listed_rooms(top):
    rows = re.search(r"^\| room \|.*\n\|---.*\n((?:\|.*\n)+)", (root / top / "README.md").read_text(), re.M)
    names = re.findall(r"^\| `(.*?)/?` \|", rows[1], re.M) if rows else []
    return [top if name == "." else f"{top}/{name}" for name in names]


def room_of(path):
    return path.split("/")[0] + "/include" if "/include/" in path else str(pathlib.Path(path).parent)


files = [str(f.relative_to(root)) for top in tops for kind in ("*.h", "*.cpp") for f in (root / top).rglob(kind)]
known = {re.sub(r"^\w+/include/", "", f): f for f in files}
order = [room for top in tops for room in listed_rooms(top)]
faults, arrows, lines = [], {}, {}
for file in files:
    here = room_of(file)
    text = (root / file).read_text(encoding="utf-8")
    lines[here] = lines.get(here, 0) + text.count("\n")
    if here not in order and not file.startswith("demo/"):
        faults.append(f"{here}/ is in no table of rooms: add it to the README of {here.split('/')[0]}/")
    for name in re.findall(r'^#include ["<]([^">]+)[">]', text, re.M):
        if name not in known or room_of(known[name]) == here:
            continue
        there = room_of(known[name])
        arrows.setdefault((here, there), f"{file} includes {name}")
for (here, there), example in sorted(arrows.items()):
    a, b = here.split("/")[0], there.split("/")[0]
    is_up = order.index(here) > order.index(there) if a == b and here in order and there in order else \
        tops.index(a) > tops.index(b) or (a, b) == ("render", "cloth")
    if is_up:
        faults.append(f"{here}/ is below {there}/: {example}")
faults += [f"{room}/ has no code any more: take it out of its table" for room in order if room not in lines]


def draw(path):
    """One box a room, with its lines; arrows run from left to right, from who includes to what is included."""
    y = {room: 20 * i for i, room in enumerate(order)}
    shapes = [f'<text x="300" y="{y[r] + 14}">{r}</text><text x="290" y="{y[r] + 14}" text-anchor="end">{lines[r]}</text>'
              for r in order]
    for here, there in arrows:
        if here in y and there in y:
            top, end, x = y[here] + 10, y[there] + 10, 520
            bend = x + 10 + (end - top) // 2
            shapes.append(f'<path d="M{x},{top} C{bend},{top} {bend},{end} {x},{end}" fill="none" stroke="#0004"/>')
    height = 20 * len(order) + 10
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="{height}" '
                    f'font-family="monospace" font-size="13">{"".join(shapes)}</svg>\n')


if sys.argv[1:2] == ["--draw"]:
    draw(pathlib.Path(sys.argv[2]))
print("\n".join(sorted(set(faults))) or f"{len(order)} rooms, {len(arrows)} arrows, all of them downwards")
sys.exit(bool(faults))
