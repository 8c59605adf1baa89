# SPDX-License-Identifier: BSD-3-Clause
"""Text of the study: errors of each contact, and how often the stated model error holds."""
from .results import MODELS

TITLE = ("| place | load [kN] | half_space_ratio | maximum pressure [MPa] | area [mm²] | planar [%] | curved [%] | turned [%] "
         "| lateral shift [µm] |")


def text(rows):
    """Table of all contacts (Markdown). Errors are those of maximum pressure / area against the finite elements."""
    lines = [TITLE, "|---" * 9 + "|"]
    for row in rows:
        errors = " | ".join("{:+.1f} / {:+.1f}".format(*(100 * value for value in row.errors[name])) for name in MODELS)
        lines.append(f"| {row.place}{' (kept out)' if row.kept_out else ''} | {row.load / 1e3:g} | {row.ratio:.2f} | "
                     f"{row.max_pressure / 1e6:.0f} | {row.area * 1e6:.1f} | {errors} | {row.lateral_shift * 1e6:+.1f} |")
    for kept_out, name in ((False, "calibration"), (True, "kept out")):
        own = [row for row in rows if row.kept_out == kept_out]
        if own:
            held = sum(row.error(row.package) <= row.stated for row in own)
            lines.append(f"{name}: the error of the package is within model_error in {held} of {len(own)} contacts")
    return "\n".join(lines)
