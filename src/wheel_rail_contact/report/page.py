# SPDX-License-Identifier: BSD-3-Clause
"""Page of the report: one HTML file that contains its pictures."""
import base64
import html

import numpy as np

from ..message_constants import SIDES, STATUSES, USABLE
from .loops import loop_of, loops
from .results import WHEEL_FIELDS, has_friction

MOST_LOOPS = 50  # largest number of loops that are listed

STYLE = """body { font: 15px/1.45 sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: 0.6em 0 } td, th { padding: 0.2em 0.8em; border: 1px solid #ccc; text-align: right }
td:first-child, th:first-child { text-align: left } img { max-width: 100% }
pre { background: #f4f4f4; padding: 0.8em; overflow-x: auto }"""


def _table(head, rows):
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"
    return "<table>" + line(head, "th") + "".join(line(row, "td") for row in rows) + "</table>"


def _shown(item, caption):
    """HTML of an item: a picture (path), or a sentence (str) instead of a picture."""
    if isinstance(item, str):
        return f"<p>{html.escape(item)}</p>"
    return _image(item, caption)


def _image(path, caption):
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'


def _quantities(results, side):
    """Title, values, their results, scale and number of digits of each quantity of a side."""
    chosen = np.flatnonzero(results.patches["side"] == side)
    of_patch = results.patches["result"][chosen]
    for name, unit, scale, digits in (("max_pressure", "MPa", 1e-6, 0), ("contact_angle", "°", 180 / np.pi, 1),
                                      ("normal_force", "kN", 1e-3, 1), ("approach", "µm", 1e6, 1)):
        yield f"{name} [{unit}]", results.patches[name][chosen], of_patch, scale, digits
    for body in ("wheel", "rail"):
        values = results.patches[f"{body}_stress.von_mises.value"]
        if values.any():  # otherwise not computed
            yield f"von Mises stress in the {body} [MPa]", values[chosen], of_patch, 1e-6, 0
    forces = [("vertical_force", "Q"), ("lateral_force", "Y")]
    if has_friction(results):
        forces.append(("friction_lateral_force", "Y by friction"))
        yield "adhesion_share [-]", results.patches["creep.adhesion_share"][chosen], of_patch, 1, 2
        yield "power of friction [kW]", results.patches["creep.power"][chosen], of_patch, 1e-3, 2
    for name, symbol in forces:
        known = np.flatnonzero(np.isfinite(results.wheel[:, side, 0]))
        yield f"{symbol} of the wheel [kN]", results.wheel[known, side, WHEEL_FIELDS.index(name)], known, 1e-3, 1


def extremes(results):
    """Rows of the table of extreme values: quantity, value, stamp [s], x [m], y [mm], and the loop if there are several. The
    value is the one with the largest magnitude, with its sign."""
    rows, several = [], len(loops(results.stamp)) > 1
    sides = [list(_quantities(results, side)) for side in (0, 1)]
    for pair in zip(*sides):
        for side, (title, values, result_of, scale, digits) in enumerate(pair):
            if len(values):
                worst = int(np.abs(values).argmax())
                result = int(result_of[worst])
                rows.append((f"{title}, {SIDES[side]}", f"{scale * values[worst]:.{digits}f}", f"{results.stamp[result]:.3f}",
                             f"{results.x[result]:.3f}", f"{1e3 * results.y[result]:.2f}",
                             *([loop_of(results.stamp, result)] if several else [])))
    return rows


def _loops(results):
    """Paragraph and table of the loops; empty if there is only one."""
    pieces = loops(results.stamp)
    if len(pieces) == 1:
        return []
    rows = [(k, f"{results.stamp[piece][0]:.3f}", f"{results.stamp[piece][-1]:.3f}", piece.stop - piece.start)
            for k, piece in enumerate(pieces[:MOST_LOOPS], 1)]
    rest = f" The first {MOST_LOOPS} are listed." if len(pieces) > MOST_LOOPS else ""
    return [f"<p>The recording has {len(pieces)} loops: its stamps go back {len(pieces) - 1} times.{rest}</p>",
            _table(("loop", "from [s]", "to [s]", "results"), rows)]


def _statuses(results):
    counts = np.bincount(results.status, minlength=len(STATUSES))
    return [(STATUSES[s], n, f"{100 * n / len(results.status):.2f} %") for s, n in enumerate(counts) if n]


def _reasons(results):
    most = sorted(results.reasons.items(), key=lambda item: -item[1][0])[:20]
    return [(f"{STATUSES[status]}: {text}", number) for (status, _), (number, text) in most]


def _methods(results):
    methods = results.patches["method"]
    return [(m, int((methods == m).sum()), f"{100 * np.median(results.patches['error_estimate'][methods == m]):.2f} %")
            for m in sorted(set(methods))]


def write(path, title, results, pictures, other_title=None):
    """Writes the page.

    @param pictures list of (heading, items); an item is the path of a picture, or a sentence instead of it
    """
    several = (np.diff(results.stamp) < 0).any()
    usable = int(np.isin(results.status, USABLE).sum())
    parts = [f"<h1>{html.escape(title)}</h1>",
             f"<p>{len(results.status)} results from {results.stamp.min():.3f} s to {results.stamp.max():.3f} s, "
             f"{usable} of them usable.</p>", *_loops(results)]
    if other_title:
        parts.append(f"<p>Dashed: {html.escape(other_title)}.</p>")
    parts += [_table(("status", "results", "share"), _statuses(results))]
    if results.reasons:
        head = "reason, with the numbers of the first result", "results"
        parts += ["<h2>Refusals and remarks</h2>", _table(head, _reasons(results))]
    parts += ["<h2>Extreme values</h2>", _table(("quantity", "value", "time [s]", "x [m]", "y [mm]", "loop")[:6 if several else 5],
                                                extremes(results))]
    for heading, images in pictures:
        parts += [f"<h2>{html.escape(heading)}</h2>", *(_shown(image, heading) for image in images)]
    parts += ["<h2>Methods</h2>", _table(("method", "patches", "median of the estimated error"), _methods(results))]
    if results.parameters:
        parts += ["<h2>Parameters</h2>", f"<pre>{html.escape(results.parameters)}</pre>"]
    path.write_text(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
                    f"<style>{STYLE}</style></head>\n<body>\n" + "\n".join(parts) + "\n</body></html>\n", encoding="utf-8")
