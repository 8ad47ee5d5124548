"""Compares the ball on the block (apps/fe/examples/hertz_sphere) with Hertz's solution.

    hertz.py RESULTS.vtkhdf [--within 0.03]

Prints contact force, peak pressure and contact radius with their errors, and the L2 error of the pressure. With
`--within`, the exit status is 1 when peak pressure or radius deviate by more than that share, or the contact force by
more than 1e-6.
"""

import argparse

import numpy as np
from frame import Frame, integral

# A quarter is modelled: two planes of symmetry.
PARTS = 4.0
FORCE_WITHIN = 1e-6


def hertz(force, ball):
    """Contact radius [L] and peak pressure [F/L²] of a ball on a half space of the same material:
    a³ = 3PR/4E*, p0 = 2aE*/πR (Johnson, Contact Mechanics, 1985, §4.2)."""
    modulus = ball.young / (2.0 * (1.0 - ball.poisson**2))
    radius = np.cbrt(3.0 * force * ball.radius / (4.0 * modulus))
    return radius, 2.0 * radius * modulus / (np.pi * ball.radius)


def squared_fit(distance, pressure):
    """Peak p0 and zero a of p² = p0² (1 − r²/a²), by least squares over the given points."""
    columns = np.stack([np.ones_like(distance), distance**2], axis=1)
    (constant, slope), *_ = np.linalg.lstsq(columns, pressure**2, rcond=None)
    return np.sqrt(constant), np.sqrt(-constant / slope)


def contact_radius(distance, pressure):
    """Zero [L] of the fit of p² against r² over the outer third of the contact, the third found by iteration."""
    radius = distance[pressure > 0.0].max()
    for _ in range(20):
        outer = (distance > radius * 2.0 / 3.0) & (distance < radius)
        fitted = squared_fit(distance[outer], pressure[outer])[1]
        if abs(fitted - radius) < 1e-12 * radius:
            break
        radius = fitted
    return radius


def pressure_error(frame, radius, peak):
    """L2 error of the pressure, linear between the corners of faces, over the L2 norm of Hertz's, √(π/2) p0 a."""
    faces = frame.outer_faces(np.isfinite(frame.fields["CPRESS"]))
    corners = frame.fields["CPRESS"][faces[:, :3]]

    def squared(position, shares):
        inside = np.maximum(1.0 - (position[:, 0] ** 2 + position[:, 1] ** 2) / radius**2, 0.0)
        return (corners @ shares - peak * np.sqrt(inside)) ** 2

    return np.sqrt(PARTS * integral(frame.points, faces, squared) / (np.pi / 2.0)) / (peak * radius)


def moment_radius(frame):
    """Radius [L] of the Hertz pressure with the same second moment: a² = (5/2) ∫ p r² dA / ∫ p dA."""
    faces = frame.outer_faces(np.isfinite(frame.fields["CPRESS"]))
    corners = frame.fields["CPRESS"][faces[:, :3]]
    force = integral(frame.points, faces, lambda position, shares: corners @ shares)
    moment = integral(
        frame.points, faces, lambda position, shares: (corners @ shares) * (position[:, :2] ** 2).sum(axis=1)
    )
    return np.sqrt(2.5 * moment / force)


def evaluate(path, ball):
    """Number of nodes, (Hertz, computed) by quantity, L2 error of the pressure."""
    frame = Frame(path)
    points, pressure = frame.points, frame.field("CPRESS")
    across = np.hypot(points[:, 0], points[:, 1])
    secondary = np.isfinite(frame.fields["CPRESS"])
    at_top = np.abs(points[:, 2] - ball.radius) < 1e-9 * ball.radius
    force = PARTS * ball.pressure * integral(points, frame.outer_faces(at_top), lambda *_: 1.0)
    carried = PARTS * frame.field("CNORMF")[secondary, 2].sum()
    radius, peak = hertz(force, ball)
    # Pressures are unknowns of corner nodes; those between are interpolated.
    near = secondary & frame.corners() & (across < 2.0 * radius)
    distance, pressure = across[near], pressure[near]
    fitted = contact_radius(distance, pressure)
    within = distance < fitted
    table = {
        "contact force": (force, carried),
        "peak pressure, fit": (peak, squared_fit(distance[within], pressure[within])[0]),
        "peak pressure, node": (peak, pressure.max()),
        "contact radius, fit": (radius, fitted),
        "contact radius, moment": (radius, moment_radius(frame)),
    }
    return len(points), table, pressure_error(frame, radius, peak)


def parser():
    """The command line; the defaults are those of the example's deck."""
    reader = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    reader.add_argument("results", help="results file, .vtkhdf")
    reader.add_argument("--within", type=float, help="largest relative error of peak pressure and radius")
    reader.add_argument("--radius", type=float, default=10.0, help="radius of the ball [L]")
    reader.add_argument("--young", type=float, default=210000.0, help="Young's modulus of both bodies [F/L²]")
    reader.add_argument("--poisson", type=float, default=0.3, help="Poisson's ratio of both bodies")
    reader.add_argument("--pressure", type=float, default=6.121344, help="pressure on the top of the ball [F/L²]")
    return reader


def main():
    given = parser().parse_args()
    nodes, table, spread = evaluate(given.results, given)
    print(f"{given.results}: {nodes} nodes")
    print(f"{'':24}{'Hertz':>14}{'computed':>14}{'error':>12}")
    worst = False
    for name, (theory, computed) in table.items():
        error = computed / theory - 1.0
        allowed = FORCE_WITHIN if name == "contact force" else given.within
        worst |= given.within is not None and abs(error) > allowed
        print(f"{name:24}{theory:14.6g}{computed:14.6g}{error:12.2e}")
    print(f"{'pressure, L2':52}{spread:12.2e}")
    raise SystemExit(1 if worst else 0)


if __name__ == "__main__":
    main()
