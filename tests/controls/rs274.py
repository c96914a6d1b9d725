#!/usr/bin/env python3
"""LinuxCNC's interpreter as a reader of LinuxCNC programs.

usage: LINUXCNC_ROOT=DIR/root python3 tests/controls/rs274.py PROGRAM.ngc ...

Each program is run through the `rs274` command. Every motion that it tells (four decimals) is compared with the words of the text, read
here by nothing more than a split at spaces; so are the feeds: under G93 it tells F times the length of the move. Where the package's
Python module `gcode` can be loaded (it wants the distribution's own Python), positions are compared in full digits too.
Fails on: a program that is refused, another number of motions, a position or feed that differs, a line of more than 256 characters."""
import json, math, os, re, subprocess, sys, tempfile

ROOT = os.environ["LINUXCNC_ROOT"]
LIB = ":".join(
    d for d in [ROOT + "/usr/lib", *(ROOT + "/usr/lib/" + n for n in os.listdir(ROOT + "/usr/lib") if n.endswith("-linux-gnu"))]
)
ENV = dict(os.environ, LD_LIBRARY_PATH=LIB)
LONGEST = 256
LETTERS = "XYZABCUVW"


def posted(path):
    """Motions as the text has them: (line, rapid, X Y Z A B C U V W, F of this line under G93 or None)."""
    at, rapid, inverse, out = dict.fromkeys(LETTERS, 0.0), True, False, []
    for number, line in enumerate(open(path), 1):
        if len(line.rstrip("\n")) > LONGEST:
            raise SystemExit(f"{path}: line {number} has more than {LONGEST} characters")
        words = line.split(";")[0].split()
        moved, feed = False, None
        for w in words:
            letter, value = w[0], w[1:]
            if w in ("G0", "G1"):
                rapid = w == "G0"
            elif w in ("G93", "G94"):
                inverse = w == "G93"
            elif letter in at:
                at[letter] = float(value)
                moved = True
            elif letter == "F":
                feed = float(value)
                if not feed > 0:
                    raise SystemExit(f"{path}: line {number}: F{value} is no feed")
        if moved:
            if inverse and not rapid and feed is None:
                raise SystemExit(f"{path}: line {number} has no F under G93")
            out.append((number, rapid, tuple(at[l] for l in LETTERS), feed if inverse and not rapid else None))
    return out


def command(path):
    """Motions as rs274 tells them: (rapid, X Y Z A B C, and U V W where it tells them; feed rate in force)."""
    with tempfile.TemporaryDirectory() as d:
        # Its tool table is in inches whatever the program says; offsets would persist in the variables, so they are fresh.
        open(d + "/tool.tbl", "w").write("T1 P1 Z4.0 D0.25\nT2 P2 Z4.0 D0.25\n")
        open(d + "/v.var", "w").close()
        args = [ROOT + "/usr/bin/rs274", "-g", "-t", d + "/tool.tbl", "-v", d + "/v.var", os.path.abspath(path)]
        p = subprocess.run(args, env=ENV, stdin=subprocess.DEVNULL, capture_output=True, text=True, cwd=d)
    errors = [l for l in p.stderr.splitlines() if l.strip() and l.strip() != "executing"]
    if p.returncode or errors:
        raise SystemExit(f"{path}: rs274 refuses it: {' / '.join(errors[:3])} (exit code {p.returncode})")
    out, rate = [], 0.0
    for name, inner in re.findall(r"^\s*\d+\s+N\S*\s+([A-Z_0-9]+)\((.*)\)\s*$", p.stdout, re.M):
        if name == "SET_FEED_RATE":
            rate = float(inner)
        elif name in ("STRAIGHT_FEED", "STRAIGHT_TRAVERSE"):
            out.append((name == "STRAIGHT_TRAVERSE", tuple(float(v) for v in inner.split(",")[:9]), rate))
    return out


CHILD = r"""
import json, sys, gcode
class Canon:
    parameter_file = sys.argv[2]
    rows = []
    def __getattr__(self, name): return lambda *a: None
    def straight_feed(self, *a): self.rows.append(a[:9])
    def straight_traverse(self, *a): self.rows.append(a[:9])
    def check_abort(self): return False
    def get_external_length_units(self): return 1.0
    def get_external_angular_units(self): return 1.0
    def get_axis_mask(self): return 0x1ff
    def get_block_delete(self): return False
    def get_tool(self, pocket): return (1,) + (0.0,) * 12 + (0,)
c = Canon()
result, line = gcode.parse(sys.argv[1], c, "G21 G40 G49 G80 G90 G94 G54", "")
if result > gcode.MIN_ERROR: sys.exit(gcode.strerror(result))
mm = lambda values: [v * 25.4 for v in values]
json.dump([mm(r[:3]) + list(r[3:6]) + mm(r[6:9]) for r in c.rows], sys.stdout)
"""


