"""The installed package against the command line tool (its path in BLADEWRIGHT)."""

import csv
import json
import logging
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from importlib.metadata import version
from pathlib import Path

import bladewright
import numpy as np
import pytest

MODELS = Path(__file__).parents[2] / "models"
STEAM_ROOT = MODELS / "steam_root.step"
PRISM = MODELS / "prism.step"
COMMAND = os.environ["BLADEWRIGHT"]
# A coarse path: some thousands of locations instead of a hundred thousand.
QUICK = {"path.scallop_mm": 0.2, "path": {"chord_mm": 0.02}}
# A few turns high over the platform.
SHORT = {"path.scallop_mm": 0.2, "region": {"start_mm": 30, "end_mm": 20}}


def command(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True)


@pytest.fixture(scope="module")
def planned() -> bladewright.Plan:
    return bladewright.plan(STEAM_ROOT, QUICK)


@pytest.fixture(scope="module")
def run_of_command(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("command") / "run"
    keys = ["--set", "path.scallop_mm=0.2", "--set", "path.chord_mm=0.02"]
    ended = command("--quiet", "plan", STEAM_ROOT, "-o", out, *keys)
    assert ended.returncode == 0, ended.stderr
    return out


def table(file: Path) -> dict[str, np.ndarray]:
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.reader(lines))
    return dict(zip(rows[0], np.array(rows[1:], dtype=float).T))


def test_locations_are_those_of_the_command(
    planned: bladewright.Plan, run_of_command: Path
) -> None:
    at, written = planned.cutter_locations, table(run_of_command / "cutter_locations.csv")
    assert len(at) == len(written["s"]) > 1000
    assert len(at) == planned.summary["cutter_locations"]
    plain = {"turn": "turn", "turn_s_mm": "S", "s_mm": "s", "feed_mm_min": "feed_mm_min"}
    for name, column in plain.items():
        np.testing.assert_array_equal(getattr(at, name), written[column], err_msg=name)
    for name, letter in {"centre_mm": "c", "contact_mm": "p", "normal": "n", "axis": "i"}.items():
        columns = np.stack([written[letter + x] for x in "xyz"], axis=1)
        np.testing.assert_array_equal(getattr(at, name), columns, err_msg=name)
    for name in ("theta", "theta_min", "theta_max"):
        ours = np.degrees(getattr(at, name + "_rad"))
        np.testing.assert_allclose(ours, written[name + "_deg"], rtol=0, atol=1e-9)


def test_axes_are_those_of_the_command(planned: bladewright.Plan, run_of_command: Path) -> None:
    axes, written = planned.axes, table(run_of_command / "axes.csv")
    assert axes.names == ("X", "Y", "Z", "A", "B")
    assert axes.units == ("mm", "mm", "mm", "deg", "deg")
    np.testing.assert_array_equal(axes.time_s, written["t_s"])
    for prefix, rows in {"": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}.items():
        columns = np.stack([written[prefix + name] for name in axes.names], axis=1)
        np.testing.assert_array_equal(getattr(axes, rows), columns, err_msg=rows)
    # The feed is the way of the ball over the time that it takes.
    first, n = axes.first_location, len(planned.cutter_locations)
    times = axes.time_s[first : first + n]
    assert times[-1] - times[0] == pytest.approx(planned.time_s)


def test_geometry_holds_together(planned: bladewright.Plan) -> None:
    at = planned.cutter_locations
    for unit in (at.normal, at.axis):
        np.testing.assert_allclose(np.linalg.norm(unit, axis=1), 1, atol=1e-12)
    away = at.centre_mm - at.contact_mm
    radius = np.linalg.norm(away, axis=1)
    np.testing.assert_allclose(radius, radius[0], atol=1e-4)
    assert at.theta_min_rad.shape == at.theta_rad.shape == at.s_mm.shape
    assert (np.diff(at.s_mm) > 0).all() and (np.diff(at.turn) >= 0).all()
    assert not at.centre_mm.flags.writeable
    assert set(at.as_dict()) >= {"centre_mm", "contact_mm", "normal", "axis", "theta_rad", "turn"}


