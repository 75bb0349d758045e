"""Draws a state machine as SVG: the rows come from the state tables, the layout is laid by hand below.

A row that leaves several states is drawn once, from a frame around just these states. Every edge needs a
place in the layout and every place an edge, so that a diagram cannot miss what a table says.
"""
from xml.sax.saxutils import escape

BOX_HEIGHT, LETTER = 44, 8.4  # pixels; LETTER: width of one, for the boxes
BACKGROUND, LINE, TEXT, FRAME = "#10131c", "#8fa3c8", "#e8eefc", "#4a5880"
COLOURS = {"wandering": "#4aa3ff", "grouping": "#20e0ff", "attacking": "#ff5a4a", "avoiding bullets": "#40f060",
           "escaping": "#a060ff", "checking energy": "#ffb000", "dead": "#8a8f9c"}

# Frames: name -> (left, top, right, bottom). Edges: (from, to) -> (points, (x, y, anchor) of the label);
# points are (x, y), the inner ones rounded corners. `from` is a state or a frame.
# What group and tricky share.
HUNTING = ({"wandering", "grouping", "attacking"}, (40, 96, 730, 370))
HUNTERS = {"wandering": (190, 140), "attacking": (620, 140), "grouping": (420, 300), "avoiding bullets": (420, 440),
           "checking energy": (930, 250), "dead": (930, 440)}
HUNTERS_EDGES = {
    ("living", "checking energy"): ([(750, 250), (850, 250)], (798, 242, "middle")),
    ("checking energy", "dead"): ([(930, 272), (930, 418)], (942, 350, "start")),
    ("checking energy", "attacking"): ([(910, 228), (910, 56), (630, 56), (630, 118)], (770, 48, "middle")),
    ("checking energy", "wandering"): ([(950, 228), (950, 30), (190, 30), (190, 118)], (560, 22, "middle")),
    ("wandering", "attacking"): ([(244, 132), (566, 132)], (405, 124, "middle")),
    ("attacking", "wandering"): ([(566, 152), (244, 152)], (405, 170, "middle")),
    ("wandering", "grouping"): ([(232, 162), (400, 278)], (312, 208, "start")),
    ("grouping", "wandering"): ([(370, 294), (205, 162)], (296, 260, "end")),
    ("grouping", "attacking"): ([(442, 278), (585, 162)], (526, 230, "start")),
    ("attacking", "grouping"): ([(655, 162), (655, 300), (471, 300)], (482, 322, "start")),
    ("hunting", "avoiding bullets"): ([(420, 370), (420, 418)], (432, 400, "start")),
    ("avoiding bullets", "wandering"): ([(337, 440), (160, 440), (160, 162)], (250, 432, "middle")),
}

LAYOUTS = {
    "kamikaze": {
        "size": (900, 340),
        "states": {"wandering": (140, 130), "attacking": (440, 130), "checking energy": (740, 130), "dead": (740, 290)},
        "frames": {"living": ({"wandering", "attacking"}, (30, 80, 550, 210))},
        "edges": {
            ("living", "checking energy"): ([(550, 145), (660, 145)], (604, 137, "middle")),
            ("checking energy", "dead"): ([(740, 152), (740, 268)], (752, 220, "start")),
            ("checking energy", "attacking"): ([(720, 108), (720, 56), (450, 56), (450, 108)], (585, 48, "middle")),
            ("checking energy", "wandering"): ([(760, 108), (760, 30), (140, 30), (140, 108)], (430, 22, "middle")),
            ("wandering", "attacking"): ([(194, 122), (386, 122)], (290, 114, "middle")),
            ("attacking", "wandering"): ([(386, 142), (194, 142)], (290, 160, "middle")),
        },
    },
    "group": {
        "size": (1060, 520),
        "states": HUNTERS,
        "frames": {"living": ({"wandering", "grouping", "attacking", "avoiding bullets"}, (20, 76, 750, 500)),
                   "hunting": HUNTING},
        "edges": HUNTERS_EDGES,
    },
    "tricky": {
        "size": (1060, 620),
        "states": HUNTERS | {"escaping": (420, 545)},
        "frames": {"living": ({"wandering", "grouping", "attacking", "avoiding bullets", "escaping"},
                              (20, 76, 750, 600)),
                   "hunting": HUNTING},
        "edges": HUNTERS_EDGES | {
            ("checking energy", "escaping"): ([(870, 272), (870, 545), (471, 545)], (640, 537, "middle")),
            ("escaping", "wandering"): ([(369, 545), (70, 545), (70, 140), (136, 140)], (225, 537, "middle")),
        },
    },
}


