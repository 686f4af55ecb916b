#!/usr/bin/env python3
"""Draws docs/images/study_pareto.svg from two columns, mass [g] and dead-band [deg], with one line of headings:

fusee query out/pnrvsa "SELECT mass_g, dead_band_overdrive_deg FROM designs WHERE dead_band_overdrive_deg IS NOT NULL" |
    docs/images/study_pareto.py >docs/images/study_pareto.svg
"""
import math
import sys

CLASS = ("", ' class="front"')
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 880, 460, 70, 864, 14, 412


def scale(values, low, high):
    """Place of a value between two edges, and the round values of the axis."""
    least, most = min(values), max(values)
    margin = 0.04 * (most - least)
    least, most = least - margin, most + margin
    step = 10.0 ** math.floor(math.log10(most - least))
    step = next(step * share for share in (0.2, 0.5, 1.0, 2.0) if (most - least) / (step * share) <= 8)
    ticks = [step * n for n in range(math.ceil(least / step), math.floor(most / step) + 1)]
    return (lambda v: low + (v - least) / (most - least) * (high - low)), ticks


points = sorted({tuple(map(float, line.split("\t"))) for line in list(sys.stdin)[1:]})
if not points:
    sys.exit("no designs: two columns with one line of headings are expected on standard input")
x, x_ticks = scale([p[0] for p in points], LEFT, RIGHT)
y, y_ticks = scale([p[1] for p in points], BOTTOM, TOP)
front, best = set(), math.inf
for point in points:  # by mass
    if point[1] < best:
        best = point[1]
        front.add(point)

print(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
      'aria-label="dead-band at overdrive torque over the mass of both cams"><style>text{font:12px sans-serif;fill:#444}.rule{stroke:#ddd}'
      'circle{fill:#2a78d6;opacity:.4}circle.front{fill:#d95f27;opacity:1}</style>'
      f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>')
for tick in x_ticks:
    print(f'<line x1="{x(tick):.2f}" x2="{x(tick):.2f}" y1="{TOP}" y2="{BOTTOM}" class="rule"/>'
          f'<text x="{x(tick):.2f}" y="{BOTTOM + 18}" text-anchor="middle">{tick:g}</text>')
for tick in y_ticks:
    print(f'<line x1="{LEFT}" x2="{RIGHT}" y1="{y(tick):.2f}" y2="{y(tick):.2f}" class="rule"/>'
          f'<text x="{LEFT - 8}" y="{y(tick) + 4:.2f}" text-anchor="end">{tick:g}</text>')
for point in sorted(points, key=lambda p: p in front):
    print(f'<circle cx="{x(point[0]):.2f}" cy="{y(point[1]):.2f}" r="3.5"{CLASS[point in front]}/>')
print(f'<text x="{(LEFT + RIGHT) / 2:.0f}" y="{HEIGHT - 8}" text-anchor="middle">mass of both cams [g]</text>'
      f'<text x="16" y="{(TOP + BOTTOM) / 2:.0f}" text-anchor="middle" transform="rotate(-90 16 {(TOP + BOTTOM) / 2:.0f})">'
      'dead-band at overdrive torque [deg]</text></svg>')