def test_figures_and_checks(planned: bladewright.Plan, run_of_command: Path) -> None:
    written = json.loads((run_of_command / "summary.json").read_text())
    same = {k for k in written if planned.summary[k] == written[k]}
    assert set(written) - same == {"programs"}
    names = {c["name"]: c for c in planned.checks}
    assert planned.passed and names["gouge"]["passed"]
    assert planned.files == [] and "scallop_mm = 0.2" in planned.job
    assert planned.tool.startswith("ball R ")
    assert "passed" in repr(planned) and repr(len(planned.axes)) in repr(planned.axes)


def test_programs_are_those_of_the_command(planned: bladewright.Plan, run_of_command: Path) -> None:
    def moves(text: str) -> list[str]:
        return [line for line in text.splitlines() if not line.lstrip().startswith((";", "("))]

    for control, file in {"siemens": "program.mpf", "linuxcnc": "program.ngc"}.items():
        assert moves(planned.program(control)) == moves((run_of_command / file).read_text())
    post = MODELS / "posts" / "fanuc.toml"
    if post.exists():
        assert moves(planned.program(post)) == moves(planned.program("fanuc"))
    with pytest.raises(bladewright.BladewrightError, match="`okuma` is no control") as raised:
        planned.program("okuma")
    assert raised.value.kind == "Usage" and "heidenhain" in (raised.value.advice or "")


def test_a_folder_is_written_and_verified(tmp_path: Path) -> None:
    out = tmp_path / "run"
    seen: list[tuple[str, int, int]] = []
    settings = {**SHORT, "post.control": ["siemens"]}
    plan = bladewright.plan(str(PRISM), settings, out, progress=lambda *news: seen.append(news))
    assert {"model", "path", "channel"} <= {stage for stage, _, _ in seen}
    assert all(done <= total for _, done, total in seen)
    assert out / "program.mpf" in plan.files and all(file.is_file() for file in plan.files)
    assert plan.summary["programs"][0]["file"] == "program.mpf"
    assert plan.program("siemens") == (out / "program.mpf").read_text()
    report = bladewright.verify(out)
    assert report["passed"] and json.loads((out / "verify.json").read_text())["checks"]
    (out / "program.mpf").write_text(plan.program("siemens").replace("X", "X-", 1))
    report = bladewright.verify(out, threads=1)
    failed = {c["name"] for c in report["checks"] if not c["passed"]}
    assert not report["passed"] and "files" in failed


def test_a_job_file_is_planned(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(f"[model]\nfile = '{PRISM}'\n[path]\nscallop_mm = 0.1\n")
    plan = bladewright.plan(job, {**SHORT, "tool.radius_mm": np.float32(3.0)})
    assert "scallop_mm = 0.2" in plan.job and "radius_mm = 3.0" in plan.job


def test_what_inspect_finds_is_what_the_command_prints() -> None:
    found = bladewright.inspect(STEAM_ROOT)
    printed = command("--json", "inspect", STEAM_ROOT).stdout.splitlines()
    events = [json.loads(line) for line in printed]
    assert found["regions"] == next(e["regions"] for e in events if e["event"] == "regions")
    assert found["text"].splitlines() == [e["text"] for e in events if e["event"] == "output"]
    assert found["closed"] and found["problem"] is None and found["unit"] == "mm"
    low, high = found["box_mm"]
    assert all(a < b for a, b in zip(low, high)) and found["volume_mm3"] > 0


def test_errors_are_the_sentences_of_the_command(tmp_path: Path) -> None:
    broken = tmp_path / "broken.step"
    broken.write_text("ISO-10303-21; nothing else")
    cases = [
        (broken, {}, "InputOutput", 4),
        (tmp_path / "none.step", {}, "InputOutput", 4),
        (PRISM, {"region.start_mm": 1e6}, None, None),
    ]
    for model, settings, kind, code in cases:
        with pytest.raises(bladewright.BladewrightError) as raised:
            bladewright.plan(model, settings)
        e = raised.value
        keys = [word for k, v in settings.items() for word in ("--set", f"{k}={v}")]
        ended = command("--json", "plan", model, "-o", tmp_path / "out", *keys)
        events = [json.loads(line) for line in ended.stdout.splitlines()]
        told = next(event for event in events if event["event"] == "error")
        assert (e.message, e.stage, e.kind) == (told["message"], told["stage"], told["kind"])
        assert (e.advice, e.data, e.exit_code) == (
            told["advice"],
            told["infeasible"],
            ended.returncode,
        )
        assert kind in (None, e.kind) and code in (None, e.exit_code)
        assert e.message in str(e) and str(e).startswith(f"{e.stage}: ")
        again = pickle.loads(pickle.dumps(e))
        assert (str(again), again.data) == (str(e), e.data)


def test_no_plan_has_data() -> None:
    with pytest.raises(bladewright.BladewrightError) as raised:
        bladewright.plan(PRISM, {**SHORT, "tool.radius_mm": 400.0})
    assert raised.value.kind == "Infeasible" and raised.value.exit_code == 3
    assert isinstance(raised.value.data, dict)


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"path.scalop_mm": 1}, "path.scalop_mm: unknown field"),
        ({"scallop_mm": 1}, "the key is a section and a name"),
        ({"path.scallop_mm": "wide"}, "path.scallop_mm: "),
        ({"path.scallop_mm": None}, "NoneType is no value of a job file"),
        ({"post.control": [object()]}, "list is no value of a job file"),
        ({"path.scallop_mm": float("nan")}, "scallop_mm"),
    ],
)
def test_settings_that_make_no_sense(settings: dict[str, object], says: str) -> None:
    with pytest.raises(bladewright.BladewrightError, match=says) as raised:
        bladewright.plan(PRISM, settings)
    assert (raised.value.stage, raised.value.kind) == ("job", "Usage")


