#!/usr/bin/env python3
"""Axis positions beside LinuxCNC's compiled kinematics modules, on random poses.

usage: LINUXCNC_ROOT=DIR/root python3 tests/controls/kinematics.py target/release/examples/axis_positions [POSES]      needs cc

First chains that LinuxCNC has a module for (CHAINS below: two tables, table and head, two heads), each with its blade askew and its axes out of
the origin. A ball centre and a point higher up on the tool axis are both asked for: as the module brings either to its place with the same axis
positions that ours gives, position and direction of the tool agree.

Then the machine without a chain. LinuxCNC has no module for a rotary table about X with a pivoting head, so two are chained: `xyzac-trt-kins` turns the part about X,
`5axiskins` leans the head. Both are shared objects that ask HAL for their pins; a few lines of C stand in for HAL. What has to be
translated between the two worlds: their A turns the workpiece, ours (ISO 841) the tool; their B leans the other way; their pivot length is
that from pivot to ball centre, and their Z is that much less the gauge length lower.
Twice: with the built-in machine, and with one whose axis of rotation, clamping and pivot length are all others."""
import ctypes as C, math, os, random, re, subprocess, sys, tempfile

ROOT = os.environ["LINUXCNC_ROOT"]
HAL = r"""
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
struct pin { char name[100]; double *value; } pins[200]; int count;
static void *make(const char *name) {
    double *v = calloc(2, sizeof *v);
    if (count < 200) { snprintf(pins[count].name, sizeof pins[count].name, "%s", name); pins[count++].value = v; }
    return v;
}
static void *format(const char *fmt, va_list ap) { char b[100]; vsnprintf(b, sizeof b, fmt, ap); return make(b); }
#define PIN(type) \
    int hal_pin_##type##_new(const char *n, int d, void **p, int id) { *p = make(n); return 0; } \
    int hal_pin_##type##_newf(int d, void **p, int id, const char *f, ...) { va_list a; va_start(a, f); *p = format(f, a); va_end(a); return 0; }
PIN(float) PIN(bit) PIN(s32) PIN(u32)
int hal_init(const char *n) { return 1; }
int hal_exit(int i) { return 0; }
int hal_ready(int i) { return 0; }
int hal_unready(int i) { return 0; }
int hal_set_unready(int i) { return 0; }
void *hal_malloc(long n) { return calloc(1, n); }
int hal_param_float_newf(int d, void *p, int id, const char *f, ...) { return 0; }
void rtapi_print(const char *f, ...) {}
void rtapi_print_msg(int l, const char *f, ...) {}
int rtapi_snprintf(char *s, unsigned long n, const char *f, ...) { va_list a; va_start(a, f); int r = vsnprintf(s, n, f, a); va_end(a); return r; }
const char *pin_name(int i) { return i < count ? pins[i].name : 0; }
void set_pin(int i, double v) { *pins[i].value = v; }
"""


class Pose(C.Structure):
    _fields_ = [(n, C.c_double) for n in "xyzabcuvw"]


class Module:
    """One module with its pins."""

    def __init__(self, name, kind=0, **pins):
        folder = tempfile.mkdtemp()
        open(folder + "/hal.c", "w").write(HAL)
        subprocess.check_call(["cc", "-O1", "-w", "-shared", "-fPIC", "-o", folder + "/hal.so", folder + "/hal.c"])
        self.hal = C.CDLL(folder + "/hal.so", mode=C.RTLD_GLOBAL)
        self.hal.pin_name.restype = C.c_char_p
        self.kins = C.CDLL(f"{ROOT}/usr/lib/linuxcnc/modules/{name}.so", mode=os.RTLD_LAZY)
        if self.kins.rtapi_app_main():
            raise SystemExit(f"{name} does not start")
        # Modules made by halcompile make their pins when they are asked for their type.
        self.kins.kinematicsType()
        names = []
        while (n := self.hal.pin_name(len(names))) is not None:
            names.append(n.decode())
        for pin, value in pins.items():
            index = next(i for i, n in enumerate(names) if n.endswith("." + pin.replace("_", "-")))
            self.hal.set_pin(index, C.c_double(value))
        if kind:
            self.kins.kinematicsSwitch(kind)

    def joints(self, *pose):
        p, j = Pose(*pose), (C.c_double * 16)()
        flags = C.c_ulong(0), C.c_ulong(0)
        if self.kins.kinematicsInverse(C.byref(p), j, C.byref(flags[0]), C.byref(flags[1])):
            raise SystemExit(f"the pose {pose} is refused")
        return list(j[:6])