def module(path):
    """Motions in full digits by the package's Python module, or None where it cannot be loaded."""
    python = next((p for p in ("/usr/bin/python3.11", "/usr/bin/python3.12", "/usr/bin/python3") if os.path.exists(p)), None)
    env = dict(ENV, PYTHONPATH=ROOT + "/usr/lib/python3/dist-packages")
    if not python or subprocess.run([python, "-c", "import gcode"], env=env, capture_output=True).returncode:
        return None
    with tempfile.TemporaryDirectory() as d:
        # Without a running LinuxCNC there is no tool to change, and no INI file that names a second spindle.
        bare = lambda l: re.sub(r"^(S\d+|M[35]) \$1$", "", re.sub(r"\bT\d+ M6\b", "", l), flags=re.M)
        text = "".join(bare(l) if not l.startswith(";") else l for l in open(path))
        open(d + "/bare.ngc", "w").write(text)
        open(d + "/v.var", "w").close()
        p = subprocess.run([python, "-c", CHILD, d + "/bare.ngc", d + "/v.var"], env=env, capture_output=True, text=True)
    if p.returncode:
        raise SystemExit(f"{path}: LinuxCNC's gcode module refuses it: {p.stderr.strip()[-300:]}")
    return [tuple(r) for r in json.loads(p.stdout)]


def nine(path):
    """A program that names U V W: the command knows six letters only, the module all nine, without feeds."""
    want, full = posted(path), module(path)
    if full is None:
        print(f"{path}: not read: rs274 knows no U V W, and the package's Python module cannot be loaded")
        return
    if len(full) != len(want):
        raise SystemExit(f"{path}: {len(want)} motions are programmed, the gcode module makes {len(full)}")
    for (line, _, at, _), got in zip(want, full):
        if max(abs(a - b) for a, b in zip(at, got)) > 1e-9:
            raise SystemExit(f"{path}: line {line}: {at} is posted, the gcode module goes to {got}")
    print(f"{path}: {len(want)} motions of nine letters, the same in full digits")


def main():
    for path in sys.argv[1:]:
        if any(re.match(r"G[01] .*[UVW]", line) for line in open(path)):
            nine(path)
            continue
        want, told = posted(path), command(path)
        if len(want) != len(told):
            raise SystemExit(f"{path}: {len(want)} motions are programmed, rs274 makes {len(told)}")
        worst = worst_feed = 0.0
        for (line, rapid, at, f), (was_rapid, got, rate), before in zip(want, told, [None] + want[:-1]):
            off = max(abs(a - b) for a, b in zip(at, got))
            worst = max(worst, off)
            # It rounds to four decimals.
            if rapid != was_rapid or off > 0.000051:
                raise SystemExit(f"{path}: line {line}: {at} is posted, rs274 goes to {got}")
            if f is not None:
                # Of X Y Z; where these stand still of U V W, else of the rotary axes.
                way = math.dist(at[:3], before[2][:3]) or math.dist(at[6:], before[2][6:]) or math.dist(at[3:6], before[2][3:6])
                off = abs(rate - f * way)
                worst_feed = max(worst_feed, off / rate)
                if off > 0.0002 + 1e-6 * rate:
                    raise SystemExit(f"{path}: line {line}: F{f} over {way} mm, rs274 takes {rate} mm/min")
        full = module(path)
        exact = "not looked at in full digits, its Python module cannot be loaded"
        if full is not None:
            if len(full) != len(want):
                raise SystemExit(f"{path}: {len(want)} motions are programmed, the gcode module makes {len(full)}")
            off = max(abs(a - b) for w, got in zip(want, full) for a, b in zip(w[2], got))
            exact = f"{off:.1e} in full digits"
            if off > 1e-9:
                raise SystemExit(f"{path}: a position differs by {off} in full digits")
        print(f"{path}: {len(want)} motions, largest difference {worst:.6f} of four decimals, {exact}; feeds within {worst_feed:.1e}")


main()