def test_wrong_types_are_type_errors() -> None:
    with pytest.raises(TypeError):
        bladewright.plan(3)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        bladewright.plan(PRISM, {1: 2})  # type: ignore[dict-item]
    with pytest.raises(bladewright.BladewrightError, match="threads"):
        bladewright.plan(PRISM, threads=0)


def test_an_exception_of_progress_stops_the_plan() -> None:
    def enough(stage: str, done: int, total: int) -> None:
        if stage == "path":
            raise RuntimeError("enough")

    begun = time.monotonic()
    with pytest.raises(RuntimeError, match="enough"):
        bladewright.plan(STEAM_ROOT, progress=enough)
    assert time.monotonic() - begun < 20


# A shell without job control has what it runs in the background ignore SIGINT.
INTERRUPTED = """
import signal, sys, bladewright
signal.signal(signal.SIGINT, signal.default_int_handler)
def told(stage, done, total):
    print(stage, flush=True)
try:
    bladewright.plan(sys.argv[1], progress=told)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(3)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends no SIGINT to one process")
def test_ctrl_c_stops_the_plan() -> None:
    words = [sys.executable, "-c", INTERRUPTED, str(STEAM_ROOT)]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        while process.stdout.readline().strip() != "path":
            assert process.poll() is None
        process.send_signal(signal.SIGINT)
        rest, _ = process.communicate(timeout=60)
    assert process.returncode == 3 and rest.splitlines()[-1] == "interrupted"


def test_other_threads_run_meanwhile() -> None:
    count, over = 0, threading.Event()

    def counting() -> None:
        nonlocal count
        while not over.wait(0.01):
            count += 1

    thread = threading.Thread(target=counting)
    thread.start()
    begun = time.monotonic()
    try:
        bladewright.plan(PRISM, SHORT)
    finally:
        took = time.monotonic() - begun
        over.set()
        thread.join()
    assert count > took / 0.01 * 0.1


def test_warnings_are_logged_and_kept(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.WARNING, logger="bladewright"):
        # Farther than the axes can follow.
        plan = bladewright.plan(PRISM, {**SHORT, "feed.feed_mm_min": 1e5})
    assert plan.warnings and all({"stage", "message"} <= set(w) for w in plan.warnings)
    assert {f"{w['stage']}: {w['message']}" for w in plan.warnings} <= set(caplog.messages)


def test_a_plan_that_fails_has_a_program_by_force_alone() -> None:
    hard = {**SHORT, "verify.scallop_ratio": 0.05}
    plan = bladewright.plan(PRISM, hard)
    assert not plan.passed
    with pytest.raises(bladewright.BladewrightError, match="fails its checks") as raised:
        plan.program("siemens")
    assert raised.value.kind == "Findings" and raised.value.exit_code == 1
    forced = bladewright.plan(PRISM, hard, force=True)
    assert not forced.passed and "NOT VERIFIED" in forced.program("siemens").upper()


def test_the_version_is_one() -> None:
    assert bladewright.__version__ == version("bladewright")
