#!/usr/bin/env python3
"""nc-gcode-interpreter (PyPI) as a reader of Siemens programs.

usage: python3 tests/controls/siemens.py PROGRAM.mpf ...      needs `pip install nc-gcode-interpreter`

It reads TRAORI, ORIAXES, CYCLE832, COMPOF, G93, SUPA and A=IC(...), not A3= B3= C3=: lines with vectors are read without them, and that is said. Nor does it
know A=DC(...) and A=AC(...), which are read as the positions that they name, nor POLY: PO[X]=(end, ...) under G91 is read as the step X=IC(end), so ends of polynomials are compared, and their coefficients left out.
Nor does it know spindles by number (S1=6000 M1=3): lines of them alone are left out.
Every position X, Y, Z and the rotary axes is compared with the words of the text. A word that it does not know it takes for the call of a
subprogram: what it took so is listed, and only the names below may be in it. Its releases for Python 3.11 and older count in single
precision, steps of A added up; the words of the text are then rounded and added up the same, so that the comparison stays as sharp."""
import re, struct, sys
from importlib.metadata import version

import nc_gcode_interpreter as nc

# Words of the 840D that this interpreter has no meaning for.
CALLS = {"TRAORI", "TRAFOOF", "CYCLE832", "COMPOF", "ORIWKS", "ORIAXES", "SOFT", "FFWON", "SUPA", "UPATH", "SPATH", "POLY",
         "RTLION", "FGROUP", "CTOL", "WAITM"}
# Axes, those of a second head too.
AXES = "XYZABCUVW"


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def posted(text, count):
    at, out, vectors = dict.fromkeys(AXES, 0.0), [], 0
    for line in text.splitlines():
        code = line.split(";")[0]
        moved = False
        for letter, step, value in re.findall(r"(?<![A-Z0-9])([XYZABCUVW])=?(IC\()?([-+]?\d+\.\d+)\)?", code):
            at[letter] = count(count(float(value)) + (at[letter] if step else 0.0))
            moved = True
        vectors += "A3=" in code
        if moved:
            out.append(dict(at))
    return out, vectors


def main():
    for path in sys.argv[1:]:
        text = re.sub(r"PO\[([XYZABC])\]=\(([-+0-9.]+)[^)]*\)", r"\1=IC(\2)", open(path).read())
        text, ways = re.subn(r"=[DA]C\(([-+0-9.]+)\)", r"=\1", text)
        # Spindles by number: S1=6000 M1=3.
        text = re.sub(r"^(?:N\d+ )?(?:[SM]\d=\d+ ?)+$", "", text, flags=re.M)
        polynomials = text.count("G91 G93 POLY")
        text = text.replace("G91 G93 POLY", "G93 POLY")
        bare = re.sub(r" [ABC]3=\S+", "", text)
        frame, _ = nc.nc_to_dataframe(bare, extra_axes=list("ABCUVW"), iteration_limit=10**9)
        columns = set(frame.columns)
        got = {c: frame[c].to_list() for c in AXES if c in columns}
        short = version("nc-gcode-interpreter").startswith("0.1.")
        want, vectors = posted(text, single if short else float)
        rows = [i for i in range(frame.height) if any(got[c][i] is not None for c in got)]
        state, last = dict.fromkeys(AXES, 0.0), []
        for i in rows:
            now = {c: got[c][i] if c in got and got[c][i] is not None else state[c] for c in AXES}
            if now != state or not last:
                last.append(now)
            state = now
        calls = set()
        if "non_returning_function_call" in columns:
            for c in frame["non_returning_function_call"].to_list():
                calls |= {re.sub(r"\(.*", "", str(w)) for w in (c if isinstance(c, list) else [c]) if w}
        if calls - CALLS:
            raise SystemExit(f"{path}: words that are not understood: {sorted(calls - CALLS)}")
        distinct = [w for k, w in enumerate(want) if k == 0 or w != want[k - 1]]
        if len(distinct) != len(last):
            raise SystemExit(f"{path}: {len(distinct)} places are programmed, {len(last)} are read")
        off = max(abs(a[c] - b[c]) for a, b in zip(distinct, last) for c in AXES)
        if off > 1e-6:
            raise SystemExit(f"{path}: a position is read {off} mm or degrees off")
        without = f", {vectors} lines without their vectors" if vectors else ""
        without += ", DC() and AC() as positions" if ways else ""
        without += ", polynomials without their coefficients" if polynomials else ""
        reader = f"nc-gcode-interpreter {version('nc-gcode-interpreter')}{' (single precision)' if short else ''}"
        print(f"{path}: {len(last)} places read by {reader}, largest difference {off:.1e}{without}")


main()