# Module; rotary axes from the workpiece: letter, direction, point; pins; whether the second one carries the tool; kind. Their sense and their points
# are what the modules compute: the tables count the workpiece's own turn, the heads lean the other way about Y.
CHAINS = [
    ("xyzac-trt-kins", [("c", [0, 0, -1], [3.5, -5.25, 0.0]), ("a", [-1, 0, 0], [0.0, -5.25 + 11.0, 7.0 + 13.5])],
     dict(x_rot_point=3.5, y_rot_point=-5.25, z_rot_point=7.0, y_offset=11.0, z_offset=13.5), False, 0),
    ("xyzbc-trt-kins", [("c", [0, 0, -1], [3.5, -5.25, 0.0]), ("b", [0, -1, 0], [3.5 + 11.0, 0.0, 7.0 + 13.5])],
     dict(x_rot_point=3.5, y_rot_point=-5.25, z_rot_point=7.0, x_offset=11.0, z_offset=13.5), False, 0),
    ("xyzab_tdr_kins", [("a", [1, 0, 0], [0.0, -5.25, 7.0 + 13.5]), ("b", [0, 1, 0], [3.5, 0.0, 7.0])],
     dict(x_rot_point=3.5, y_rot_point=-5.25, z_rot_point=7.0, z_offset=13.5), False, 1),
    ("5axiskins", [("c", [0, 0, 1], [0.0, 0.0, 0.0]), ("b", [0, -1, 0], [0.0, 0.0, 180.0])], {}, True, 0),
    ("maxkins", [("c", [0, 0, 1], [0.0, 0.0, 0.0]), ("b", [0, -1, 0], [0.0, 0.0, 180.0])], {}, True, 0),
]
# Order of the axes of each: from the workpiece to the tool.
ORDER = {"5axiskins": "XYZCB", "maxkins": "CXYZB", "xyzac-trt-kins": "CAXYZ", "xyzbc-trt-kins": "CBXYZ", "xyzab_tdr_kins": "ABXYZ"}
# The mount of all of them.
OFFSET, CLAMPING = [12.0, -7.0, 30.0], 33.0


def chain_machine(folder, module, rotary):
    """The machine file of a chain; the blade along the first rotary axis, root to tip."""
    limits = "velocity_{0} = 100.0\nacceleration_{0}2 = 1000.0\njerk_{0}3 = 10000.0\nlimits = \"assumed\"\n"
    along = [abs(v) for v in rotary[0][1]]
    order = ", ".join(f'"{a}"' for a in ORDER[module])
    text = f'name = "{module}"\nswing_diameter_mm = 500.0\nchain = [{order}]\n'
    text += f"[mount]\noffset_mm = {OFFSET}\nclamping_deg = {CLAMPING}\nalong = {[float(v) for v in along]}\n"
    for a in "xyz":
        text += f"[axes.{a}]\nmin_mm = -1000.0\nmax_mm = 1000.0\n" + limits.format("mm_s")
    for letter, direction, point in rotary:
        text += f"[axes.{letter}]\ndirection = {[float(v) for v in direction]}\npoint_mm = {point}\n" + limits.format("deg_s")
    path = folder + f"/{module}.toml"
    open(path, "w").write(text)
    return path, along


def compare_chain(program, count, folder, module, rotary, pins, head, kind):
    import concurrent.futures as pool

    draw, gauge, higher = random.Random(11), 132.5, 90.0
    path, along = chain_machine(folder, module, rotary)
    poses = [[draw.uniform(-150, 150) for _ in range(3)] + [draw.uniform(-3600, 3600), draw.uniform(-80, 80)] for _ in range(count)]
    text = "\n".join(" ".join(repr(v) for v in p) for p in poses) + "\n"
    lines = subprocess.run([program, str(gauge), path], input=text, capture_output=True, text=True, check=True).stdout.splitlines()
    ours = [[float(v) for v in l.split()] for l in lines]
    s, c = math.sin(math.radians(CLAMPING)), math.cos(math.radians(CLAMPING))

    def on_machine(x, y, z):
        y, z = c * y - s * z, s * y + c * z
        # X is brought to Z about Y.
        x, y, z = (-z, y, x) if along[2] else (x, y, z)
        return [OFFSET[0] + x, OFFSET[1] + y, OFFSET[2] + z]

    worst = 0.0
    for up in (0.0, higher):
        asked = []
        for (x, y, z, theta, lean), q in zip(poses, ours):
            t, b = math.radians(theta), math.radians(lean)
            at = [x + up * math.sin(b), y + up * math.cos(b) * math.cos(t), z + up * math.cos(b) * math.sin(t)]
            angles = {letter: q[3 + k] for k, (letter, _, _) in enumerate(rotary)}
            asked.append((*on_machine(*at), *(angles.get(l, 0.0) for l in "abc"), 0.0, 0.0, 0.0))
        own = dict(pins, pivot_length=180.0 + gauge - up) if head else pins
        with pool.ProcessPoolExecutor(1) as one:
            theirs = one.submit(ask, (module, own, asked, kind)).result()
        for p, q, j in zip(poses, ours, theirs):
            # They read the tool's tip, which is our ball centre or the point above it; ours reads the gauge line.
            want = [j[0], j[1], j[2] + gauge - up]
            off = max(abs(a - b) for a, b in zip(q, want))
            worst = max(worst, off)
            if off > 1e-8:
                raise SystemExit(f"{module}, pose {p}, {up} mm up the tool: axes {q}, the module says {want}")
    return worst


