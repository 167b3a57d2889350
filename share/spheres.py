"""Draws many spheres as a shaded picture: depth buffer, cast shadows, ambient occlusion. Needs numpy only."""

import numpy as np

NOTHING = np.float32(np.inf)


def view_axes(azimuth, elevation):
    """Unit vectors to the right, up and towards the viewer, for angles in degrees; z points up in the picture."""
    a, e = np.radians([azimuth, elevation])
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.array([right, np.cross(towards, right), towards])


class Camera:
    """A mild perspective onto a box from `low` to `high`, which fills a picture of about `pixels` on its longer side."""

    def __init__(self, low, high, azimuth, elevation, pixels, margin=0.03):
        self.axes = view_axes(azimuth, elevation)
        self.centre = 0.5 * (low + high)
        self.distance = 3.5 * np.linalg.norm(high - low)
        corners = np.array([[(low, high)[k >> a & 1][a] for a in range(3)] for k in range(8)])
        self.scale, self.origin = 1.0, np.zeros(2)
        flat = self.project(corners)[0]
        extent = np.ptp(flat, axis=0)
        self.scale = pixels * (1 - 2 * margin) / extent.max()
        self.origin = flat.min(axis=0) * self.scale - margin * pixels
        self.width, self.height = (np.ceil(extent * self.scale + 2 * margin * pixels)).astype(int)

    def project(self, points):
        """Places in the picture [pixel, y up], depth away from the viewer and magnification [pixel per length]."""
        seen = (points - self.centre) @ self.axes.T
        depth = -seen[:, 2]
        magnification = self.scale / (1 + depth / self.distance)
        return seen[:, :2] * magnification[:, None] - self.origin, depth, magnification

    def positions(self, x, y, depth):
        """The points of space that are seen at places of the picture and depths."""
        shrink = (1 + depth / self.distance) / self.scale
        across, up = (x + self.origin[0]) * shrink, (y + self.origin[1]) * shrink
        return self.centre + across[:, None] * self.axes[0] + up[:, None] * self.axes[1] - depth[:, None] * self.axes[2]