def label_of(number, row):
    return f"{number}  {' and '.join(row['needs']) or 'otherwise'}"


def edges_of(rows, frames):
    """(from, to) -> label; a row that leaves just the states of a frame starts at the frame."""
    edges = {}
    for number, row in enumerate(rows, 1):
        leaves = {state for state in row["from"] if state != row["to"]}
        framed = [name for name, (states, _) in frames.items() if states == leaves]
        for start in framed or sorted(leaves):
            if (start, row["to"]) in edges:
                raise ValueError(f"two rows lead from {start} to {row['to']}: the diagram has one arrow for both")
            edges[start, row["to"]] = label_of(number, row)
    return edges


def path_of(points, radius=14):
    """A polyline with round corners."""
    text = f"M{points[0][0]} {points[0][1]}"
    for before, corner, after in zip(points, points[1:], points[2:]):
        ends = []
        for other in (before, after):
            dx, dy = other[0] - corner[0], other[1] - corner[1]
            share = radius / max(1e-9, (dx * dx + dy * dy) ** 0.5)
            ends.append((round(corner[0] + dx * share, 1), round(corner[1] + dy * share, 1)))
        text += f" L{ends[0][0]} {ends[0][1]} Q{corner[0]} {corner[1]} {ends[1][0]} {ends[1][1]}"
    return text + f" L{points[-1][0]} {points[-1][1]}"


def diagram(machine, rows):
    """The SVG text of one machine. Raises ValueError when the layout does not fit the table."""
    layout = LAYOUTS.get(machine)
    if layout is None:
        raise ValueError(f"tools/state_diagram.py has no layout for the machine '{machine}'")
    edges = edges_of(rows, layout["frames"])
    states = {state for row in rows for state in (*row["from"], row["to"])}
    for what, named, drawn in (("state", states, set(layout["states"])), ("edge", set(edges), set(layout["edges"]))):
        for thing in sorted(named ^ drawn):
            raise ValueError(f"{machine}: the {what} {thing} stands in only one of table and layout; "
                             "mend LAYOUTS in tools/state_diagram.py")
    width, height = layout["size"]
    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
           'font-family="DejaVu Sans, Verdana, sans-serif" font-size="13">',
           f"<title>The state machine {escape(machine)}</title>",
           '<defs><marker id="tip" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" '
           f'orient="auto-start-reverse"><path d="M0 0L10 5L0 10z" fill="{LINE}"/></marker></defs>',
           f'<rect width="{width}" height="{height}" rx="10" fill="{BACKGROUND}"/>']
    for _, (left, top, right, bottom) in layout["frames"].values():
        svg.append(f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" rx="16" fill="none" '
                   f'stroke="{FRAME}" stroke-width="1.5" stroke-dasharray="6 5"/>')
    for edge in edges:
        points = layout["edges"][edge][0]
        svg.append(f'<path d="{path_of(points)}" fill="none" stroke="{LINE}" stroke-width="1.6" '
                   'marker-end="url(#tip)"/>')
    for state, (x, y) in layout["states"].items():
        half = len(state) * LETTER / 2 + 16
        svg.append(f'<rect x="{x - half:g}" y="{y - BOX_HEIGHT / 2:g}" width="{2 * half:g}" height="{BOX_HEIGHT}" '
                   f'rx="12" fill="#181d2b" stroke="{COLOURS[state]}" stroke-width="2.5"/>')
        svg.append(f'<text x="{x}" y="{y + 5}" text-anchor="middle" fill="{TEXT}" font-size="14" '
                   f'font-weight="bold">{escape(state)}</text>')
    for edge, label in edges.items():
        x, y, anchor = layout["edges"][edge][1]
        svg.append(f'<text x="{x}" y="{y}" text-anchor="{anchor}" fill="{TEXT}" stroke="{BACKGROUND}" '
                   f'stroke-width="5" paint-order="stroke">{escape(label)}</text>')
    return "\n".join(svg) + "\n</svg>\n"