def ask(job):
    """Joints of poses by one module, in a process of its own: two HALs do not go together."""
    name, pins, poses, *kind = job
    module = Module(name, *kind, **pins)
    return [module.joints(*p) for p in poses]


def turned_machine(folder):
    """The demo machine with another axis of rotation, clamping, mount and pivot."""
    here = os.path.dirname(os.path.abspath(__file__))
    text = open(here + "/../../models/machines/demo_table_head.toml").read()
    for key, value in [("axis_y_mm", 12.5), ("axis_z_mm", -7.25), ("clamping_deg", 33.0), ("pivot_length_mm", 150.0)]:
        text = re.sub(rf"^{key} = .*$", f"{key} = {value}", text, flags=re.M)
    text = re.sub(r"^offset_mm = .*$", "offset_mm = [1200.0, 4.0, -3.0]", text, flags=re.M)
    path = folder + "/machine.toml"
    open(path, "w").write(text)
    return path


def compare(program, count, machine, offset, clamping, axis, pivot):
    import concurrent.futures as pool

    draw = random.Random(7)
    gauge = 132.5
    poses = [[draw.uniform(-150, 150) for _ in range(3)] + [draw.uniform(-3600, 3600), draw.uniform(-87, 87)] for _ in range(count)]
    text = "\n".join(" ".join(repr(v) for v in p) for p in poses) + "\n"
    args = [program, str(gauge)] + ([machine] if machine else [])
    ours = [[float(v) for v in l.split()] for l in subprocess.run(args, input=text, capture_output=True, text=True, check=True).stdout.splitlines()]
    s, c = math.sin(math.radians(clamping)), math.cos(math.radians(clamping))
    on_table = []
    for (x, y, z, theta, b), q in zip(poses, ours):
        # The part as it is clamped, while A = 0; A of the workpiece is that of the tool backwards.
        on_table.append((offset[0] + x, offset[1] + c * y - s * z, offset[2] + s * y + c * z, -(theta + clamping - 90.0), 0.0, 0.0, 0.0, 0.0, 0.0))
    with pool.ProcessPoolExecutor(1) as one:
        turned = one.submit(ask, ("xyzac-trt-kins", {"y_rot_point": axis[0], "z_rot_point": axis[1]}, on_table)).result()
    tilted = [(j[0], j[1], j[2], 0.0, -p[4], 0.0, 0.0, 0.0, 0.0) for j, p in zip(turned, poses)]
    with pool.ProcessPoolExecutor(1) as one:
        theirs = one.submit(ask, ("5axiskins", {"pivot_length": pivot + gauge}, tilted)).result()
    worst = 0.0
    for p, q, t, head in zip(poses, ours, turned, theirs):
        want = [head[0], head[1], head[2] + gauge, -t[3], p[4]]
        off = max(abs(a - b) for a, b in zip(q, want))
        worst = max(worst, off)
        if off > 1e-8:
            raise SystemExit(f"pose {p}: axes {q}, LinuxCNC's modules say {want}")
    return worst


def main():
    program = os.path.abspath(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    with tempfile.TemporaryDirectory() as folder:
        for module, rotary, pins, head, kind in CHAINS:
            off = compare_chain(program, count, folder, module, rotary, pins, head, kind)
            print(f"{module}: {count} poses, ball centre and tool axis: axis positions differ by at most {off:.1e} mm")
        demo = compare(program, count, None, [1400.0, 0.0, 0.0], 0.0, [0.0, 0.0], 200.0)
        other = compare(program, count, turned_machine(folder), [1200.0, 4.0, -3.0], 33.0, [12.5, -7.25], 150.0)
    print(f"{count} poses on each of two machines: axis positions differ by at most {max(demo, other):.1e} mm or degrees")


main()
