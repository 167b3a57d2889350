"""Spheres along the inside of the drum, staggered from row to row: python3 make_lining.py > lining.csv"""
from math import cos, pi, sin

AROUND, ROWS, WIDTH, RADIUS, SPIN = 170, 4, 0.012, 0.1205, 1.2147

print("x,y,z,wx,wy,wz")
for row in range(ROWS):
    for k in range(AROUND):
        angle = 2 * pi * (k + 0.5 * (row % 2)) / AROUND
        x = WIDTH * ((row + 0.5) / ROWS - 0.5)
        print(f"{x:.6g},{RADIUS * cos(angle):.8g},{RADIUS * sin(angle):.8g},{SPIN},0,0")
