"""A little reader of NC programs, to compare the readers of bladewright with.

It shares nothing with them: one function for each grammar, no classes, the standard library alone.
It reads the excerpts of a family file and writes, for each one that can be read, where every line
that moves ends. Make the expected poses again with

    python3 tests/foreign/little_reader.py tests/foreign/*.txt

For NAME.txt it writes NAME.json: for each excerpt a list of moves
[line, point, tool axis, rotary degrees, feed, points on the way]. Points are in mm in the coordinates of the
program's zero; a tool axis that rotary words say is null; so is every number that the program has not
said. A feed is in mm/min, "rapid", or null where it is inverse time. Points on the way stand for arcs
only: at a quarter, a half and three quarters of it.
"""

import json
import math
import re
import sys


# From the gauge line to the tip of the tool that the test has: G43 and D add it to Z of positions of the axes.
LENGTH = 75.0

# Matrices are lists of rows; a frame is a pair of a matrix and a shift.
UNIT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
PLAIN = (UNIT, [0, 0, 0])


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {
        "X": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "Y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "Z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }[axis]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def apply(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def transposed(m):
    return [[m[j][i] for j in range(3)] for i in range(3)]


def outwards(frame, p):
    """A point of a frame as one of the zero; unknown coordinates stay so where nothing is turned."""
    m, t = frame
    if m == UNIT:
        return [None if v is None else v + d for v, d in zip(p, t)]
    return [None] * 3 if None in p else [v + d for v, d in zip(apply(m, p), t)]


def inwards(frame, p):
    m, t = frame
    if m == UNIT:
        return [None if v is None else v - d for v, d in zip(p, t)]
    return [None] * 3 if None in p else apply(transposed(m), [v - d for v, d in zip(p, t)])


def within(outer, inner):
    return (times(outer[0], inner[0]), outwards(outer, inner[1]))


def unit(v):
    n = math.sqrt(sum(c * c for c in v))
    return [c / n for c in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def on_arc(start, end, centre, axis, turns=0):
    """Points at 1/4, 1/2, 3/4 of the arc counter-clockwise about the axis, a helix where it climbs."""
    n = unit(axis)
    radial = [s - c for s, c in zip(start, centre)]
    radial = [r - dot(radial, n) * k for r, k in zip(radial, n)]
    foot = [s - r for s, r in zip(start, radial)]
    other = [e - f for e, f in zip(end, foot)]
    climb = dot(other, n)
    side = cross(n, radial)
    angle = math.atan2(dot(other, side), dot(other, radial))
    while angle < 1e-9:
        angle += 2 * math.pi
    angle += 2 * math.pi * turns
    return [
        [foot[i] + radial[i] * math.cos(f * angle) + side[i] * math.sin(f * angle) + n[i] * climb * f for i in range(3)]
        for f in (0.25, 0.5, 0.75)
    ]


def centre_by_radius(start, end, axis, radius):
    """The centre left of the chord for the short way counter-clockwise, right of it for the long way."""
    n = unit(axis)
    chord = [e - s for s, e in zip(start, end)]
    chord = [c - dot(chord, n) * k for c, k in zip(chord, n)]
    half = math.sqrt(dot(chord, chord)) / 2
    height = math.sqrt(max(radius * radius - half * half, 0)) * (1 if radius > 0 else -1)
    left = unit(cross(n, chord))
    return [s + c / 2 + height * l for s, c, l in zip(start, chord, left)]


# --- APT ---------------------------------------------------------------------------------------


def apt(text, _start):
    scale, frame, axis, feed, rpm, rapid, circle = 1.0, PLAIN, [0, 0, 1], None, 0, False, None
    point, moves, joined = [None] * 3, [], ""
    for number, line in enumerate(text.split("\n"), 1):
        line = line.strip()
        if re.match(r"(PPRINT|PARTNO|REMARK)", line) or line.startswith("$$"):
            continue
        line = line.split("$$")[0]
        if "$" in line:
            joined += line.split("$")[0]
            continue
        whole, joined = joined + line, ""
        major, _, minor = whole.partition("/")
        major = " ".join(major.split()).upper()
        words = [w.strip().upper() for w in minor.split(",") if w.strip()]
        numbers = [float(w) for w in words if re.fullmatch(r"[-+]?[\d.]+(E[-+]?\d+)?", w)]
        if major == "UNITS":
            scale = 25.4 if words[0].startswith("INCH") else 1.0
        elif major == "RAPID":
            rapid = True
        elif major == "SPINDL":
            rpm = numbers[0] if numbers else rpm
        elif major == "FEDRAT":
            per = next((w for w in words if w in ("MMPM", "IPM", "MMPR", "IPR")), "")
            feed = numbers[0] * {"": scale, "MMPM": 1, "IPM": 25.4, "MMPR": rpm, "IPR": 25.4 * rpm}[per]
        elif major == "TLAXIS":
            axis = numbers
        elif major == "MSYS":
            x, y = unit(numbers[3:6]), numbers[6:9]
            z = unit(cross(x, y))
            y = cross(z, x)
            known = outwards(frame, point)
            frame = ([[x[i], y[i], z[i]] for i in range(3)], [scale * v for v in numbers[:3]])
            point = inwards(frame, known)
        elif major == "CIRCLE":
            circle = ([scale * v for v in numbers[:3]], numbers[3:6])
        elif major == "GOHOME":
            point = [None] * 3
            moves.append([number, point, None, {}, "rapid", None])
        elif major in ("GOTO", "FROM", "GODLTA"):
            before = point
            point = [scale * v for v in numbers[:3]]
            if major == "GODLTA":
                point = [b + p for b, p in zip(before, point)]
            if len(numbers) == 6:
                axis = numbers[3:]
            via = None
            if circle:
                via = [outwards(frame, p) for p in on_arc(before, point, *circle)]
            speed = "rapid" if rapid or major == "FROM" else feed
            moves.append([number, outwards(frame, point), apply(frame[0], unit(axis)), {}, speed, via])
            rapid, circle = rapid and major == "FROM", None
        elif major == "FINI":
            break
    return moves


# --- G code ------------------------------------------------------------------------------------


def gcode(text, start):
    lines = text.split("\n")
    state = {
        "motion": 0, "plane": "Z", "inch": 1.0, "inch feed": 1.0, "steps": False, "inverse": False, "feed": None,
        "local": PLAIN, "plane frame": None, "own": PLAIN, "absolute centres": False,
    }
    point, rotary, moves, constants = [None] * 3, {}, [], {}
    length, siemens = 0.0, re.search(r"[A-Z]\d?=", text) is not None

    def shown(p):
        """As the axes stand: with the tool's length, where these are what is programmed."""
        p = outwards(frame(), p)
        return p if start != "machine" or p[2] is None else [p[0], p[1], p[2] + length]

    def frame():
        whole = state["local"]
        if state["plane frame"]:
            whole = within(whole, state["plane frame"])
        return within(whole, state["own"])

    def change(key, value):
        nonlocal point
        known = outwards(frame(), point)
        state[key] = value
        point = inwards(frame(), known)

    def value(text):
        text = text.replace(" ", "")
        sign = -1 if text.startswith("-") else 1
        name = text.lstrip("+-")
        return sign * constants[name] if name in constants else float(text)

    bodies = {}
    for i, line in enumerate(lines):
        plain = line.strip().upper()
        found = re.match(r"%_N_(\w+)_SPF|O0*(\d+)\s*(?:\(.*)?$|O(\d+)\s+SUB", plain)
        if found:
            bodies[next(g for g in found.groups() if g)] = i + 1

    def run(i):
        """Runs lines from i on until the program or the subprogram ends."""
        nonlocal point, rotary, length
        while i < len(lines):
            raw = lines[i].strip().upper()
            i += 1
            raw = re.sub(r"(CYCLE832|MSG|WORKPIECE|GROUP_\w+|FGROUP)\(.*\)", "", raw)
            raw = re.sub(r";.*", "", raw)
            if re.match(r"O\d+\s+SUB", raw):
                while not re.match(r"O\d+\s+ENDSUB", lines[i].strip().upper()):
                    i += 1
                i += 1
                continue
            if re.match(r"O\d+\s+ENDSUB|PROC\b", raw):
                if raw.startswith("PROC"):
                    continue
                return False
            called = re.match(r"O(\d+)\s+CALL", raw) or re.match(r'(?:N\d+\s*)?CALL\s+"(\w+)"', raw)
            if called:
                run(bodies[called.group(1)])
                continue
            if raw.startswith(("%", "O")) and not raw.startswith("ORI"):
                continue
            swivel = re.search(r"CYCLE800\((.*)\)", raw)
            if swivel:
                words = [w.strip().strip('"') for w in swivel.group(1).split(",")]
                if words == [""]:
                    change("plane frame", None)
                    continue
                number = lambda k: float(words[k]) if k < len(words) and words[k] else 0.0
                matrix = UNIT
                for k in range(3):
                    kind = int(number(3)) >> (2 * k) & 3
                    if kind:
                        matrix = times(matrix, turn("XYZ"[kind - 1], number(7 + k)))
                scale = state["inch"]
                inner = (UNIT, [scale * number(k) for k in (10, 11, 12)])
                change("plane frame", within((matrix, [scale * number(k) for k in (4, 5, 6)]), inner))
                if number(13):
                    point = [None] * 3
                    moves.append([i, [None] * 3, [row[2] for row in frame()[0]], {}, "rapid", None])
                continue
            named = {}
            for name, way, text in re.findall(r"\b([XYZABC])\s*=\s*(IC|AC|DC|ACP|ACN)\(([^)]*)\)", raw):
                named[name] = (way, value(text))
            raw = re.sub(r"\b[XYZABC]\s*=\s*(IC|AC|DC|ACP|ACN)\([^)]*\)", "", raw)
            raw = re.sub(r"\([^)]*\)", "", raw)
            sets = re.findall(r"(R\d+|#\d+)\s*=\s*(\S+)", raw)
            if sets and not re.search(r"[XYZ]\s*=\s*R", raw):
                for name, text in sets:
                    constants[name] = value(text)
                continue
            words = []
            for name in ("TRANS", "ATRANS", "ROT", "AROT"):
                if re.search(r"\b%s\b" % name, raw):
                    words.append(("FRAME", name))
                    raw = re.sub(r"\b%s\b" % name, "", raw)
            raw = re.sub(r"\b(TRAORI|TRAFOOF|ORIWKS|ORIAXES|ORIVECT|ORIPLANE|COMPCAD|COMPOF|FFWON|SOFT|UPATH|STOPRE)\b", "", raw)
            call = re.fullmatch(r"\s*(?:N\d+\s+)?([A-Z_]{2,}\d*|L\d+)(?:\s+P(\d+))?\s*", raw)
            if call and call.group(1) in bodies:
                for _ in range(int(call.group(2) or 1)):
                    run(bodies[call.group(1)])
                continue
            if re.search(r"\bRET\b|\bM17\b|\bM99\b", raw):
                return False
            for name, text in re.findall(r"(RPL|CR|TURN|A3|B3|C3|T|S|[A-Z])\s*=\s*(\"[^\"]*\"|[-+\w.#]+)", raw):
                if not text.startswith('"'):
                    words.append((name, value(text)))
            raw = re.sub(r"(RPL|CR|TURN|A3|B3|C3|T|S|[A-Z])\s*=\s*(\"[^\"]*\"|[-+\w.#]+)", "", raw)
            for name, text in re.findall(r"([A-Z])\s*([-+]?\s*(?:#\d+|[\d. ]*[\d.]))", raw):
                words.append((name, value(text)))
            codes = [round(v, 1) for n, v in words if n == "G"]
            said = {n: v for n, v in words if n != "G" and n != "M"}
            functions = [int(v) for n, v in words if n == "M"]
            if 98 in functions:
                name, count = int(said["P"]), int(said.get("L", 1))
                if str(name) not in bodies:
                    name, count = name % 10000, name // 10000
                for _ in range(count):
                    run(bodies[str(name)])
                continue
            for code in codes:
                if code in (0, 1, 2, 3):
                    state["motion"] = int(code)
                elif code in (17, 18, 19):
                    state["plane"] = {17: "Z", 18: "Y", 19: "X"}[code]
                elif code in (20, 70, 700, 21, 71, 710):
                    state["inch"] = 25.4 if code in (20, 70, 700) else 1.0
                    # G70 of Siemens is for lengths alone.
                    state["inch feed"] = 1.0 if siemens and code == 70 else state["inch"]
                elif code in (90, 91):
                    state["steps"] = code == 91
                elif code in (93, 94):
                    state["inverse"] = code == 93
                elif code in (90.1, 91.1):
                    state["absolute centres"] = code == 90.1
                elif code == 69:
                    change("plane frame", None)
                    change("own", PLAIN)
                elif code in (43, 49):
                    length = LENGTH if code == 43 else 0.0
            if siemens and "D" in said:
                length = LENGTH if said["D"] > 0 else 0.0
            scale = state["inch"]
            if 4 in codes:
                continue
            xyz = {n: scale * said[n] for n in "XYZ" if n in said}
            frame_word = next((v for n, v in words if n == "FRAME"), None)
            if frame_word or 52 in codes or 68 in codes or 68.2 in codes:
                shift = [xyz.get(n, 0.0) for n in "XYZ"]
                if frame_word:
                    before = state["own"] if frame_word.startswith("A") else PLAIN
                    if "TRANS" in frame_word:
                        new = (UNIT, shift)
                    elif "RPL" in said:
                        new = (turn(state["plane"], said["RPL"]), [0, 0, 0])
                    else:
                        new = PLAIN
                        for n in "XYZ":
                            if n in said:
                                new = (turn(n, said[n]), [0, 0, 0])
                    change("own", within(before, new))
                elif 52 in codes:
                    old = state["local"][1]
                    change("local", (UNIT, [xyz.get(n, o) for n, o in zip("XYZ", old)]))
                elif 68 in codes:
                    matrix = turn(state["plane"], said["R"])
                    shift["XYZ".index(state["plane"])] = 0.0
                    moved = apply(matrix, shift)
                    change("own", (matrix, [s - m for s, m in zip(shift, moved)]))
                else:
                    matrix = times(times(turn("Z", said.get("I", 0)), turn("X", said.get("J", 0))), turn("Z", said.get("K", 0)))
                    change("plane frame", (matrix, shift))
                continue
            if 53.1 in codes:
                point = [None] * 3
                moves.append([i, [None] * 3, [row[2] for row in frame()[0]], {}, "rapid", None])
                continue
            if "F" in said:
                state["feed"] = said["F"] * (1.0 if state["inverse"] else state["inch feed"])
            turns = {n: said[n] for n in "ABC" if n in said}
            vector = None
            if any(n in said for n in ("A3", "B3", "C3")):
                vector = [said.get(n, 0.0) for n in ("A3", "B3", "C3")]
            elif start == "vectors" and any(n in said for n in "IJK"):
                vector = [said.get(n, 0.0) for n in "IJK"]
            is_arc = state["motion"] in (2, 3) and (any(n in said for n in "IJKR") or "CR" in said)
            if not (xyz or turns or named or vector or is_arc or 28 in codes or 30 in codes):
                if 2 in functions or 30 in functions:
                    return True
                continue
            if 28 in codes or 30 in codes:
                for n in [n for n in "XYZ" if n in said] or "XYZ":
                    point["XYZ".index(n)] = None
                # Over the part is nothing known of axes at their reference positions.
                gone = shown(point) if start == "machine" else [None] * 3
                moves.append([i, gone, None, {}, "rapid", None])
                continue
            before = list(point)
            to = list(point)
            for n, v in xyz.items():
                k = "XYZ".index(n)
                to[k] = to[k] + v if state["steps"] else v
            for n, (way, v) in named.items():
                if n in "XYZ":
                    k = "XYZ".index(n)
                    to[k] = to[k] + scale * v if way == "IC" else scale * v
                else:
                    old = rotary.get(n, 0.0)
                    ways = {
                        "IC": old + v, "AC": v, "DC": old + (v - old + 180) % 360 - 180,
                        "ACP": old + (v - old) % 360, "ACN": old - (old - v) % 360,
                    }
                    rotary[n] = ways[way]
            for n, v in turns.items():
                rotary[n] = rotary.get(n, 0.0) + v if state["steps"] else v
            via = None
            if is_arc:
                axis = {"Z": [0, 0, 1], "Y": [0, 1, 0], "X": [1, 0, 0]}[state["plane"]]
                if state["motion"] == 2:
                    axis = [-v for v in axis]
                radius = said.get("CR", said.get("R"))
                if radius is not None:
                    centre = centre_by_radius(before, to, axis, scale * radius)
                elif state["absolute centres"]:
                    centre = [scale * said.get(n, 0.0) for n in "IJK"]
                else:
                    centre = [b + scale * said.get(n, 0.0) for n, b in zip("IJK", before)]
                more = said.get("TURN", said.get("P", 1) - 1)
                via = [shown(p) for p in on_arc(before, to, centre, axis, int(more))]
            point = to
            speed = "rapid" if state["motion"] == 0 else None if state["inverse"] else state["feed"]
            axis = None
            if vector:
                axis = apply(frame()[0], unit(vector))
            elif state["plane frame"] and start == "plane":
                axis = [row[2] for row in frame()[0]]
            if 53 in codes:
                moves.append([i, [xyz.get(n) for n in "XYZ"], None, dict(rotary), speed, None])
                point = [None] * 3
            else:
                moves.append([i, shown(point), axis, {} if axis else dict(rotary), speed, via])
            if 2 in functions or 30 in functions:
                return True
        return True

    run(0)
    return moves


# --- Klartext ----------------------------------------------------------------------------------


def klartext(text, _start):
    lines = text.split("\n")
    shift, plane, pole, feed, shorter = [0.0] * 3, None, None, None, False
    point, rotary, constants, moves = [None] * 3, {}, {}, []
    labels = {}
    for i, line in enumerate(lines):
        found = re.match(r"\d+ LBL (\S+)", line.strip())
        if found and found.group(1) != "0":
            labels.setdefault(found.group(1), i)

    def frame():
        return within((UNIT, shift), (plane or UNIT, [0, 0, 0]))

    def value(text):
        text = text.replace(",", ".")
        sign = -1 if text.startswith("-") else 1
        name = text.lstrip("+-")
        return sign * constants[name] if name in constants else float(text)

    def run(i, until=None):
        nonlocal shift, plane, pole, feed, shorter, point
        left = {}
        while i < len(lines):
            if i == until:
                return
            here = i
            words = lines[i].split(";")[0].replace(" F MAX", " FMAX").split()[1:]
            i += 1
            head = words[0] if words else ""
            if head == "LBL" and words[1] == "0" and until is not None:
                return
            if words[:2] == ["CALL", "LBL"]:
                if "REP" in " ".join(words[3:]):
                    count = int("".join(words[3:])[3:].split("/")[0])
                    if left.setdefault(here, count):
                        left[here] -= 1
                        i = labels[words[2]]
                    else:
                        del left[here]
                else:
                    run(labels[words[2]], until=-1)
                continue
            if head == "M126":
                shorter = True
            if head in ("M2", "M30", "END"):
                return
            if head.startswith("Q") and "=" in "".join(words):
                name, text = "".join(words).split("=")
                constants[name] = value(text)
                continue
            if head.startswith("FN"):
                name, text = "".join(words).split(":")[1].split("=")
                constants[name] = value(text)
                continue
            old = frame()
            known = outwards(old, point)
            if words[:2] == ["CYCL", "DEF"] and words[2] in ("7.1", "7.2", "7.3") or words[:2] == ["TRANS", "DATUM"]:
                if "RESET" in words:
                    shift = [0.0] * 3
                for w in words[2:]:
                    found = re.fullmatch(r"(I?)([XYZ])([-+].*)", w)
                    if found:
                        k = "XYZ".index(found.group(2))
                        shift = list(shift)
                        shift[k] = value(found.group(3)) + (shift[k] if found.group(1) else 0.0)
                point = inwards(frame(), known)
                continue
            if head == "PLANE":
                if words[1] == "RESET":
                    plane = None
                else:
                    a, b, c = (value(w[3:]) for w in words[2:5])
                    plane = times(times(turn("Z", c), turn("Y", b)), turn("X", a))
                point = inwards(frame(), known)
                if "STAY" not in words:
                    point = [None] * 3
                    moves.append([i, [None] * 3, [row[2] for row in frame()[0]], {}, "rapid", None])
                continue
            if head == "CC":
                pole = {w[0]: value(w[1:]) for w in words[1:]}
                continue
            if head == "TOOL" and words[1] == "CALL":
                for w in words:
                    if re.fullmatch(r"F[\d.,]+", w):
                        feed = value(w[1:])
                continue
            if head not in ("L", "LN", "C", "CR"):
                continue
            before, to, vector, rapid, machine, radius, sense, moved = list(point), list(point), {}, False, False, None, None, False
            for w in words[1:]:
                found = re.fullmatch(r"(I?)(T?[XYZ]|[ABC])([-+\dQ].*)", w)
                if found:
                    step, name, text = found.groups()
                    moved = True
                    if name[0] == "T":
                        vector[name[1]] = value(text)
                    elif name in "XYZ":
                        k = "XYZ".index(name)
                        to[k] = value(text) + (to[k] if step else 0.0)
                    else:
                        old_angle, new = rotary.get(name, 0.0), value(text)
                        if step:
                            new += old_angle
                        elif shorter:
                            new = old_angle + (new - old_angle + 180) % 360 - 180
                        rotary[name] = new
                elif w == "FMAX":
                    rapid = True
                elif re.fullmatch(r"F[\d.,]+", w):
                    feed = value(w[1:])
                elif w == "M91":
                    machine = True
                elif w in ("DR+", "DR-"):
                    sense = w[2]
                elif head == "CR" and re.fullmatch(r"R[-+\d].*", w) and w != "R0":
                    radius = value(w[1:])
            if not moved:
                continue
            via = None
            if head in ("C", "CR"):
                axis = [0, 0, 1 if sense == "+" else -1]
                if head == "CR":
                    centre = centre_by_radius(before, to, axis, radius)
                else:
                    centre = [pole["X"], pole["Y"], before[2]]
                via = [outwards(frame(), p) for p in on_arc(before, to, centre, axis)]
            speed = "rapid" if rapid else feed
            if machine:
                said = {w[0]: value(w[1:]) for w in words[1:] if re.fullmatch(r"[XYZ][-+\d].*", w)}
                moves.append([i, [said.get(n) for n in "XYZ"], None, dict(rotary), speed, None])
                point = [None] * 3
                continue
            point = to
            axis = apply(frame()[0], unit([vector[n] for n in "XYZ"])) if vector else None
            if plane and axis is None:
                axis = [row[2] for row in frame()[0]]
            moves.append([i, outwards(frame(), point), axis, {} if axis else dict(rotary), speed, via])

    run(0)
    return moves


def excerpts(text):
    """Name, grammar, meaning of X Y Z, whether it is refused, and text of each excerpt."""
    for part in text.split("=== ")[1:]:
        head, _, body = part.partition("\n")
        name, how, *refused = [p.strip() for p in head.split("|")]
        grammar, start = how.split()
        yield name, grammar, start, refused, body.rstrip("\n")


def main():
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            text = file.read()
        reader = {"apt": apt, "gcode": gcode, "heidenhain": klartext}
        rows = []
        for name, grammar, start, refused, body in excerpts(text):
            if not refused:
                moves = reader[grammar](body, start)
                rows.append(json.dumps(name) + ": [\n" + ",\n".join("  " + json.dumps(m) for m in moves) + "\n]")
        with open(path.removesuffix(".txt") + ".json", "w", encoding="utf-8") as file:
            file.write("{\n" + ",\n".join(rows) + "\n}\n")


if __name__ == "__main__":
    main()
