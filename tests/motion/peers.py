"""The fastest motion through given axis positions by toppra (velocity, acceleration) and copp (and jerk), for `cargo bench --bench feed`.

    FEED_SAMPLES=FILE python3 peers.py [toppra] [copp]

Needs `pip install numpy scipy toppra copp-py`. FILE: `#` and velocity, acceleration, jerk of five axes; then rows `s,q1..q5`. Positions are
joined by a natural cubic spline, as ours are. Printed: the motion's time, the time to find it (median of 3), samples a second, and the
greatest share of each limit at the samples and at nine places between any two.
"""

import logging
import os
import sys
import time

import numpy as np
from scipy.interpolate import CubicSpline

logging.disable(logging.CRITICAL)
ROUNDS = 3


def samples():
    name = os.environ["FEED_SAMPLES"]
    with open(name) as f:
        limits = np.array(f.readline().split()[1:], float).reshape(5, 3)
    rows = np.loadtxt(name, delimiter=",", skiprows=1)
    return rows[:, 0], rows[:, 1:], limits


def median(run):
    times, result = [], None
    for _ in range(ROUNDS):
        start = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - start)
    return sorted(times)[ROUNDS // 2], result


def by_toppra(s, q, limits):
    import toppra
    import toppra.algorithm
    import toppra.constraint as constraint

    v, a = limits[:, 0], limits[:, 1]

    def run():
        path = toppra.SplineInterpolator(s, q, bc_type="natural")
        speed = constraint.JointVelocityConstraint(np.stack([-v, v], 1))
        rise = constraint.JointAccelerationConstraint(np.stack([-a, a], 1))
        rise.set_discretization_type(constraint.DiscretizationType.Interpolation)
        found = toppra.algorithm.TOPPRA([speed, rise], path, gridpoints=s, solver_wrapper="seidel", parametrizer="ParametrizeConstAccel")
        return found.compute_parameterization(0, 0)

    seconds, (sdd, sd, *_) = median(run)
    duration = float(np.sum(2 * np.diff(s) / (sd[1:] + sd[:-1])))
    spline, worst = CubicSpline(s, q, bc_type="natural"), np.zeros(2)
    for f in np.linspace(0, 1, 11):
        at = s[:-1] + f * np.diff(s)
        x = (1 - f) * sd[:-1] ** 2 + f * sd[1:] ** 2
        q1, q2 = spline(at, 1), spline(at, 2)
        worst = np.maximum(worst, [(np.abs(q1) * np.sqrt(x)[:, None] / v).max(), (np.abs(q1 * sdd[:, None] + q2 * x[:, None]) / a).max()])
    tell("toppra, velocity, acceleration", len(s), duration, seconds, worst)


def by_copp(s, q, limits, rounds=3):
    """TOPP3 by cones, linearised about the fastest motion within velocity and acceleration and then about its own answers. Derivatives at
    the samples are those of the same spline. In other units, or with an axis that stands still, its solver was seen to fail."""
    import copp_py as copp

    moving = np.ptp(q, axis=0) > 0
    q, limits = q[:, moving], limits[moving]
    spline = CubicSpline(s, q, bc_type="natural")
    n, unit, (v, a, j) = len(s), 100.0, limits.T
    jets = [np.ascontiguousarray(spline(s, k) * unit**k / a) for k in range(4)]

    def run():
        robot = copp.Robot(len(a), capacity=n)
        robot.append_s(np.ascontiguousarray(s / unit))
        robot.set_q(jets[0], jets[1], jets[2], 0, dddq=jets[3])
        robot.add_velocity_limits(v / a, -v / a, start_idx_s=0, length=n)
        robot.add_acceleration_limits(a / a, -a / a, start_idx_s=0, length=n)
        robot.add_jerk_limits(j / a, -j / a, start_idx_s=0, length=n)
        about = copp.solver.topp2_ra.solve(copp.solver.topp2_ra.Problem(robot.constraints, (0, n - 1), (0.0, 0.0)))
        for _ in range(rounds):
            problem = copp.solver.topp3_socp.Problem(robot.constraints, about, idx_s_start=0)
            profile = copp.solver.topp3_socp.solve(problem)
            about = np.asarray(profile.a)
        return copp.interpolation.s_to_t_topp3(s / unit, profile, 0.0), profile

    seconds, (timed, profile) = median(run)
    x, u = np.asarray(profile.a) * unit**2, np.asarray(profile.b) * unit
    worst = np.zeros(3)
    # Between samples u is straight and ṡ² a parabola.
    h = np.diff(s)
    w = np.diff(u) / h
    for f in np.linspace(0.0, 1.0, 11):
        at, d = s[:-1] + f * h, f * h
        xf = np.maximum(x[:-1] + 2 * u[:-1] * d + w * d * d, 0)
        uf = u[:-1] + w * d
        q1, q2, q3 = (spline(at, k) for k in (1, 2, 3))
        root = np.sqrt(xf)
        parts = (
            np.abs(q1) * root[:, None] / v,
            np.abs(q1 * uf[:, None] + q2 * xf[:, None]) / a,
            np.abs(q1 * w[:, None] + 3 * q2 * uf[:, None] + q3 * xf[:, None]) * root[:, None] / j,
        )
        # Near rest it has not the parabolas of these lines.
        worst = np.maximum(worst, [p[20:-20].max() for p in parts])
    tell(f"copp, TOPP3 by SOCP, {rounds} rounds", n, float(timed[0]), seconds, worst)


def tell(name, n, duration, seconds, worst):
    used = " ".join(f"{w:.5f}" for w in worst)
    print(f"{name}: {n} samples, motion of {duration:.4f} s found in {seconds:.4f} s ({n / seconds:.0f} samples a second); limits used to {used}")


if __name__ == "__main__":
    wanted = sys.argv[1:] or ["toppra", "copp"]
    if "toppra" in wanted:
        by_toppra(*samples())
    if "copp" in wanted:
        by_copp(*samples())
