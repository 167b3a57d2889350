#!/usr/bin/python3
"""Numbers of the verification book that have no closed form, each found here without the program.

Only the standard library is used. Each block names the case that quotes its numbers and the equation behind them.
"""

from math import atan2, cos, exp, log, pi, prod, sin, sqrt


def bisect(function, low, high):
    """Root of a function that changes its sign between low and high."""
    sign = function(low) > 0
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if (function(middle) > 0) == sign else (low, middle)
    return 0.5 * (low + high)


def runge_kutta(rate, state, time, steps):
    """Classical fourth-order Runge-Kutta from time 0; `rate(state)` returns the derivatives."""
    step = time / steps
    for _ in range(steps):
        k1 = rate(state)
        k2 = rate([s + 0.5 * step * k for s, k in zip(state, k1)])
        k3 = rate([s + 0.5 * step * k for s, k in zip(state, k2)])
        k4 = rate([s + step * k for s, k in zip(state, k3)])
        state = [s + step / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state


def damping_ratio(restitution):
    """Damping ratio of the spring-dashpot that may pull at the end of a contact."""
    return -log(restitution) / sqrt(pi**2 + log(restitution) ** 2)


def damping_ratio_without_tension(restitution):
    """Damping ratio of the spring-dashpot whose contact ends where its force vanishes."""

    def reached(zeta):
        root = sqrt(1 - zeta**2)
        return exp(-zeta / root * (pi - atan2(2 * zeta * root, 1 - 2 * zeta**2))) - restitution

    return bisect(reached, 1e-9, 1 - 1e-9)


def cohesive_contact(mass, stiffness, cohesion, gap, zeta, speed):
    """Speed and duration of a contact entered at `speed`: m x'' = -k_e x - eta x' - k_c (gap - x), x < 0, until x = 0.

    x is the distance of the body surfaces; the dashpot acts until the bodies part (no clipping).
    """
    damping = 2 * zeta * sqrt(mass * stiffness)
    a = -damping / (2 * mass)
    b = sqrt(4 * mass * (stiffness - cohesion) - damping**2) / (2 * mass)
    shift = -cohesion * gap / (stiffness - cohesion)  # rest point of the two springs

    def place(t):
        return shift + exp(a * t) * (-shift * cos(b * t) + (-speed + a * shift) / b * sin(b * t))

    def velocity(t):
        return exp(a * t) * (-speed * cos(b * t) + ((-speed + a * shift) / b * a + shift * b) * sin(b * t))

    end = bisect(place, 0.3 * pi / b, 1.7 * pi / b)
    return velocity(end), end


def cohesive_collision():
    """Case 04, physics of the linear cohesion with an effect distance."""
    mass, stiffness, cohesion, gap, speed = 0.5, 1000.0, 30.0, 0.2, 1.5
    entry = sqrt(speed**2 + cohesion * gap**2 / mass)
    leaving, duration = cohesive_contact(mass, stiffness, cohesion, gap, damping_ratio(0.6), entry)
    print(f"cohesive collision: u_i = {-entry:.12f} u_r = {leaving:.9f} contact time = {duration:.9f}")


def sticking_threshold():
    """Case 05: approach speed at which the particle just comes back to the effect distance."""
    mass, stiffness, gap, restitution = 0.5, 1000.0, 0.2, 0.9
    for cohesion in (1.0, 10.0, 100.0):
        needed = gap * sqrt(cohesion / mass)
        zeta = damping_ratio(restitution)

        def excess(speed):
            entry = sqrt(speed**2 + needed**2)
            return cohesive_contact(mass, stiffness, cohesion, gap, zeta, entry)[0] - needed

        asymptotic = needed * sqrt(1 / restitution**2 - 1)
        exact = bisect(excess, 0.5 * asymptotic, 3 * asymptotic)
        print(f"sticking threshold: k_c/k_e = {cohesion / stiffness:g} u_c = {exact:.12f} of Sy = 1: {asymptotic:.12f}")


def squeezed_pair():
    """Case 12: two spheres squeezed between two walls, damped; heights of the centres at 0.5 and 1 ms."""
    radius, height, stiffness, gravity, restitution = 0.5e-3, 1.8e-3, 1e3, 9.81, 0.8
    volume = 4 / 3 * pi * radius**3
    m1, m2 = 20000 * volume, 10000 * volume
    zeta = damping_ratio(restitution)
    wall1, wall2 = 2 * zeta * sqrt(m1 * stiffness), 2 * zeta * sqrt(m2 * stiffness)
    pair = 2 * zeta * sqrt(m1 * m2 / (m1 + m2) * stiffness)

    def rate(s):
        y1, y2, v1, v2 = s
        below = stiffness * (radius - y1) - wall1 * v1
        above = stiffness * (y2 - height + radius) + wall2 * v2
        between = stiffness * (2 * radius - y2 + y1) - pair * (v2 - v1)
        return [v1, v2, (below - between) / m1 - gravity, (between - above) / m2 - gravity]

    for time in (0.5e-3, 1e-3):
        y1, y2, v1, v2 = runge_kutta(rate, [0.45e-3, 1.35e-3, 0.0, 0.0], time, 20000)
        print(f"squeezed pair, e = 0.8: t = {time:g} y = {y1:.9e} {y2:.9e} v = {v1:.9e} {v2:.9e}")


def schiller_naumann_rate(diameter, density, fluid_density, viscosity):
    """Drag acceleration per slip velocity as a function of the slip speed."""
    mass = density * pi / 6 * diameter**3

    def rate(slip):
        reynolds = fluid_density * abs(slip) * diameter / viscosity
        if reynolds == 0:
            return 3 * pi * viscosity * diameter / mass
        coefficient = 24 / reynolds * (1 + 0.15 * reynolds**0.687) if reynolds < 1000 else 0.44
        return coefficient * pi / 8 * diameter**2 * fluid_density * abs(slip) / mass

    return rate


def settling():
    """Cases 15 and 22: a sphere in rising air, and settling velocities."""
    rate = schiller_naumann_rate(100e-6, 2000, 1.2, 1.8e-5)
    for name, gravity in (("without buoyancy", 9.80665), ("with buoyancy", 9.80665 * (1 - 1.2 / 2000))):
        (velocity,) = runge_kutta(lambda s: [-gravity + rate(0.4 - s[0]) * (0.4 - s[0])], [0.0], 0.35, 35000)
        print(f"rising air {name}: v(0.35 s) = {velocity:.9f}")
    for name, diameter, density, fluid_density, viscosity in (
        ("100 um in air", 100e-6, 2000, 1.2, 1.8e-5),
        ("1 mm glass in water", 1e-3, 2500, 1000, 1e-3),
        ("2.5 mm glass beads in air", 2.5e-3, 2526, 1.2, 1.8e-5),
    ):
        rate = schiller_naumann_rate(diameter, density, fluid_density, viscosity)
        for gravity in (9.80665, 9.81):
            reduced = gravity * (1 - fluid_density / density)
            speed = bisect(lambda v: rate(v) * v - reduced, 1e-6, 100.0)
            print(f"settling, {name}: {speed:.9f} m/s with g = {gravity}")


def oblique_impact(degrees, speed=3.9, steps=40000):
    """Tangential restitution and spin of a sphere on a rigid plane: Hertz, Tsuji's dashpot, Mindlin's tangential spring.

    The tangential force grows by 8 G* a ds, and falls with the radius of contact a while the contact unloads, so that
    no cycle gains energy (Thornton, Cummins and Cleary 2013).
    """
    radius, density, young, poisson, restitution, friction = 0.0025, 4000, 380e9, 0.23, 0.98, 0.092
    mass = density * 4 / 3 * pi * radius**3
    modulus, shear = young / (1 - poisson**2), young / (2 * (1 + poisson) * (2 - poisson))
    damping = damping_ratio(restitution)
    slide, approach, spin = speed * sin(degrees * pi / 180), speed * cos(degrees * pi / 180), 0.0
    start = slide
    deepest = (15 * mass * approach**2 / (16 * modulus * sqrt(radius))) ** 0.4
    step = 2.943 * deepest / approach / steps
    overlap, force, stiffness_before = approach * step / 2, 0.0, 0.0
    while overlap > 0:
        stiffness = 8 * shear * sqrt(radius * overlap)
        dashpot = 2 * sqrt(5 / 6) * damping * sqrt(2 * modulus * sqrt(radius * overlap) * mass)
        normal = 4 / 3 * modulus * sqrt(radius) * overlap**1.5 + dashpot * approach
        force *= min(1.0, stiffness / stiffness_before) if stiffness_before else 1.0
        force -= stiffness * (slide - radius * spin) * step
        limit = max(friction * normal, 0.0)
        force = max(-limit, min(limit, force))
        stiffness_before = stiffness
        approach -= normal / mass * step
        slide += force / mass * step
        spin -= force * radius / (0.4 * mass * radius**2) * step
        overlap += approach * step
    return slide / start, spin


def oblique_impacts():
    """Case 06: impacts that stick for a part of the contact."""
    for degrees in (5, 10, 15, 20, 25, 30):
        restitution, spin = oblique_impact(degrees)
        print(f"oblique impact at {degrees} degrees: e_t = {restitution:.4f}, omega = {spin:.2f} rad/s")


def bonded_sphere_restitution():
    """Case 16: energy that the neck of a JKR contact takes, from its breaking to the next touch, as a speed."""
    radius, work, modulus, density = 5e-6, 0.05, 1e9, 1000.0
    mass = density * 4 / 3 * pi * radius**3

    def force(a):
        return 4 * modulus * a**3 / (3 * radius) - sqrt(8 * pi * work * modulus * a**3)

    def overlap(a):
        return a**2 / radius - sqrt(2 * pi * work * a / modulus)

    smallest = (pi * work * radius**2 / (8 * modulus)) ** (1 / 3)
    touch = (2 * pi * work * radius**2 / modulus) ** (1 / 3)
    n, lost = 200000, 0.0
    for i in range(n):
        a, b = smallest + (touch - smallest) * i / n, smallest + (touch - smallest) * (i + 1) / n
        lost -= 0.5 * (force(a) + force(b)) * (overlap(b) - overlap(a))
    thornton = 1.84 * ((work / radius) ** 5 / (density**3 * modulus**2)) ** (1 / 6)
    print(f"JKR: jump-off overlap {overlap(smallest):.9e} m, energy lost {lost:.9e} J,")
    print(f"     as a speed {sqrt(2 * lost / mass):.9f} m/s, Thornton and Ning {thornton:.9f} m/s")


def resistances_of_ellipsoids():
    """Cases 47, 48 and 83: Oberbeck 1876, resistance along each half axis over that of the sphere of equal volume.

    K_i = 16 pi mu / (chi + alpha_i a_i^2), chi = int dl/D, alpha_i = int dl/((a_i^2 + l) D), l from 0 on,
    D = sqrt((a^2 + l)(b^2 + l)(c^2 + l)); the trapezoidal rule in the logarithm of l.
    """
    for axes in ((2.0, 1.0, 1.0), (3.0, 2.0, 1.0)):
        low, high, n = -60.0, 100.0, 16000
        chi, alpha = 0.0, [0.0, 0.0, 0.0]
        for k in range(n + 1):
            shift = exp(low + (high - low) * k / n)
            weight = shift * (high - low) / n / sqrt(prod(a**2 + shift for a in axes))
            chi += weight
            alpha = [total + weight / (a**2 + shift) for total, a in zip(alpha, axes)]
        radius = prod(axes) ** (1 / 3)
        print(f"ellipsoid {axes}:", *(f"{8 / (3 * radius * (chi + s * a**2)):.10f}" for s, a in zip(alpha, axes)))


def front_of_warmth():
    """90: Schumann 1929, J(x, y) = 1 - e^-y integral of e^-s I0(2 sqrt(y s)) over s from 0 to x, by Simpson's rule."""

    def bessel(z):
        """e^-z I0(z), the mean of e^(z (cos(t) - 1)) over a period."""
        return sum(exp(z * (cos(2 * pi * k / 200) - 1)) for k in range(200)) / 200

    prandtl = 1.8e-5 * 1005 / 0.026
    transfer = (2 + 0.6 * sqrt(1.2 * 5 * 0.002 / 1.8e-5) * prandtl ** (1 / 3)) * 0.026 / 0.002**2 * pi
    x, n = transfer * 0.192 / (1.2 * 5 * 1005), 2000
    for y in (6, 8, 10, 12):
        values = [exp(2 * sqrt(y * s) - y - s) * bessel(2 * sqrt(y * s)) for s in (x * k / n for k in range(n + 1))]
        integral = x / n / 3 * (values[0] + 4 * sum(values[1:-1:2]) + 2 * sum(values[2:-1:2]) + values[-1])
        print(f"front of warmth: x = {x:.5f} y = {y} J = {1 - integral:.6f}")


if __name__ == "__main__":
    cohesive_collision()
    sticking_threshold()
    squeezed_pair()
    settling()
    oblique_impacts()
    bonded_sphere_restitution()
    resistances_of_ellipsoids()
    front_of_warmth()