def nearest_spheres(flat, depth, radius, pixel_radius, width, height, budget=2_000_000, shapes=None, view=None):
    """For each pixel the sphere, or the body of `shapes` in it, that is seen (-1: none) and the depth of its surface.
    `view`: the axes of the picture, for shapes.

    They go through in portions: spheres of similar size; shapes, whose surfaces are dear, from the nearest on, and only where
    nothing is seen yet in front of the sphere around them. Within a portion, pixels that lose against a nearer one of it are
    drawn again until the nearest is left.
    """
    buffer = np.full(width * height, NOTHING, dtype=np.float32)
    owner = np.full(width * height, -1, dtype=np.int32)
    order = np.argsort(-pixel_radius) if shapes is None else np.argsort(depth - radius)
    sides = (2 * pixel_radius[order]).astype(int) + 3
    first = 0
    while first < len(order):
        squares = np.maximum.accumulate(sides[first:]) ** 2 * np.arange(1, len(order) - first + 1)
        count = max(1, np.searchsorted(squares, budget if shapes is None else budget // 10, side="right"))
        some, side = order[first : first + count], sides[first : first + count].max()
        first += count
        some = some[np.argsort(-depth[some])]
        corner = np.floor(flat[some] - pixel_radius[some, None]).astype(int)
        steps = np.arange(side)
        column, row = corner[:, 0, None] + steps, corner[:, 1, None] + steps
        x = ((column + 0.5 - flat[some, 0, None]) / pixel_radius[some, None]).astype(np.float32)
        y = ((row + 0.5 - flat[some, 1, None]) / pixel_radius[some, None]).astype(np.float32)
        x[(column < 0) | (column >= width)] = 2
        y[(row < 0) | (row >= height)] = 2
        outside = y[:, :, None] ** 2 + x[:, None, :] ** 2
        which, j, i = np.nonzero(outside < 1)
        place = row[which, j] * width + column[which, i]
        rise = np.sqrt(1 - outside[which, j, i])
        if shapes is not None:
            open_ = depth[some[which]] - radius[some[which]] * rise < buffer[place]
            which, j, i, place = which[open_], j[open_], i[open_], place[open_]
            rise = shapes.heights(some[which], x[which, i].astype(float), y[which, j].astype(float), view)
            hit = ~np.isnan(rise)
            which, place, rise = which[hit], place[hit], rise[hit]
        surface = (depth[some[which]] - radius[some[which]] * rise).astype(np.float32)
        which = some[which].astype(np.int32)
        while len(place):
            nearer = surface < buffer[place]
            place, surface, which = place[nearer], surface[nearer], which[nearer]
            buffer[place] = surface
            owner[place] = which
    return owner.reshape(height, width), buffer.reshape(height, width)


def box_mean(image, half):
    """Mean over squares of 2 half + 1 pixels, the rim repeated."""
    for axis in (0, 1):
        padded = np.pad(image, [(half + 1, half) if a == axis else (0, 0) for a in (0, 1)], mode="edge")
        total = np.cumsum(padded, axis=axis, dtype=np.float64)
        size = image.shape[axis]
        upper = np.take(total, np.arange(2 * half + 1, 2 * half + 1 + size), axis=axis)
        image = ((upper - np.take(total, np.arange(size), axis=axis)) / (2 * half + 1)).astype(np.float32)
    return image


def ambient_occlusion(buffer, covered, reach, pixel_reach):
    """How much of the sky each pixel misses, 0 to 1: how far it lies behind the mean of its surroundings."""
    missing = np.zeros(buffer.shape, dtype=np.float32)
    known = np.where(covered, buffer, 0).astype(np.float32)
    for factor, weight in ((0.8, 0.5), (2.5, 0.5)):
        half = max(1, int(factor * pixel_reach))
        share = box_mean(box_mean(covered.astype(np.float32), half), half)
        mean = box_mean(box_mean(known, half), half) / np.maximum(share, 1e-3)
        missing += weight * np.clip((buffer - mean) / (2 * factor * reach), 0, 1) * np.clip(share, 0, 1)
    return np.where(covered, missing, 0)


class ShadowMap:
    """What the light sees: parallel light from the direction `towards_light`."""

    def __init__(self, points, radius, towards_light, pixels=2200, shapes=None):
        azimuth = np.degrees(np.arctan2(towards_light[1], towards_light[0]))
        self.axes = view_axes(azimuth, np.degrees(np.arcsin(towards_light[2])))
        seen = points @ self.axes.T
        low = (seen[:, :2] - radius[:, None]).min(axis=0)
        high = (seen[:, :2] + radius[:, None]).max(axis=0)
        self.scale = pixels / (high - low).max()
        self.low = low - 4 / self.scale
        self.width, self.height = (np.ceil((high - self.low) * self.scale) + 4).astype(int)
        self.pixel_radius = np.maximum(radius * self.scale, 0.8)
        flat = (seen[:, :2] - self.low) * self.scale
        _, self.buffer = nearest_spheres(
            flat, -seen[:, 2], radius, self.pixel_radius, self.width, self.height, shapes=shapes, view=self.axes
        )

    def shade(self, points, bias, softness, looks):
        """Fraction of the light that is blocked at each point: the mean of `looks` over a disc of `softness` pixels."""
        seen = points @ self.axes.T
        x, y = ((seen[:, :2] - self.low) * self.scale).T
        blocked = np.zeros(len(points), dtype=np.float32)
        for look in range(looks):
            angle, distance = 2.399963 * look, softness * np.sqrt((look + 0.5) / looks)  # a sunflower's seeds
            column = np.clip(x + distance * np.cos(angle), 0, self.width - 1).astype(int)
            row = np.clip(y + distance * np.sin(angle), 0, self.height - 1).astype(int)
            blocked += self.buffer[row, column] < -seen[:, 2] - bias
        return blocked / looks


def shade(camera, points, radius, colours, floor=None, shapes=None):
    """Pictures of the spheres as RGBA in [0, 1], one for each of `colours`, and the depth of what is seen, infinite where
    nothing is; row 0 at the top.

    `shapes`: the bodies in the spheres, or None where they are the spheres themselves (shapes.py).

    `floor`: corners (low, high) of a box on whose bottom the shadows fall, or None.
    """
    flat, depth, magnification = camera.project(points)
    pixel_radius = np.maximum(radius * magnification, 0.8)
    owner, buffer = nearest_spheres(
        flat, depth, radius, pixel_radius, camera.width, camera.height, shapes=shapes, view=camera.axes
    )
    covered = owner >= 0
    rows, columns = np.nonzero(covered)
    seen = owner[rows, columns]
    x, y = columns + 0.5, rows + 0.5

    normal = np.empty((len(seen), 3), dtype=np.float32)
    normal[:, 0] = (x - flat[seen, 0]) / pixel_radius[seen]
    normal[:, 1] = (y - flat[seen, 1]) / pixel_radius[seen]
    normal[:, 2] = np.sqrt(np.clip(1 - normal[:, 0] ** 2 - normal[:, 1] ** 2, 0, 1))
    if shapes is not None:
        rise = (depth[seen] - buffer[rows, columns]) / radius[seen]
        normal = shapes.normals(seen, normal[:, 0].astype(float), normal[:, 1].astype(float), rise, camera.axes)

    light = np.array([-0.42, 0.62, 0.66])
    light /= np.linalg.norm(light)
    middle = light + [0, 0, 1]
    middle /= np.linalg.norm(middle)
    map_of_light = ShadowMap(points, radius, light @ camera.axes, shapes=shapes)
    typical = np.median(radius[seen]) if len(seen) else radius.max()
    softness = 0.35 * np.median(map_of_light.pixel_radius) + 1
    places = camera.positions(x, y, buffer[rows, columns].astype(float))
    lit = 1 - map_of_light.shade(places, 0.35 * typical, softness, looks=12)
    # Soft by nature: every second row and column will do.
    coarse = ambient_occlusion(buffer[::2, ::2], covered[::2, ::2], typical, 0.5 * np.median(pixel_radius))
    missing = coarse[rows // 2, columns // 2]

    direct = np.clip(normal @ light.astype(np.float32), 0, 1)
    sky = 0.5 + 0.5 * normal[:, 1]
    brightness = (0.20 + 0.22 * sky) * (1 - 0.9 * missing) + 0.72 * direct * (0.08 + 0.92 * lit) * (1 - 0.4 * missing)
    brightness *= 0.72 + 0.28 * np.clip(normal[:, 2], 0, 1) ** 0.5  # darker rims keep neighbours apart
    gloss = 0.16 * np.clip(normal @ middle.astype(np.float32), 0, 1) ** 40 * lit
    haze = 0
    if np.ptp(depth) > 0:  # what is far fades
        haze = 0.42 * ((buffer[rows, columns] - depth.min()) / np.ptp(depth)).clip(0, 1)[:, None] ** 1.2

    ground = np.zeros((camera.height, camera.width, 4), dtype=np.float32)
    if floor is not None:
        draw_floor(ground, ~covered, camera, map_of_light, floor, typical)
    pictures = []
    for own in colours:
        # Light adds up in linear intensities; the colours of screens are a power of them.
        colour = (own[seen] ** 2.2 * brightness[:, None] + gloss[:, None]) ** (1 / 2.2)
        picture = ground.copy()
        picture[rows, columns, :3] = np.clip(colour * (1 - haze) + haze, 0, 1)
        picture[rows, columns, 3] = 1
        pictures.append(halved(picture)[::-1])
    return pictures, buffer[1::2, 1::2][::-1]


def draw_floor(picture, free, camera, map_of_light, floor, typical):
    """The bottom of the box with the shadows on it, in the free pixels."""
    low, high = floor
    row, column = np.nonzero(free)
    x, y = column + 0.5, row + 0.5
    # Along a line of sight the height is linear in the depth.
    height = camera.positions(x, y, np.zeros(len(x)))[:, 2]
    slope = (camera.positions(x, y, np.full(len(x), camera.distance))[:, 2] - height) / camera.distance
    places = camera.positions(x, y, (low[2] - height) / slope)
    inside = np.all((places[:, :2] >= low[:2]) & (places[:, :2] <= high[:2]), axis=1)
    softness = 2.0 * np.median(map_of_light.pixel_radius) + 4
    shadow = map_of_light.shade(places[inside], 0.1 * typical, softness, looks=40)
    grey = (0.955 - 0.34 * shadow)[:, None]
    picture[row[inside], column[inside]] = np.concatenate([grey * [0.985, 0.99, 1.0], np.ones_like(grey)], axis=1)


def halved(picture):
    """Every four pixels made one: smooth edges."""
    height, width = picture.shape[0] // 2 * 2, picture.shape[1] // 2 * 2
    blocks = picture[:height, :width].reshape(height // 2, 2, width // 2, 2, 4)
    alpha = blocks[..., 3:].mean(axis=(1, 3))
    colour = (blocks[..., :3] * blocks[..., 3:]).mean(axis=(1, 3)) / np.maximum(alpha, 1e-6)
    return np.concatenate([colour, alpha], axis=2)
