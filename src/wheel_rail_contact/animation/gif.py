# SPDX-License-Identifier: BSD-3-Clause
"""Writes frames as an animated GIF."""
import numpy as np
from PIL import Image

SAMPLES = 12   # number of frames from which the palette is computed
COLOURS = 256  # of a GIF
SHIFTS = np.array([16, 8, 0], np.uint32)


def _numbers(frame):
    """Colour of each pixel as one number."""
    return (frame.reshape(-1, 3).astype(np.uint32) << SHIFTS).sum(axis=1, dtype=np.uint32)


def _colours(numbers):
    """Inverse of _numbers: red, green, blue."""
    return (numbers[:, None] >> SHIFTS & 255).astype(np.int32)


def _palette(frames):
    """The most frequent colours. Areas keep their exact colours; only the edges of letters and lines are rounded."""
    numbers, counts = np.unique(np.concatenate([_numbers(frame) for frame in frames]), return_counts=True)
    return _colours(numbers[np.argsort(-counts, kind="stable")[:COLOURS]])


def _picture(frame, palette):
    """The frame with the nearest palette colour for each pixel."""
    numbers, pixels = np.unique(_numbers(frame), return_inverse=True)
    distances = ((_colours(numbers)[:, None] - palette) ** 2).sum(axis=2)
    indices = distances.argmin(axis=1).astype(np.uint8)[pixels]
    picture = Image.fromarray(indices.reshape(frame.shape[:2]), "P")
    picture.putpalette(palette.astype(np.uint8).tobytes())
    return picture


def write_gif(path, frames, rate):
    """Writes frames to a file. All frames share one palette, which avoids flicker.

    @param frames arrays (height, width, 3) of bytes
    @param rate frames per second [Hz]
    """
    palette = _palette(frames[::max(1, len(frames) // SAMPLES)])
    pictures = [_picture(frame, palette) for frame in frames]
    pictures[0].save(path, format="GIF", save_all=True, append_images=pictures[1:], duration=round(1000 / rate), loop=0)
