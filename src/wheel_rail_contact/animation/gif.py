# SPDX-License-Identifier: BSD-3-Clause
"""Writes frames as an animated GIF."""
import numpy as np
from PIL import Image

SAMPLES = 12   # frames whose colours make the palette
COLOURS = 256  # of a GIF
SHIFTS = np.array([16, 8, 0], np.uint32)


def _numbers(frame):
    """A number for each pixel's colour."""
    return (frame.reshape(-1, 3).astype(np.uint32) << SHIFTS).sum(axis=1, dtype=np.uint32)


def _colours(numbers):
    return (numbers[:, None] >> SHIFTS & 255).astype(np.int32)


def _palette(frames):
    """The most frequent colours: drawn areas keep theirs exactly, only rims of letters and lines are rounded."""
    numbers, counts = np.unique(np.concatenate([_numbers(frame) for frame in frames]), return_counts=True)
    return _colours(numbers[np.argsort(-counts, kind="stable")[:COLOURS]])


def _picture(frame, palette):
    """The frame with each colour's nearest of the palette."""
    numbers, pixels = np.unique(_numbers(frame), return_inverse=True)
    distances = ((_colours(numbers)[:, None] - palette) ** 2).sum(axis=2)
    indices = distances.argmin(axis=1).astype(np.uint8)[pixels]
    picture = Image.fromarray(indices.reshape(frame.shape[:2]), "P")
    picture.putpalette(palette.astype(np.uint8).tobytes())
    return picture


def write_gif(path, frames, rate):
    """Frames are (height, width, 3) bytes; all share one palette, so that nothing flickers. rate: of the frames [Hz]"""
    palette = _palette(frames[::max(1, len(frames) // SAMPLES)])
    pictures = [_picture(frame, palette) for frame in frames]
    pictures[0].save(path, format="GIF", save_all=True, append_images=pictures[1:], duration=round(1000 / rate), loop=0)
